using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>study FILE</c>: flies an insect at many values of its numbers, on any number of processes and machines.</summary>
internal static class StudyCommand
{
    private const string k_Table = "study.csv", k_Parquet = "study.parquet", k_Effects = "effects.svg", k_Front = "pareto.svg",
        k_Shares = "sensitivity.csv", k_Search = "search.svg", k_Slurm = "study.sbatch", k_Kubernetes = "study.yaml";

    /// <summary>Fewest runs for which more than one process pays.</summary>
    private const int k_Few = 100;

    public static Command Create(TextWriter output)
    {
        var file = new Argument<string>("FILE") { Description = $"The study, a file NAME{StudyFile.Ending}." };
        var shard = new Option<string>("--shard")
        {
            HelpName = "I/N",
            Description = "Flies the I-th of N parts alone, and writes no tables: for clusters. 'study merge' joins the parts.",
        };
        Option<int?> workers = Numbers.OptionalCount(
            "--workers", "N", 1, 1024, "Processes side by side. [default: one for each core]");
        Option<int?> slurm = Numbers.OptionalCount(
            "--slurm", "N", 1, StudyScripts.MostJobs, "Flies nothing, and writes study.sbatch, an array of N jobs of Slurm."),
            kubernetes = Numbers.OptionalCount(
                "--kubernetes", "N", 1, StudyScripts.MostJobs, "Flies nothing, and writes study.yaml, an indexed job of N of Kubernetes.");
        Option<string> folder = Out();
        var command = new Command("study", "Flies an insect at many values of its numbers: tables, effects, compromises, sensitivities.")
        {
            file, shard, workers, slurm, kubernetes, folder,
        };
        command.Subcommands.Add(CreateMerge(output));
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            StudyWorkers.EndWithParent();
            string path = parsed.GetValue(file);
            StudyPlan plan = Read(path);
            string given = parsed.GetValue(folder) ?? Folder(path);
            string full = Path.GetFullPath(path), shared = Path.GetFullPath(given);
            bool isSplit = parsed.GetValue(shard) != null || parsed.GetValue(slurm) != null || parsed.GetValue(kubernetes) != null;
            if (plan.Search != null && (isSplit || parsed.GetValue(workers) > 1))
                throw new UserException("A search flies one run after the other: it has no parts, and takes one of --workers.");
            if (parsed.GetValue(slurm) is int jobs)
                WriteScript(given, k_Slurm, StudyScripts.Slurm(Name(path), full, shared, jobs), output);
            if (parsed.GetValue(kubernetes) is int indices)
            {
                IEnumerable<string> read = ReadFiles.Paths.Select(Path.GetFullPath);
                WriteScript(given, k_Kubernetes, StudyScripts.Kubernetes(Name(path), full, shared, read, indices), output);
            }

            if (parsed.GetValue(slurm) == null && parsed.GetValue(kubernetes) == null)
                Fly(plan, given, Shard(parsed.GetValue(shard)), parsed.GetValue(workers), output);
            return 0;
        });
        return command;
    }

    private static Command CreateMerge(TextWriter output)
    {
        var file = new Argument<string>("FILE") { Description = $"The study, a file NAME{StudyFile.Ending}." };
        var folders = new Argument<string[]>("DIR")
        {
            Arity = ArgumentArity.OneOrMore,
            Description = "Folders with parts of it.",
        };
        Option<string> folder = Out();
        var merge = new Command("merge", "Joins the parts of a study that were flown apart, and writes its tables.")
        {
            file, folders, folder,
        };
        HelpExamples.Set(
            merge, "Examples:\n  study merge wing.study.json out/wing\n  study merge wing.study.json part1 part2 --out whole\n");
        merge.SetAction(parsed =>
        {
            string path = parsed.GetValue(file);
            StudyPlan plan = Read(path);
            string missing = Array.Find(parsed.GetValue(folders), one => !Directory.Exists(one));
            if (missing != null)
                throw new UserException($"There is no folder '{missing}'.");
            WriteTables(plan, parsed.GetValue(folders), parsed.GetValue(folder) ?? Folder(path), output);
            return 0;
        });
        return merge;
    }

    private static Option<string> Out() =>
        new("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/NAME]" };

    private static string Folder(string path) => Path.Combine("out", Name(path));

    private static string Name(string path)
    {
        string name = Path.GetFileName(path);
        int dot = name.IndexOf('.');
        return dot > 0 ? name[..dot] : name;
    }

    internal static StudyPlan Read(string path)
    {
        var file = StudyFile.Read(path);
        InsectDefinition insect = Within(StudyKeys.Insect, () => KnownSpecies.Find(file.Insect));
        var options = new FlyOptions();
        var command = new Command("fly");
        options.AddTo(command);
        var free = new FreeOptions();
        free.AddTo(command);
        System.CommandLine.ParseResult parsed = command.Parse(
            [.. file.Options], new ParserConfiguration { ResponseFileTokenReplacer = null });
        if (UsageProblem.Find(parsed) is string problem)
            throw new UserException($"{path}: {StudyKeys.Options}: {problem}");
        if (parsed.GetResult(options.Out) is { Implicit: false })
            throw new UserException($"{path}: {StudyKeys.Options}: {options.Out.Name} is an option of 'study' itself.");
        StudyFlight flight = Within(StudyKeys.Options, () =>
        {
            StudyFlight said = free.IsFree(parsed) ? Free() : new SpotStudy(options.Plan(parsed, insect.Name, insect));
            KnownSpecies.With(insect, said.Variant);
            return said;
        });
        if (flight is FreeStudy != file.IsFree)
            throw new UserException($"{path}: {StudyKeys.Options}: '--free' stands alone, without a value.");
        if (flight is FreeStudy { Repeats: > 1 } several && several.Plan.Pilot != FreePilot.Wander)
            throw new UserException($"{path}: {StudyKeys.Repeats}: flights without --pilot wander are the same each time.");
        return new StudyPlan(file, flight);

        StudyFlight Free()
        {
            options.CheckFree(parsed);
            return new FreeStudy(free.PlanOfStudy(parsed, insect, options.Seconds(parsed)), file.Repeats);
        }

        T Within<T>(string key, Func<T> read)
        {
            try
            {
                return read();
            }
            catch (UserException wrong)
            {
                throw new UserException($"{path}: {key}: {wrong.Message}");
            }
        }
    }

    private static StudyShard? Shard(string text)
    {
        if (text == null)
            return null;
        return StudyShard.TryParse(text, out StudyShard shard)
            ? shard
            : throw new UserException($"--shard takes I/N, such as 3/8, with I from 1 to N, not {Quote.Of(text)}.");
    }

    private static void Fly(StudyPlan plan, string given, StudyShard? part, int? count, TextWriter output)
    {
        StudyShard shard = part ?? StudyShard.Whole;
        int runs = shard.Runs(plan.Points.Length).Count(),
            workers = Math.Min(count ?? (runs < k_Few || plan.Search != null ? 1 : Environment.ProcessorCount), runs);
        using (var made = OutputFolder.Prepare(given, k_Table, k_Parquet, k_Effects))
            made.Commit();
        var terminal = new Terminal(output);
        var progress = new StudyProgress(given);
        terminal.ShowProgress(part == null ? plan.Points.Length : runs, (done, _) =>
        {
            if (workers <= 1)
                StudyRows.Fly(plan, given, shard, done);
            else
                StudyWorkers.Fly(plan.File.Path, given, shard.Split(workers), () => done(progress.Count()));
        });
        if (part == null)
            WriteTables(plan, [given], given, output);
        else
            output.WriteLine(FormattableString.Invariant($"Part {shard}: {runs} runs are done in {given}."));
    }

    private static void WriteTables(StudyPlan plan, string[] from, string given, TextWriter output)
    {
        SortedDictionary<int, StudyRow> rows = StudyRows.Read(plan, from);
        if (rows.Count < plan.Points.Length)
        {
            int first = Enumerable.Range(0, plan.Points.Length).First(run => !rows.ContainsKey(run));
            throw new UserException(FormattableString.Invariant(
                $"{plan.Points.Length - rows.Count} of {plan.Points.Length} runs are not flown yet; run {first} is the first of them."));
        }

        var result = new StudyResult(plan, rows);
        List<string> names = [k_Table, k_Parquet, k_Effects];
        using var folder = OutputFolder.Prepare(given, [.. names]);
        folder.Write(k_Table, stream => StudyTables.WriteCsv(result, stream));
        folder.Write(k_Parquet, stream => StudyTables.WriteParquet(result, stream));
        folder.Write(k_Effects, stream => stream.Write(Encoding.UTF8.GetBytes(StudyPictures.DrawEffects(result))));
        if (plan.File.Most != null)
        {
            names.Add(k_Front);
            folder.Write(k_Front, stream => stream.Write(Encoding.UTF8.GetBytes(StudyPictures.DrawFront(result))));
        }

        if (plan.Search != null)
        {
            names.Add(k_Search);
            folder.Write(k_Search, stream => stream.Write(Encoding.UTF8.GetBytes(StudyPictures.DrawSearch(result))));
        }

        if (result.Sensitivities != null)
        {
            names.Add(k_Shares);
            folder.Write(k_Shares, stream => StudyTables.WriteSensitivities(result, stream));
        }

        folder.Commit();
        Show(result, new Terminal(output), given, names);
    }

    private static void Show(StudyResult result, Terminal terminal, string given, List<string> names)
    {
        StudyFile file = result.Plan.File;
        string heading = FormattableString.Invariant($"{result.Plan.Flight.Insect.DisplayName}: {result.Plan.Points.Length} runs");
        terminal.ShowTable(heading, Ranges(result));
        if (result.Sensitivities != null)
            terminal.ShowTable("Shares of the variance", StudyTables.Sensitivities(result), names: 2);
        if (file.Most != null)
        {
            terminal.Lines.Profile.Out.Writer.WriteLine(FormattableString.Invariant(
                $"{result.Front.Count} runs are beaten by no other in both {file.Most} and {file.Least}."));
        }

        if (file.Goal != null)
            terminal.ShowTable("The best run", Found(result), names: 1);
        if (result.Problems > 0)
        {
            terminal.Lines.Profile.Out.Writer.WriteLine(FormattableString.Invariant(
                $"{result.Problems} of the runs could not be flown; {k_Table} says why. The first: ")
                + result.Rows.First(row => row.Problem != null).Problem);
        }

        terminal.ShowFiles(given, [.. names]);
    }

    private static IEnumerable<IReadOnlyList<string>> Found(StudyResult result)
    {
        StudyFile file = result.Plan.File;
        StudyRow best = result.BestSoFar()[^1];
        yield return
            [FormattableString.Invariant($"run {best.Run}"), file.Goal.Holds(best, file.Measures) ? "value" : "value; it misses a bound"];
        for (int k = 0; k < file.Parameters.Count; k++)
            yield return [file.Parameters[k].Key, result.Plan.Points[best.Run][k].ToString("G6", CultureInfo.InvariantCulture)];
        for (int k = 0; k < file.Measures.Count; k++)
            yield return [file.Measures[k], best.Measures[k].ToString("G6", CultureInfo.InvariantCulture)];
    }

    private static IEnumerable<IReadOnlyList<string>> Ranges(StudyResult result)
    {
        yield return ["measure", "least", "mean", "most"];
        foreach (string measure in result.Plan.File.Measures)
        {
            double[] values = Array.FindAll(result.Values(measure), double.IsFinite);
            yield return values.Length == 0
                ? [measure, "", "", ""]
                : [measure, .. new[] { values.Min(), values.Average(), values.Max() }
                    .Select(value => value.ToString("G4", CultureInfo.InvariantCulture))];
        }
    }

    private static void WriteScript(string given, string name, string text, TextWriter output)
    {
        using var folder = OutputFolder.Prepare(given, name);
        folder.Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
        folder.Commit();
        new Terminal(output).ShowFiles(given, name);
    }

    private const string k_Examples =
        "Examples:\n"
        + "  study wing.study.json\n"
        + "  study wing.study.json --out out/wing --shard 3/8\n"
        + "  study merge wing.study.json out/wing\n"
        + "  study wing.study.json --slurm 8\n\n"
        + "A run that is done is kept in the output folder at once. A study that was stopped or killed goes on where it was, by the same\n"
        + "command. Results do not depend on how it was cut into parts.\n\n"
        + "Writes into the output folder:\n"
        + "  study.csv        a row a run: its values and measures\n"
        + "  study.parquet    the same for programs\n"
        + "  effects.svg      each measure over each parameter\n"
        + "  pareto.svg       the best compromises, where the file names two measures\n"
        + "  search.svg       the best run so far, of the design search\n"
        + "  sensitivity.csv  shares of the variance after Sobol, of the design saltelli\n"
        + "  rows-I-of-N.jsonl  the runs that are done\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input.\n";
}
