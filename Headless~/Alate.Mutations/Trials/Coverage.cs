using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;

namespace Alate.Mutations.Trials;

/// <summary>Which test meets which mutants, and how long it computes: one run of all tests with no mutant alive.</summary>
internal sealed class Coverage
{
    /// <summary>Tests that compute longer than this are run behind the others of their class, seconds.</summary>
    private const double k_Slow = 0.5;

    /// <summary>
    /// Tests that compare with numbers which the program printed once: they run last, and what they alone find is counted apart.
    /// </summary>
    private static readonly string[] s_Golden =
        ["Alate.Tests.Determinism.SceneHashTests", "Alate.Tests.Catalogue.AppearanceTests"];

    private readonly List<TestClass> m_Classes = [];
    private readonly HashSet<int> m_Once = [];
    private readonly Func<int, string, bool> m_IsBeside;

    private Coverage(Func<int, string, bool> isBeside) => m_IsBeside = isBeside;

    /// <summary>Tests that fail with no mutant alive; no mutant is tried on them.</summary>
    public HashSet<string> Failing { get; } = [];

    public int Tests => m_Classes.Sum(one => one.Tests.Count);

    public double Seconds => m_Classes.Sum(one => one.SetUp + one.Tests.Values.Sum(test => test.Seconds));

    /// <summary>Runs the tests of assemblies, in two processes.</summary>
    /// <param name="assemblies">Names of the assemblies.</param>
    /// <param name="worker">Makes a process.</param>
    /// <param name="isBeside">
    /// Returns true where a class, of a full name, holds the tests of a mutant's room; they are tried on what is made once a process, which
    /// only the first test meets that asks for it. Null tries only that one.
    /// </param>
    public static Coverage Record(string[] assemblies, Func<WorkerProcess> worker, Func<int, string, bool> isBeside = null)
    {
        var coverage = new Coverage(isBeside);
        var groups = assemblies
            .SelectMany(assembly => worker().Classes(assembly).Select(type => new TestGroup(assembly, type, null))).ToList();
        Parallel.For(0, 2, half =>
        {
            var own = groups.Where((_, i) => i % 2 == half).ToList();
            if (own.Count == 0)
                return;
            WorkerProcess process = worker();
            List<TestReport> reports = process.Run(own, null, 0, true);
            if (process.Ended != null)
            {
                string type = own[reports.LastOrDefault()?.Group ?? 0].Type;
                throw new InvalidOperationException($"The tests did not come to their end: {process.Ended}, in {type}.");
            }

            lock (coverage)
                coverage.Add(own, reports);
        });
        return coverage;
    }

    /// <summary>Returns true for a test that compares with numbers which the program printed once.</summary>
    public static bool IsGolden(string test) => Array.Exists(s_Golden, golden => test.StartsWith(golden, StringComparison.Ordinal));

    /// <summary>
    /// Groups of the tests that meet a mutant and the processor time of each, quickest first; behind them those of the same classes, which
    /// may read what a test before them has made.
    /// </summary>
    public List<(TestGroup Group, double Seconds)> Reaching(int mutant)
    {
        var groups = new List<(TestGroup Group, double Seconds, bool Meets)>();
        foreach (TestClass one in m_Classes)
        {
            bool all = one.Always.Contains(mutant) || m_Once.Contains(mutant) && m_IsBeside?.Invoke(mutant, one.Type) == true;
            if (!all && !one.Tests.Any(test => test.Value.Hits.Contains(mutant)))
                continue;
            foreach (IGrouping<(bool Meets, bool IsSlow), KeyValuePair<string, (double Seconds, HashSet<int> Hits)>> part
                in one.Tests.Where(test => !Failing.Contains(test.Key))
                    .GroupBy(test => (Meets: all || test.Value.Hits.Contains(mutant), IsSlow: test.Value.Seconds > k_Slow)))
            {
                var group = new TestGroup(one.Assembly, one.Type, part.Select(test => test.Key).ToList());
                groups.Add((group, one.SetUp + part.Sum(test => test.Value.Seconds), part.Key.Meets));
            }
        }

        return groups.OrderBy(group => IsGolden(group.Group.Type)).ThenBy(group => !group.Meets).ThenBy(group => group.Seconds)
            .Select(group => (group.Group, group.Seconds)).ToList();
    }

    private void Add(List<TestGroup> groups, List<TestReport> reports)
    {
        foreach (IGrouping<int, TestReport> group in reports.GroupBy(report => report.Group))
        {
            var one = new TestClass(groups[group.Key].Assembly, groups[group.Key].Type);
            m_Classes.Add(one);
            foreach (TestReport report in group)
            {
                if (report.Failed)
                    Failing.Add(report.Name);
                m_Once.UnionWith(report.Once ?? []);
                if (report.Event == TestReport.SetUp)
                {
                    one.SetUp += report.Seconds;
                    one.Always.UnionWith(report.Hits);
                }
                else if (report.Event == TestReport.Test)
                {
                    // Cases of a source may share a name: what meets one of them is tried on all.
                    (double seconds, HashSet<int> hits) = one.Tests.GetValueOrDefault(report.Name, (0, []));
                    one.Tests[report.Name] = (seconds + report.Seconds, [.. hits, .. report.Hits]);
                }
            }
        }
    }

    private sealed record TestClass(string Assembly, string Type)
    {
        /// <summary>Processor time of what runs before the tests.</summary>
        public double SetUp { get; set; }

        /// <summary>Mutants that the set-up meets: all tests stand on it.</summary>
        public HashSet<int> Always { get; } = [];

        public Dictionary<string, (double Seconds, HashSet<int> Hits)> Tests { get; } = [];
    }
}
