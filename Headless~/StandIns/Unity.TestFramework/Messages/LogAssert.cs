using System;
using System.Text.RegularExpressions;
using StandIns;
using Unity.StandIns;

namespace UnityEngine.TestTools;

/// <summary>Says which messages a test expects; an error or exception that it does not expect fails it.</summary>
public static class LogAssert
{
    /// <summary>Lets the running test log what it likes.</summary>
    public static bool ignoreFailingMessages
    {
        get => Log.IgnoreFailures;
        set => Log.IgnoreFailures = value;
    }

    private static TestLog Log => TestSession.Logs
        ?? throw new InvalidOperationException($"No test is running, or its assembly lacks [assembly: {nameof(PlayerTestsAttribute)}].");

    public static void Expect(LogType type, string message) => Log.Expect(new ExpectedMessage(type, message, null));

    public static void Expect(LogType type, Regex message) => Log.Expect(new ExpectedMessage(type, null, message));

    public static void NoUnexpectedReceived() => Log.CheckAll();
}
