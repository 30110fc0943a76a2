using System;
using System.Diagnostics;
using System.Globalization;
using Unity.StandIns;

namespace UnityEngine;

public class Debug
{
    public static bool isDebugBuild => true;

    public static void Log(object message) => Write(LogType.Log, message, null);
    public static void Log(object message, Object context) => Write(LogType.Log, message, context);
    public static void LogFormat(string format, params object[] args) => Write(LogType.Log, Filled(format, args), null);
    public static void LogFormat(Object context, string format, params object[] args) => Write(LogType.Log, Filled(format, args), context);

    public static void LogWarning(object message) => Write(LogType.Warning, message, null);
    public static void LogWarning(object message, Object context) => Write(LogType.Warning, message, context);
    public static void LogWarningFormat(string format, params object[] args) => Write(LogType.Warning, Filled(format, args), null);
    public static void LogWarningFormat(Object context, string format, params object[] args) =>
        Write(LogType.Warning, Filled(format, args), context);

    public static void LogError(object message) => Write(LogType.Error, message, null);
    public static void LogError(object message, Object context) => Write(LogType.Error, message, context);
    public static void LogErrorFormat(string format, params object[] args) => Write(LogType.Error, Filled(format, args), null);
    public static void LogErrorFormat(Object context, string format, params object[] args) =>
        Write(LogType.Error, Filled(format, args), context);

    public static void LogException(Exception exception) => LogException(exception, null);

    public static void LogException(Exception exception, Object context) =>
        LogChannel.Send($"{exception.GetType().Name}: {exception.Message}", exception.StackTrace ?? "", LogType.Exception, context);

    [Conditional("UNITY_ASSERTIONS")]
    public static void LogAssertion(object message) => Write(LogType.Assert, message, null);

    [Conditional("UNITY_ASSERTIONS")]
    public static void LogAssertion(object message, Object context) => Write(LogType.Assert, message, context);

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition) => Assert(condition, "Assertion failed");

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition, string message) => Assert(condition, message, null);

    [Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition, string message, Object context)
    {
        if (!condition)
            Write(LogType.Assert, message, context);
    }

    public static void DrawLine(Vector3 start, Vector3 end, Color color)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir, Color color)
    {
    }

    private static string Filled(string format, object[] args) => string.Format(CultureInfo.InvariantCulture, format, args);

    private static void Write(LogType type, object message, Object context)
    {
        string text = message switch
        {
            null => "Null",
            IFormattable f => f.ToString(null, CultureInfo.InvariantCulture),
            _ => message.ToString(),
        };
        LogChannel.Send(text, "", type, context);
    }
}
