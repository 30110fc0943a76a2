using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Alate.Mutations.Sources;
using NUnit.Framework.Interfaces;

namespace Alate.Mutations.Trials;

/// <summary>Reports each test that has ended, its time and the mutants it met; and what comes before a test: its class's set-up.</summary>
internal sealed class Listener(int group, bool records, Action<TestReport> report) : ITestListener
{
    private double m_Before = Now;

    public bool HasFailed { get; private set; }

    private static double Now => Process.GetCurrentProcess().TotalProcessorTime.TotalSeconds;

    public void TestStarted(ITest test)
    {
        if (!test.IsSuite)
            Report(TestReport.SetUp, test.FullName, null);
    }

    public void TestFinished(ITestResult result)
    {
        // A suite fails with its tests; what is left is its own set-up or tear-down.
        bool own = !result.Test.IsSuite || result.ResultState.Site is FailureSite.SetUp or FailureSite.TearDown;
        if (!own)
            return;
        bool failed = result.ResultState.Status == TestStatus.Failed;
        if (result.Test.IsSuite && !failed)
            return;
        Report(TestReport.Test, result.Test.FullName, failed ? FirstLine(result.Message) : null);
        HasFailed |= failed;
    }

    public void TestOutput(TestOutput output)
    {
    }

    public void SendMessage(TestMessage message)
    {
    }

    private void Report(string what, string name, string failure)
    {
        double now = Now;
        SortedSet<int> hits = records ? TakeHits() : null;
        report(new TestReport
        {
            Event = what,
            Group = group,
            Name = name,
            Failed = failure != null,
            Message = failure,
            Seconds = now - m_Before,
            Hits = hits?.ToArray(),
            Once = hits == null ? null : Once(hits),
        });
        m_Before = now;
    }

    private static string FirstLine(string message) => (message ?? "").Trim().Split('\n')[0];

    private static int[] Once(IEnumerable<int> hits)
    {
        bool[][] once = Fields<bool[]>("Once").ToArray();
        return hits.Where(mutant => once.Any(own => mutant < own.Length && own[mutant])).ToArray();
    }

    /// <summary>A field of the switch of each assembly that has one.</summary>
    private static IEnumerable<T> Fields<T>(string field) where T : class => AppDomain.CurrentDomain.GetAssemblies()
        .Where(assembly => assembly.GetName().Name.StartsWith("Alate", StringComparison.Ordinal))
        .Select(assembly => assembly.GetType(MutantSwitch.Name(assembly.GetName().Name))?.GetField(field)?.GetValue(null) as T)
        .Where(value => value != null);

    /// <summary>Numbers of the mutants met since the last time, here and in processes that have ended.</summary>
    private static SortedSet<int> TakeHits()
    {
        var hits = new SortedSet<int>();
        foreach (byte[] met in Fields<byte[]>("Hits"))
        {
            for (int i = 0; i < met.Length; i++)
            {
                if (met[i] != 0)
                    hits.Add(i);
                met[i] = 0;
            }
        }

        string file = Environment.GetEnvironmentVariable(MutantSwitch.HitsVariable);
        if (File.Exists(file))
        {
            hits.UnionWith(File.ReadLines(file).Select(int.Parse));
            File.Delete(file);
        }

        return hits;
    }
}
