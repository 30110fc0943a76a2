using System;
using System.Collections.Generic;
using System.Linq;

namespace Alate.Mutations.Trials;

/// <summary>
/// Tries mutants on the tests that meet them. A test that finds one must pass in the company of the tests that ran before it: once it is
/// run there with no mutant alive.
/// </summary>
internal sealed class Trial(Coverage coverage, Func<WorkerProcess> worker)
{
    private readonly HashSet<string> m_Steady = [], m_Unsteady = [];

    /// <summary>Tests, and classes whose own set-up or tear-down, that fail in their company with no mutant alive.</summary>
    public IReadOnlyCollection<string> Unsteady => m_Unsteady;

    public Verdict Of(int mutant)
    {
        while (true)
        {
            var groups = coverage.Reaching(mutant).Select(group => (Group: Without(group.Group), group.Seconds))
                .Where(group => group.Group.Tests.Count > 0).ToList();
            if (groups.Count == 0)
                return new Verdict(Outcome.NotReached, "");
            WorkerProcess process = worker();
            List<TestReport> reports =
                process.Run(groups.ConvertAll(group => group.Group), groups.ConvertAll(group => group.Seconds), mutant, false);
            TestReport failed = reports.Find(report => report.Failed);
            if (failed == null)
            {
                return process.Ended == null
                    ? new Verdict(Outcome.Survived, "")
                    : new Verdict(Outcome.Found, $"{process.Ended}, {Last(groups, reports)}");
            }

            if (IsSteady(failed, groups.Take(failed.Group + 1).Select(group => group.Group).ToList()))
            {
                Outcome found = Coverage.IsGolden(failed.Name) ? Outcome.FoundByNumber : Outcome.Found;
                return new Verdict(found, $"{failed.Name}: {failed.Message}");
            }
        }
    }

    private static string Last(List<(TestGroup Group, double Seconds)> groups, List<TestReport> reports) =>
        reports.Count == 0 ? "before the first test" : groups[reports[^1].Group].Group.Type;

    private TestGroup Without(TestGroup group)
    {
        lock (m_Steady)
        {
            return group with
            {
                Tests = m_Unsteady.Contains(group.Type) ? [] : group.Tests.Where(test => !m_Unsteady.Contains(test)).ToList(),
            };
        }
    }

    private bool IsSteady(TestReport failed, List<TestGroup> groups)
    {
        lock (m_Steady)
        {
            if (m_Steady.Contains(failed.Name))
                return true;
        }

        bool steady = !worker().Run(groups, null, 0, false).Exists(report => report.Name == failed.Name && report.Failed);
        lock (m_Steady)
            (steady ? m_Steady : m_Unsteady).Add(failed.Name);
        return steady;
    }
}
