using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Alate.Mutations.Sources;
using Alate.Mutations.Trials;

namespace Alate.Mutations;

/// <summary>One run: draws mutants, builds them all behind a switch in a copy of the checkout, and tries each.</summary>
internal static class MutationRun
{
    private const string k_Tests = "Headless~/Alate.Headless.Tests/bin/Debug/net10.0";

    public static void Of(Options options, string root)
    {
        string scratch = Directory.CreateTempSubdirectory("alate-mutants-").FullName;
        try
        {
            Run(options, root, scratch);
        }
        finally
        {
            Directory.Delete(scratch, true);
        }
    }

    /// <summary>Mutants of the rooms that were asked for, by the outermost room, in the order of their places.</summary>
    public static IEnumerable<(string Room, Mutant Mutant)> Candidates(IEnumerable<Project> projects, string root, Func<string, bool> asks)
    {
        foreach (Project project in projects)
        {
            foreach (Microsoft.CodeAnalysis.SyntaxTree tree in project.Compilation.SyntaxTrees)
            {
                string file = Path.GetRelativePath(root, tree.FilePath).Replace('\\', '/');
                if (Rooms.Of(file) is not { } room || !asks(room))
                    continue;
                foreach (Mutant mutant in Mutant.Of(project, tree, file))
                    yield return (room.Split('/')[0], mutant);
            }
        }
    }

    /// <summary>Draws mutants and writes their assemblies; what the compiler refuses is replaced by the next of its room.</summary>
    public static List<(string Room, Mutant Mutant)> Build(Sample sample, int count, IEnumerable<Project> projects, string folder)
    {
        var drawn = sample.Draw(count).SelectMany(room => room.Value.Select(mutant => (Room: room.Key, Mutant: mutant))).ToList();
        var left = new HashSet<Project>(projects);
        while (left.Count > 0)
        {
            var refused = new ConcurrentBag<int>();
            Parallel.ForEach(left.ToList(), new ParallelOptions { MaxDegreeOfParallelism = 2 }, project =>
            {
                var own = drawn.Select((one, i) => (one.Mutant, Number: i + 1)).Where(one => one.Mutant?.Project == project)
                    .ToDictionary(one => one.Number, one => one.Mutant);
                foreach (int number in own.Where(one => one.Value.Sites.Count == 0).Select(one => one.Key).DefaultIfEmpty()
                    .Concat(MutatedAssembly.Emit(project, own, folder)).Where(number => number > 0))
                {
                    refused.Add(number);
                }
            });
            left.Clear();
            foreach (int number in refused.Distinct().Order())
            {
                (string room, Mutant mutant) = drawn[number - 1];
                left.Add(mutant.Project);
                Mutant next = sample.Next(room);
                drawn[number - 1] = (room, next);
                if (next != null)
                    left.Add(next.Project);
            }
        }

        return drawn;
    }

    private static void Run(Options options, string root, string scratch)
    {
        var watch = Stopwatch.StartNew();
        void Say(string what) => Console.WriteLine($"{watch.Elapsed:mm\\:ss}  {what}");
        Say($"seed {options.Seed}");
        Shell.CopyTree(root, Path.Combine(root, k_Tests), scratch);
        string bin = Path.Combine(scratch, k_Tests);
        File.Copy(typeof(MutationRun).Assembly.Location, Path.Combine(bin, "Alate.Mutations.dll"), true);

        var projects = Project.Read(ProjectFiles(root), scratch).ToList();
        var candidates = Candidates(projects, root, options.Asks).ToList();
        if (candidates.Count == 0)
            throw new FormatException($"No room begins with {string.Join(" or ", options.Rooms)}.");
        Say($"{candidates.Count} possible mutants");
        List<(string Room, Mutant Mutant)> drawn = Build(new Sample(candidates, options.Seed), options.Count, projects, bin);
        Say($"{drawn.Count(one => one.Mutant != null)} mutants built");

        WorkerProcess Worker() => new(bin, "Alate.Headless.Tests", scratch);
        ILookup<string, string> folders = TestFolders(root);
        var coverage = Coverage.Record(["Alate.Tests", "Alate.Headless.Tests"], Worker,
            (mutant, type) => folders[type.Split('.', '+')[^1]].Contains(drawn[mutant - 1].Room.Split('/')[^1]));
        Say($"{coverage.Tests} tests take {coverage.Seconds:0} s of processor time");

        if (options.Reach)
        {
            Console.WriteLine(Report.Unmet(drawn.Select((one, i) => (one.Mutant, IsMet: coverage.Reaching(i + 1).Count > 0))
                .Where(one => one.Mutant != null).Select(one => (one.Mutant.File, one.Mutant.Line, one.IsMet))));
            return;
        }

        var trial = new Trial(coverage, Worker);
        Verdict[] verdicts = Try(drawn, trial, new Equivalents(Path.Combine(AppContext.BaseDirectory, "Equivalents.txt")), Say);
        var report = new Report(drawn.Select((one, i) => (one.Room, one.Mutant, verdicts[i])).Where(one => one.Mutant != null).ToList());
        foreach (string test in coverage.Failing.Concat(trial.Unsteady))
            Console.WriteLine($"left out: {test}");
        if (options.Found)
            Console.WriteLine($"\nFound:\n{report.List(Outcome.Found)}");
        Console.WriteLine($"\nFound by held numbers alone:\n{report.List(Outcome.FoundByNumber)}");
        Console.WriteLine($"\nEquivalent:\n{report.List(Outcome.Equivalent)}");
        Console.WriteLine($"\nNot reached:\n{report.List(Outcome.NotReached)}");
        Console.WriteLine($"\nSurvived:\n{report.List(Outcome.Survived)}");
        Console.WriteLine(report.Table());
        Say("done");
        if (options.Write)
            report.Write(Path.Combine(root, "CONTRIBUTING.md"), $"Seed {options.Seed}, {watch.Elapsed.TotalMinutes:0} minutes:");
    }

    private static Verdict[] Try(List<(string Room, Mutant Mutant)> drawn, Trial trial, Equivalents equivalents, Action<string> say)
    {
        var verdicts = new Verdict[drawn.Count];
        int done = 0;
        // Two at a time, each mutant when it is its turn.
        Parallel.ForEach(Partitioner.Create(Enumerable.Range(0, drawn.Count), EnumerablePartitionerOptions.NoBuffering),
            new ParallelOptions { MaxDegreeOfParallelism = 2 }, i =>
            {
                Mutant mutant = drawn[i].Mutant;
                if (mutant == null)
                    return;
                verdicts[i] = equivalents.Reason(mutant) is { } reason ? new Verdict(Outcome.Equivalent, reason) : trial.Of(i + 1);
                int count = Interlocked.Increment(ref done);
                lock (verdicts)
                    say($"{count}  {verdicts[i].Outcome}  {mutant.File}:{mutant.Line}  {mutant.Title}  {verdicts[i].How}");
            });
        return verdicts;
    }

    /// <summary>Folders in which the classes of tests stand, by the classes' names.</summary>
    private static ILookup<string, string> TestFolders(string root) => new[] { "Tests", "Headless~/Alate.Headless.Tests" }
        .SelectMany(tests => Directory.EnumerateFiles(Path.Combine(root, tests), "*.cs", SearchOption.AllDirectories))
        .SelectMany(file => Path.GetRelativePath(root, file).Split(Path.DirectorySeparatorChar)[..^1]
            .Select(folder => (Class: Path.GetFileNameWithoutExtension(file), Folder: folder)))
        .ToLookup(file => file.Class, file => file.Folder);

    /// <summary>Projects whose sources may be changed: the package and the command line.</summary>
    private static IEnumerable<string> ProjectFiles(string root) => Directory
        .EnumerateFiles(Path.Combine(root, "Headless~"), "*.csproj", SearchOption.AllDirectories)
        .Where(file => Path.GetRelativePath(root, file).Split(Path.DirectorySeparatorChar).Length == 3)
        .Where(file => !new[] { "Tests", "Samples", "Benchmarks", "Mutations", "FakeEditor" }
            .Any(Path.GetFileNameWithoutExtension(file).EndsWith))
        .OrderBy(file => file, StringComparer.Ordinal);
}
