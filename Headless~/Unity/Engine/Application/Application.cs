using System;
using System.Threading;
using Unity.StandIns;

namespace UnityEngine;

public class Application
{
    public delegate void LogCallback(string condition, string stackTrace, LogType type);

    public static event Action quitting;
    public static event LogCallback logMessageReceived;
    public static event LogCallback logMessageReceivedThreaded;

    public static bool isPlaying { get; internal set; }
    public static bool isEditor => true;
    public static bool isBatchMode => true;
    public static bool isFocused => true;
    public static int targetFrameRate { get; set; } = -1;
    public static bool runInBackground { get; set; } = true;
    public static RuntimePlatform platform => RuntimePlatform.LinuxEditor;
    public static string unityVersion => "2022.3.0f1";
    public static string dataPath => Environment.CurrentDirectory;
    public static string temporaryCachePath => System.IO.Path.GetTempPath();

    public static CancellationToken exitCancellationToken => s_Exit.Token;

    private static CancellationTokenSource s_Exit = new();

    public static bool IsPlaying(Object obj)
    {
        if (obj == null)
            throw new ArgumentNullException(nameof(obj));
        return isPlaying;
    }

    internal static void Receive(in LogRecord record)
    {
        logMessageReceivedThreaded?.Invoke(record.Message, record.StackTrace, record.Type);
        if (MainThread.IsCurrent)
            logMessageReceived?.Invoke(record.Message, record.StackTrace, record.Type);
    }

    internal static void BeginPlaying()
    {
        isPlaying = true;
        s_Exit = new CancellationTokenSource();
    }

    internal static void Quitting()
    {
        quitting?.Invoke();
        s_Exit.Cancel();
    }
}
