using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using Alate.Mutations.Sources;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;

namespace Alate.Mutations.Trials;

/// <summary>
/// A process that runs groups of tests, one mutant alive in it, and stops at the first that fails; or runs them all and records which
/// mutants each test meets.
/// </summary>
internal static class Worker
{
    /// <param name="planFile">JSON of a list of <see cref="TestGroup"/>.</param>
    /// <param name="reportFile">File to which a line of JSON a report is added.</param>
    public static int Run(string planFile, string reportFile)
    {
        List<TestGroup> plan = JsonSerializer.Deserialize<List<TestGroup>>(File.ReadAllText(planFile));
        using var report = new StreamWriter(reportFile) { AutoFlush = true };
        bool records = Environment.GetEnvironmentVariable(MutantSwitch.HitsVariable) != null;
        Console.SetOut(TextWriter.Null);
        Console.SetError(TextWriter.Null);
        for (int i = 0; i < plan.Count; i++)
        {
            Write(report, new TestReport { Event = TestReport.Begin, Group = i });
            var listener = new Listener(i, records, one => Write(report, one));
            Run(plan[i], listener, records);
            if (listener.HasFailed && !records)
                break;
        }

        Write(report, new TestReport { Event = TestReport.Done, Group = plan.Count - 1 });
        return 0;
    }

    /// <summary>Classes of tests of an assembly that are tried, by their names.</summary>
    public static IEnumerable<string> Classes(string assembly)
    {
        var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
        return Leaves(runner.Load(Assembly.Load(assembly), Settings(null, false)))
            .Where(IsTried).Select(test => test.TypeInfo.FullName).Distinct();
    }

    private static void Run(TestGroup group, Listener listener, bool records)
    {
        var assembly = Assembly.Load(group.Assembly);
        var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
        // Beside the class what surrounds all tests of the assembly.
        string[] types = assembly.GetTypes().Where(type => type.IsDefined(typeof(NUnit.Framework.SetUpFixtureAttribute), false))
            .Select(type => type.FullName).Append(group.Type).ToArray();
        ITest suite = runner.Load(assembly, Settings(types, !records));
        var names = group.Tests?.ToHashSet();
        IEnumerable<ITest> chosen = Leaves(suite)
            .Where(test => test.TypeInfo?.FullName == group.Type && IsTried(test) && (names == null || names.Contains(test.FullName)));
        runner.Run(listener, new Chosen(chosen));
    }

    private static Dictionary<string, object> Settings(string[] types, bool stops)
    {
        var settings = new Dictionary<string, object>
        {
            ["NumberOfTestWorkers"] = 0,
            // What a test meets is asked for between it and the next.
            ["SynchronousEvents"] = true,
            ["RunOnMainThread"] = true,
            ["StopOnError"] = stops,
            ["RandomSeed"] = 1,
        };
        if (types != null)
            settings["LOAD"] = types.ToList();
        return settings;
    }

    private static void Write(TextWriter report, TestReport one) => report.WriteLine(JsonSerializer.Serialize(one));

    private static IEnumerable<ITest> Leaves(ITest test) => test.HasChildren ? test.Tests.SelectMany(Leaves) : test.IsSuite ? [] : [test];

    /// <summary>
    /// Returns true for a test of the plain run, neither Long nor explicit, and for one of the category Faults, which that run leaves out
    /// for its length alone. A test that says neither is as its class.
    /// </summary>
    private static bool IsTried(ITest test)
    {
        for (ITest around = test; around != null; around = around.Parent)
        {
            if (around.Properties["Category"].Contains("Faults"))
                return true;
            if (around.RunState is RunState.Explicit || around.Properties["Category"].Contains("Long"))
                return false;
        }

        return true;
    }

    /// <summary>Tests, and all suites that they are in.</summary>
    private sealed class Chosen : ITestFilter
    {
        private readonly HashSet<string> m_Ids = [];

        public Chosen(IEnumerable<ITest> tests)
        {
            foreach (ITest test in tests)
            {
                for (ITest around = test; around != null; around = around.Parent)
                    m_Ids.Add(around.Id);
            }
        }

        public bool Pass(ITest test) => m_Ids.Contains(test.Id);

        public bool IsExplicitMatch(ITest test) => Pass(test);

        public TNode ToXml(bool recursive) => AddToXml(new TNode("filter"), recursive);

        public TNode AddToXml(TNode parentNode, bool recursive) => parentNode;
    }
}
