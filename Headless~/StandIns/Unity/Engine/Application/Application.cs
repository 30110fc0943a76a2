using System;
using Unity.StandIns;

namespace UnityEngine;

public class Application
{
    public delegate void LogCallback(string condition, string stackTrace, LogType type);

    public static event LogCallback logMessageReceived;
    public static event LogCallback logMessageReceivedThreaded;
    public static event Action quitting;

    public static bool isPlaying => PlayerLoop.IsPlaying;
    public static bool isEditor => !BuiltPlayer.IsRunning;
    public static bool isBatchMode => true;
    public static bool isFocused => true;
    public static bool isMobilePlatform => false;
    public static int targetFrameRate { get; set; } = -1;
    public static bool runInBackground { get; set; } = true;
    public static RuntimePlatform platform => RuntimePlatform.LinuxEditor;
    public static string persistentDataPath =>
        System.IO.Path.Combine(System.IO.Path.GetTempPath(), $"alate-player-{Environment.ProcessId}");
    public static string unityVersion => "2022.3.0f1";

    public static string dataPath => System.IO.Path.Combine(Environment.CurrentDirectory, "Assets");

    /// <summary>Does nothing: a test ends its player.</summary>
    public static void Quit()
    {
    }

    /// <summary>Returns true where an object is part of the playing world.</summary>
    public static bool IsPlaying(Object obj) => isPlaying && obj != null;

    internal static void Report(string text, string stackTrace, LogType type)
    {
        logMessageReceived?.Invoke(text, stackTrace, type);
        logMessageReceivedThreaded?.Invoke(text, stackTrace, type);
    }

    internal static void ReportQuitting() => quitting?.Invoke();

    /// <summary>Managed listeners go with the domain.</summary>
    internal static void ForgetListeners() => quitting = null;
}
