using System;
using System.IO;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.StandIns;

/// <summary>Where Debug writes to: the console, and whoever listens.</summary>
[StandInExtension]
public static class PlayerLog
{
    private static readonly object s_Gate = new();

    /// <summary>Every line, on the thread that wrote it.</summary>
    public static event Action<LogRecord> Written;

    /// <summary>Where errors, warnings and messages are printed; null for nowhere.</summary>
    public static TextWriter Output { get; set; } = Console.Error;

    internal static void Write(LogType type, string message, Object context, Exception exception = null)
    {
        string trace = exception != null ? exception.StackTrace ?? "" : type == LogType.Log ? "" : Environment.StackTrace;
        var record = new LogRecord(type, message, trace, context, exception);
        lock (s_Gate)
            Output?.WriteLine(type == LogType.Log ? message : $"{type}: {message}");
        Written?.Invoke(record);
        Application.Receive(record);
    }
}
