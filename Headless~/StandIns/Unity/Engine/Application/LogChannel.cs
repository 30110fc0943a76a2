using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.StandIns;

/// <summary>Channel of all messages to their listeners; without listeners, warnings and worse go to stderr.</summary>
[StandInExtension]
public static class LogChannel
{
    /// <summary>A message: its text, stack trace, kind, and the object that it is about or null.</summary>
    public delegate void Listener(string text, string stackTrace, LogType type, Object context);

    private static readonly object s_Gate = new();

    /// <summary>Hears each message, on the thread that logs it.</summary>
    public static event Listener Received;

    internal static void Send(string text, string stackTrace, LogType type, Object context)
    {
        lock (s_Gate)
        {
            if (Received == null && type != LogType.Log)
                Console.Error.WriteLine(stackTrace.Length > 0 ? $"{type}: {text}\n{stackTrace}" : $"{type}: {text}");
            Received?.Invoke(text, stackTrace, type, context);
            Application.Report(text, stackTrace, type);
        }
    }
}
