using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Threading.Tasks;
using System.Xml.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Json.Schema;
using NUnit.Framework;
using Parquet;
using Parquet.Schema;

namespace Alate.Tests.Cli;

/// <summary>The command <c>study</c>: what it writes, that it goes on where it was, and what it refuses.</summary>
public sealed class StudyCommandTests
{
    internal const string k_Study = """
        {
          "version": 1,
          "insect": "painted-lichen-moth",
          "options": ["--speed", "0", "--pitch", "30"],
          "parameters": [
            { "key": "insect.beat.frequencyHertz", "values": [20, 30] },
            { "key": "elasticity", "from": 0.5, "to": 2, "steps": 2, "scale": "logarithmic" }
          ],
          "measures": ["lift_over_weight", "positive_power_w", "twist_pp_deg"],
          "best": { "most": "lift_over_weight", "least": "positive_power_w" }
        }
        """;

    private const string k_Begin = "<!-- keys: ALATE_WRITE_API=1 and StudyCommandTests write them -->\n", k_End = "<!-- end of keys -->";

    private static bool Writes => Environment.GetEnvironmentVariable("ALATE_WRITE_API") == "1";

    private CommandRun m_Whole;
    private string m_File;

    [OneTimeSetUp]
    public void Fly()
    {
        m_Whole = new CommandRun();
        m_File = m_Whole.Write("moth.study.json", k_Study);
        Assert.That(m_Whole.Run("study", m_File, "--out", m_Whole.Out), Is.Zero, m_Whole.Errors);
    }

    [OneTimeTearDown]
    public void RemoveFiles() => m_Whole.Dispose();

    [Test]
    public void ARow_IsTheFlightOfAnInsectFile_WithItsValues()
    {
        var insect = JsonNode.Parse(InsectFileText.Write(InsectCatalogue.Find("painted-lichen-moth")));
        insect["beat"]["frequencyHertz"] = 30;
        using var run = new CommandRun();
        string file = run.Write("moth.insect.json", insect.ToJsonString());
        Assert.That(run.Run("fly", file, "--speed", "0", "--pitch", "30", "--elasticity", "2", "--no-pictures", "--out", run.Out), Is.Zero);
        JsonElement summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "summary.json"))).RootElement;

        Dictionary<string, string> row = Rows(m_Whole.Out)
            .Single(row => row["insect.beat.frequencyHertz"] == "30" && row["elasticity"] == "2");
        foreach (string measure in new[] { "lift_over_weight", "positive_power_w", "twist_pp_deg" })
        {
            double told = summary.GetProperty(measure).GetDouble();
            Assert.That(Number(row[measure]), Is.EqualTo(told).Within(1e-5 * Math.Abs(told)), measure);
        }
    }

    [Test]
    public void Rows_AreInTheOrderOfTheRuns_AndTheBestAreMarked()
    {
        Dictionary<string, string>[] rows = Rows(m_Whole.Out);
        Assert.That(rows.Select(row => row["run"]), Is.EqualTo(new[] { "0", "1", "2", "3" }));
        Assert.That(rows.Select(row => (row["insect.beat.frequencyHertz"], row["elasticity"])),
            Is.EqualTo(new[] { ("20", "0.5"), ("20", "2"), ("30", "0.5"), ("30", "2") }));
        Assert.That(rows.Single(row => rows.All(other => Number(other["lift_over_weight"]) <= Number(row["lift_over_weight"])))["is_best"],
            Is.EqualTo("yes"));
        Assert.That(rows.Select(row => row["problem"]), Has.All.Empty);
    }

    [Test]
    public async Task TheParquetFile_HoldsTheTable()
    {
        Dictionary<string, string>[] rows = Rows(m_Whole.Out);
        await using ParquetReader reader = await ParquetReader.CreateAsync(Path.Combine(m_Whole.Out, "study.parquet"));
        Assert.That(reader.Schema.GetDataFields().Select(field => field.Name), Is.EqualTo(rows[0].Keys));
        using ParquetRowGroupReader group = reader.OpenRowGroupReader(0);
        DataField field = reader.Schema.GetDataFields().Single(field => field.Name == "lift_over_weight");
        double[] lifts = new double[rows.Length];
        await group.ReadAsync<double>(field, lifts);
        Assert.That(lifts, Is.EqualTo(rows.Select(row => Number(row["lift_over_weight"]))));
    }

    [Test]
    public void Sensitivities_HaveARowForEachMeasureAndParameter_FromTheRunsOfTheTable()
    {
        using var run = new CommandRun();
        string file = run.Write("s.study.json", """
            {
              "version": 1, "insect": "painted-lichen-moth", "design": "saltelli", "count": 3,
              "options": ["--speed", "0", "--pitch", "30", "--substeps", "16"],
              "parameters": [{ "key": "elasticity", "from": 0.5, "to": 2 }, { "key": "insect.beat.frequencyHertz", "from": 20, "to": 30 }],
              "measures": ["lift_over_weight", "twist_pp_deg"]
            }
            """);
        Assert.That(run.Run("study", file, "--out", run.Out), Is.Zero, run.Errors);
        Dictionary<string, string>[] runs = Rows(run.Out), rows = Table(Path.Combine(run.Out, "sensitivity.csv"));

        Assert.That(runs, Has.Length.EqualTo(3 * (2 + 2)));
        Assert.That(rows.Select(row => (row["measure"], row["parameter"])), Is.EqualTo(new[]
        {
            ("lift_over_weight", "elasticity"), ("lift_over_weight", "insect.beat.frequencyHertz"),
            ("twist_pp_deg", "elasticity"), ("twist_pp_deg", "insect.beat.frequencyHertz"),
        }));
        foreach (IGrouping<string, Dictionary<string, string>> measure in rows.GroupBy(row => row["measure"]))
        {
            Sensitivity[] shares = Sensitivity.Of([.. runs.Select(row => Number(row[measure.Key]))], 2);
            Assert.That(measure.Select(row => Number(row["first_order"])), Is.EqualTo(shares.Select(share => share.First)).Within(1e-6));
            Assert.That(measure.Select(row => Number(row["total"])), Is.EqualTo(shares.Select(share => share.Total)).Within(1e-6));
        }

        Assert.That(run.Output, Does.Contain("first_order").And.Not.Match(@"-0(\.0*)?(\s|$)"), "no minus before nothing");
    }

    // A killed run leaves its file at any byte.
    [Test]
    public void AStudyThatWasStoppedAnywhere_GoesOn_AndWritesTheSameBytes([Values(0.0, 0.3, 0.62, 0.99)] double share)
    {
        using var run = new CommandRun();
        Directory.CreateDirectory(run.Out);
        byte[] done = File.ReadAllBytes(Path.Combine(m_Whole.Out, "rows-1-of-1.jsonl"));
        File.WriteAllBytes(Path.Combine(run.Out, "rows-1-of-1.jsonl"), done[..(int)(share * done.Length)]);
        Assert.That(run.Run("study", m_File, "--out", run.Out), Is.Zero, run.Errors);
        AssertSame(run.Out);
    }

    [Test]
    public void Parts_AreJoinedToTheSameBytes_AndAMissingOneIsNamed()
    {
        using var run = new CommandRun();
        string one = Path.Combine(run.Folder, "one"), two = Path.Combine(run.Folder, "two");
        Assert.That(run.Run("study", m_File, "--out", one, "--shard", "1/3"), Is.Zero, run.Errors);
        Assert.That(run.Run("study", m_File, "--out", two, "--shard", "2/3"), Is.Zero, run.Errors);
        Assert.That(run.Run("study", "merge", m_File, one, two, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain("1 of 4 runs are not flown yet; run 2 is the first of them."));
        Assert.That(Directory.Exists(run.Out), Is.False);
        Assert.That(run.Run("study", m_File, "--out", two, "--shard", "3/3"), Is.Zero, run.Errors);
        Assert.That(run.Run("study", "merge", m_File, one, two, "--out", run.Out), Is.Zero, run.Errors);
        AssertSame(run.Out);
    }

    [Test]
    public void Progress_CountsWholeRows_AsFilesGrow()
    {
        using var run = new CommandRun();
        Directory.CreateDirectory(run.Out);
        var progress = new StudyProgress(run.Out);
        Assert.That(progress.Count(), Is.Zero);
        string[] lines = File.ReadAllLines(Path.Combine(m_Whole.Out, "rows-1-of-1.jsonl"));
        string one = Path.Combine(run.Out, "rows-1-of-2.jsonl"), two = Path.Combine(run.Out, "rows-2-of-2.jsonl");
        File.WriteAllText(one, lines[0] + "\n" + lines[1] + "\n" + lines[2][..9]);
        Assert.That(progress.Count(), Is.EqualTo(1));
        File.AppendAllText(one, lines[2][9..] + "\n");
        File.WriteAllText(two, lines[0] + "\n" + lines[3] + "\n");
        Assert.That(progress.Count(), Is.EqualTo(3));
        Assert.That(progress.Count(), Is.EqualTo(3));
    }

    [Test]
    public void RowsOfAnotherStudy_AreRefused_AndStay()
    {
        using var run = new CommandRun();
        string other = run.Write("moth.study.json", k_Study.Replace("\"30\"", "\"31\""));
        Directory.CreateDirectory(run.Out);
        string rows = Path.Combine(run.Out, "rows-1-of-1.jsonl");
        File.Copy(Path.Combine(m_Whole.Out, "rows-1-of-1.jsonl"), rows);
        byte[] before = File.ReadAllBytes(rows);
        Assert.That(run.Run("study", other, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain("rows of another study").And.Contain("rows-1-of-1.jsonl"));
        Assert.That(File.ReadAllBytes(rows).AsSpan().SequenceEqual(before));
    }

    [Test]
    public void ARunThatCannotBeFlown_IsARow_ThatSaysWhy()
    {
        using var run = new CommandRun();
        string file = run.Write("s.study.json", """
            { "version": 1, "insect": "monarch", "parameters": [
                { "key": "elasticity", "values": [1, 1000000] }, { "key": "insect.stiffness.elasticity", "values": [1, 900000] } ] }
            """);
        Assert.That(run.Run("study", file, "--out", run.Out), Is.Zero, run.Errors);
        Dictionary<string, string>[] rows = Rows(run.Out);
        Assert.That(rows.Select(row => row["problem"].Length > 0), Is.EqualTo(new[] { false, false, false, true }));
        Assert.That(rows[3]["lift_over_weight"], Is.Empty);
        Assert.That(run.Output, Does.Contain("1 of the runs could not be flown"));
    }

    [Test]
    public void ASearch_FindsABetterRunThanItsFirstGeneration_WithinItsBound_AndGoesOnWhereItWasStopped()
    {
        using var run = new CommandRun();
        string file = run.Write("s.study.json", """
            { "version": 1, "insect": "painted-lichen-moth", "options": ["--speed", "0", "--pitch", "30"], "design": "search", "count": 30,
              "parameters": [ { "key": "amplitude", "from": 0.5, "to": 1.5 }, { "key": "frequency", "from": 0.5, "to": 1.5 } ],
              "measures": ["lift_over_weight", "positive_power_w"],
              "goal": { "most": "lift_over_weight", "where": [ { "measure": "positive_power_w", "most": 8e-6 } ] } }
            """);
        Assert.That(run.Run("study", file, "--out", run.Out), Is.Zero, run.Errors);
        Dictionary<string, string>[] rows = Rows(run.Out);
        Assert.That(rows, Has.Length.EqualTo(30), "five generations of six");
        Dictionary<string, string> best = rows.Single(row => row["is_best"] == "yes");
        double[] allowed = [.. rows.Where(row => Number(row["positive_power_w"]) <= 8e-6).Select(row => Number(row["lift_over_weight"]))];
        Assert.That(allowed, Has.Length.InRange(3, 29));
        Assert.That(Number(best["lift_over_weight"]), Is.EqualTo(allowed.Max()));
        Assert.That(int.Parse(best["run"], CultureInfo.InvariantCulture), Is.GreaterThan(5), "the first generation is a guess");
        Assert.That(run.Output, Does.Contain("The best run").And.Not.Contain("misses a bound"));
        Assert.That(run.Output, Does.Match($@"run {best["run"]}\b"));
        AssertTheLineEndsAtTheBest(Path.Combine(run.Out, "search.svg"), rows, best);

        string again = Path.Combine(run.Folder, "again");
        Directory.CreateDirectory(again);
        byte[] done = File.ReadAllBytes(Path.Combine(run.Out, "rows-1-of-1.jsonl"));
        File.WriteAllBytes(Path.Combine(again, "rows-1-of-1.jsonl"), done[..(done.Length * 2 / 3)]);
        Assert.That(run.Run("study", file, "--out", again), Is.Zero, run.Errors);
        foreach (string name in new[] { "study.csv", "search.svg" })
        {
            Assert.That(File.ReadAllBytes(Path.Combine(again, name)).AsSpan()
                .SequenceEqual(File.ReadAllBytes(Path.Combine(run.Out, name))), name);
        }

        foreach (string option in new[] { "--shard=1/2", "--workers=2", "--slurm=2", "--kubernetes=2" })
        {
            using var refused = new CommandRun();
            Assert.That(refused.Run("study", file, option, "--out", refused.Out), Is.EqualTo(2));
            Assert.That(refused.Errors, Does.Contain("A search flies one run after the other"));
        }
    }

    [Test]
    public void Scripts_NameTheStudyAndItsParts_AndFlyNothing()
    {
        using var run = new CommandRun();
        string file = run.Write("it's.study.json", k_Study);
        Assert.That(run.Run("study", file, "--out", run.Out, "--slurm", "5", "--kubernetes", "6"), Is.Zero, run.Errors);
        Assert.That(Directory.GetFiles(run.Out).Select(Path.GetFileName), Is.EquivalentTo(new[] { "study.sbatch", "study.yaml" }));
        string slurm = File.ReadAllText(Path.Combine(run.Out, "study.sbatch")), job = File.ReadAllText(Path.Combine(run.Out, "study.yaml"));
        Assert.That(slurm, Does.Contain("--array=1-5").And.Contain("--shard \"$SLURM_ARRAY_TASK_ID/5\"")
            .And.Contain("it'\\''s.study.json'"));
        Assert.That(job, Does.Contain("--shard $((JOB_COMPLETION_INDEX + 1))/6"));
    }

    [Test]
    public void TheSchemaAndTablesOfTheManual_AreThoseOfTheReader()
    {
        string folder = Path.Combine(PackageRoot.Find(), "Documentation~"), page = Path.Combine(folder, "studies.md"),
            schema = Path.Combine(folder, StudyKeys.Schema.FileName), text = File.ReadAllText(page);
        int from = text.IndexOf(k_Begin, StringComparison.Ordinal) + k_Begin.Length, to = text.IndexOf(k_End, StringComparison.Ordinal);
        string now = text[..from] + StudyKeys.Schema.WriteTables() + text[to..];
        if (Writes)
        {
            File.WriteAllText(page, now);
            File.WriteAllText(schema, StudyKeys.Schema.Write());
        }

        Assert.That(now, Is.EqualTo(File.ReadAllText(page)), "ALATE_WRITE_API=1 writes it.");
        Assert.That(StudyKeys.Schema.Write(), Is.EqualTo(File.ReadAllText(schema)), "ALATE_WRITE_API=1 writes it.");
        var known = JsonSchema.FromText(StudyKeys.Schema.Write());
        foreach (string study in Directory.GetFiles(Path.Combine(folder, "studies")).Select(File.ReadAllText).Append(k_Study))
            Assert.That(known.Evaluate(JsonNode.Parse(study)).IsValid);
    }

    // The line is the picture's only path; its end is at the height of the best run's dot.
    private static void AssertTheLineEndsAtTheBest(string picture, Dictionary<string, string>[] rows, Dictionary<string, string> best)
    {
        XNamespace svg = "http://www.w3.org/2000/svg";
        var page = XDocument.Load(picture);
        string[] line = page.Descendants(svg + "path").Single().Attribute("d").Value.Split('M', 'L')[1..];
        XElement dot = page.Descendants(svg + "circle").ElementAt(Array.IndexOf(rows, best));
        Assert.That(line, Has.Length.InRange(2, rows.Length));
        Assert.That(Number(line[^1].Split(' ')[1]), Is.EqualTo(Number(dot.Attribute("cy").Value)).Within(0.11));
    }

    private void AssertSame(string folder)
    {
        foreach (string name in new[] { "study.csv", "study.parquet", "effects.svg", "pareto.svg" })
        {
            Assert.That(File.ReadAllBytes(Path.Combine(folder, name)).AsSpan()
                .SequenceEqual(File.ReadAllBytes(Path.Combine(m_Whole.Out, name))), name);
        }
    }

    internal static Dictionary<string, string>[] Rows(string folder) => Table(Path.Combine(folder, "study.csv"));

    internal static Dictionary<string, string>[] Table(string file)
    {
        string[][] lines = [.. File.ReadLines(file).Select(line => line.Split(','))];
        return [.. lines.Skip(1).Select(line => lines[0].Zip(line).ToDictionary(pair => pair.First, pair => pair.Second))];
    }

    internal static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);
}
