using System;
using System.Collections.Generic;
using UnityEditor;

namespace StandIns;

/// <summary>The program that this process takes for the editor, and the code with which it was asked to end.</summary>
public static class RunningEditor
{
    /// <summary>Path of the program.</summary>
    public static string Path { get; set; } = "";

    /// <summary>Folder of its data.</summary>
    public static string Contents { get; set; } = "";

    /// <summary>Code of <c>EditorApplication.Exit</c>; null before it is called.</summary>
    public static int? ExitCode { get; set; }

    /// <summary>Time since the start, seconds; null takes that of this process.</summary>
    public static double? Seconds { get; set; }

    /// <summary>Items of menus that code chooses: false where there is none. Null where there is no menu at all.</summary>
    public static Func<string, bool> MenuItem { get; set; }

    /// <summary>Paths of scenes that were opened or saved.</summary>
    public static List<string> Scenes { get; } = [];

    /// <summary>Builds a player, and says how many errors there were. Null where none can be built.</summary>
    public static Func<BuildPlayerOptions, int> BuildPlayer { get; set; }

    internal static Action<PlayModeStateChange> PlayModeChanged { get; set; }

    /// <summary>Tells all who listen that play begins or ends; nothing else happens.</summary>
    public static void Tell(PlayModeStateChange change) => PlayModeChanged?.Invoke(change);
}
