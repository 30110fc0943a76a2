using System;
using System.Diagnostics;
using System.Globalization;
using Unity.StandIns;

namespace UnityEngine;

public class Debug
{
    public static bool isDebugBuild => true;

    public static void Log(object message) => PlayerLog.Write(LogType.Log, Text(message), null);
    public static void Log(object message, Object context) => PlayerLog.Write(LogType.Log, Text(message), context);
    public static void LogWarning(object message) => PlayerLog.Write(LogType.Warning, Text(message), null);
    public static void LogWarning(object message, Object context) => PlayerLog.Write(LogType.Warning, Text(message), context);
    public static void LogError(object message) => PlayerLog.Write(LogType.Error, Text(message), null);
    public static void LogError(object message, Object context) => PlayerLog.Write(LogType.Error, Text(message), context);
    public static void LogException(Exception exception) => LogException(exception, null);

    public static void LogException(Exception exception, Object context)
    {
        exception ??= new ArgumentNullException(nameof(exception));
        PlayerLog.Write(LogType.Exception, $"{exception.GetType().Name}: {exception.Message}", context, exception);
    }

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition) => Assert(condition, (object)"Assertion failed");

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition, object message) => Assert(condition, message, null);

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition, string message) => Assert(condition, (object)message, null);

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition, object message, Object context)
    {
        if (!condition)
            PlayerLog.Write(LogType.Assert, Text(message), context);
    }

    public static void DrawLine(Vector3 start, Vector3 end)
    {
    }

    public static void DrawLine(Vector3 start, Vector3 end, Color color)
    {
    }

    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir, Color color)
    {
    }

    private static string Text(object message) => message switch
    {
        null => "Null",
        IFormattable formattable => formattable.ToString(null, CultureInfo.InvariantCulture),
        _ => message.ToString(),
    };
}
