using System;
using System.Collections.Generic;
using System.Diagnostics.Tracing;
using System.Threading;

namespace Alate.Benchmarks;

/// <summary>
/// Hears from the just-in-time compiler which calls it has left in the methods that it compiles while this listens, and why.
/// </summary>
internal sealed class InliningListener : EventListener
{
    private const string k_Runtime = "Microsoft-Windows-DotNETRuntime";
    private const EventKeywords k_JitTracing = (EventKeywords)0x1000;

    private readonly Dictionary<string, int> m_Calls = [];
    private volatile int m_Events;

    /// <summary>"Caller calls callee: reason", with how often.</summary>
    public IReadOnlyDictionary<string, int> Calls => m_Calls;

    /// <summary>Events come from another thread: waits until there have been none for a while.</summary>
    public void Settle()
    {
        for (int before = -1; before != m_Events;)
        {
            before = m_Events;
            Thread.Sleep(150);
        }
    }

    protected override void OnEventSourceCreated(EventSource source)
    {
        if (source.Name == k_Runtime)
            EnableEvents(source, EventLevel.Verbose, k_JitTracing);
    }

    protected override void OnEventWritten(EventWrittenEventArgs e)
    {
        m_Events++;
        if (e.EventName?.StartsWith("MethodJitInliningFailed", StringComparison.Ordinal) != true)
            return;
        string caller = Text(e, "MethodBeingCompiledNamespace"), callee = Text(e, "InlineeNamespace");
        if (!HotCode.IsHot(caller) || !HotCode.IsElementary(callee))
            return;
        string call = $"{caller}.{Text(e, "MethodBeingCompiledName")} calls {callee}.{Text(e, "InlineeName")}: {Text(e, "FailReason")}";
        lock (m_Calls)
            m_Calls[call] = m_Calls.GetValueOrDefault(call) + 1;
    }

    private static string Text(EventWrittenEventArgs e, string name) => (string)e.Payload[e.PayloadNames.IndexOf(name)];
}
