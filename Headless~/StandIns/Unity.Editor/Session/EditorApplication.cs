using System;
using System.Diagnostics;
using StandIns;

namespace UnityEditor;

public sealed class EditorApplication
{
    public delegate void CallbackFunction();

    private static readonly Stopwatch s_Watch = Stopwatch.StartNew();

    public static CallbackFunction update;
    public static CallbackFunction delayCall;

    public static event Action<PlayModeStateChange> playModeStateChanged
    {
        add => RunningEditor.PlayModeChanged += value;
        remove => RunningEditor.PlayModeChanged -= value;
    }

    public static event Action hierarchyChanged
    {
        add { }
        remove { }
    }

    public static event Action projectChanged
    {
        add { }
        remove { }
    }

    public static bool isPlaying { get; set; }
    public static bool isPaused { get; set; }
    public static bool isPlayingOrWillChangePlaymode { get; }
    public static bool isCompiling { get; }
    public static bool isUpdating { get; }
    public static string applicationPath => RunningEditor.Path;
    public static string applicationContentsPath => RunningEditor.Contents;
    public static double timeSinceStartup => RunningEditor.Seconds ?? s_Watch.Elapsed.TotalSeconds;

    public static void Exit(int returnValue) => RunningEditor.ExitCode = returnValue;
    public static void QueuePlayerLoopUpdate() => throw Absent.Editor;
    public static bool ExecuteMenuItem(string menuItemPath) => RunningEditor.MenuItem?.Invoke(menuItemPath) ?? throw Absent.Editor;
    public static void EnterPlaymode() => isPlaying = true;
    public static void ExitPlaymode() => isPlaying = false;
    public static void RepaintHierarchyWindow() => throw Absent.Editor;
}
