using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.StandIns;

/// <summary>Messages logged during a test, checked against the expected ones. Expected messages must come in their order.</summary>
internal sealed class TestLog
{
    private readonly object _gate = new();
    private readonly List<LoggedMessage> _received = [];
    private readonly Queue<ExpectedMessage> _expected = new();

    /// <summary>Also warnings and plain messages must be expected.</summary>
    public bool MustExpectAll { get; set; }

    public bool IgnoreFailures { get; set; }

    public void Begin() => LogChannel.Received += Receive;

    public void End() => LogChannel.Received -= Receive;

    public void Expect(ExpectedMessage message)
    {
        lock (_gate)
            _expected.Enqueue(message);
    }

    /// <summary>Fails at an error, assertion or exception that is not expected; called at the end of each frame and test.</summary>
    public void CheckFailures() => Check(MustExpectAll);

    /// <summary>Fails at any message that is not expected.</summary>
    public void CheckAll() => Check(true);

    /// <summary>Fails if an expected message has not come.</summary>
    public void CheckExpected()
    {
        lock (_gate)
        {
            Match();
            if (_expected.Count > 0)
                throw new AssertionException($"Expected log did not appear: {_expected.Peek()}");
        }
    }

    private void Check(bool all)
    {
        lock (_gate)
        {
            Match();
            int failing = _received.FindIndex(m => all || (m.IsFailure && !IgnoreFailures));
            if (failing < 0)
                return;
            LoggedMessage message = _received[failing];
            _received.Clear();
            throw new AssertionException(
                $"Unhandled log message: '{message}'. Use UnityEngine.TestTools.LogAssert.Expect\n{message.StackTrace}");
        }
    }

    private void Match()
    {
        for (int i = 0; i < _received.Count && _expected.Count > 0; i++)
        {
            if (!_expected.Peek().Matches(_received[i]))
                continue;
            _expected.Dequeue();
            _received.RemoveAt(i--);
        }
    }

    private void Receive(string text, string stackTrace, LogType type, Object context)
    {
        lock (_gate)
            _received.Add(new LoggedMessage(type, text, stackTrace));
    }
}
