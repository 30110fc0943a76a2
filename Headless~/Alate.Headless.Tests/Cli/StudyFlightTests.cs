using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Editor.Tests;
using NUnit.Framework;
using static Alate.Tests.Cli.StudyCommandTests;

namespace Alate.Tests.Cli;

/// <summary>Flights of studies: what of an insect and of the files that it reads counts.</summary>
public sealed class StudyFlightTests
{
    // By the number of the variant where that has its own; the force along gravity is the share of the weight, whatever the pitch.
    [Test]
    public void AVariant_FliesTheValue_AndForcesAreThoseOfTheWorld()
    {
        using var run = new CommandRun();
        string file = run.Write("s.study.json", """
            { "version": 1, "insect": "monarch", "options": ["--variant", "flight", "--speed", "1"], "parameters": [
                { "key": "insect.beat.flapRangeDegrees", "values": [80, 110] }, { "key": "pitch", "values": [0, 30] } ],
              "measures": ["lift_over_weight", "lift_n", "thrust_n"] }
            """);
        Assert.That(run.Run("study", file, "--out", run.Out), Is.Zero, run.Errors);
        Dictionary<string, string>[] rows = Rows(run.Out);
        Assert.That(rows.Select(row => row["lift_over_weight"]).Distinct().Count(), Is.EqualTo(4));
        double[] weights = [.. rows.Select(row => Number(row["lift_n"]) / Number(row["lift_over_weight"]))];
        Assert.That(weights, Has.All.EqualTo(weights[0]).Within(1e-4 * weights[0]));

        string flown = Path.Combine(run.Folder, "flown");
        var insect = JsonNode.Parse(InsectFileText.Write(InsectCatalogue.Find("monarch")));
        foreach (JsonNode beat in new[] { insect["beat"], insect["variants"]["flight"]["beat"] })
        {
            if (beat?["flapRangeDegrees"] != null)
                beat["flapRangeDegrees"] = 110;
        }

        string[] words = [run.Write("m.insect.json", insect.ToJsonString()),
            "--variant", "flight", "--speed", "1", "--pitch", "30", "--no-pictures"];
        Assert.That(run.Run(["fly", .. words, "--out", flown]), Is.Zero, run.Errors);
        Dictionary<string, string>[] forces = Table(Path.Combine(flown, "forces.csv"));
        Assert.That(Number(rows[3]["lift_n"]), Is.EqualTo(forces.Average(row => Number(row["lift_n"]))).Within(1e-6));
        Assert.That(Number(rows[3]["thrust_n"]), Is.EqualTo(-forces.Average(row => Number(row["drag_n"]))).Within(1e-6));
    }

    // An own wing: each row as of a file that was read anew, and its mesh and picture made once.
    [Test]
    public void AnOwnInsect_FliesInEachRow_AsItsFileWithThatNumber()
    {
        using var run = new CommandRun();
        string home = Path.Combine(run.Folder, "own"), path = Path.Combine(home, "own.insect.json");
        string picture = Path.Combine(run.Folder, "wing.png");
        File.WriteAllBytes(picture, PngOf.Picture(DrawnWing.Scalloped().In(200).Draw(DrawnKind.Silhouette)));
        Assert.That(run.Run("insect", "new", home, "--wing", picture, "--length", "3cm", "--mass", "0.2g", "--frequency", "20"),
            Is.Zero, run.Errors);
        string file = run.Write("s.study.json", $$"""
            { "version": 1, "insect": "{{path}}", "parameters": [
                { "key": "insect.beat.frequencyHertz", "values": [18, 20, 23] } ], "measures": ["lift_over_weight"] }
            """);
        Assert.That(run.Run("study", file, "--out", run.Out, "--workers", "1"), Is.Zero, run.Errors);
        Dictionary<string, string>[] rows = Rows(run.Out);
        for (int k = 0; k < 3; k++)
        {
            var insect = JsonNode.Parse(File.ReadAllText(path));
            insect["beat"]["frequencyHertz"] = new[] { 18, 20, 23 }[k];
            File.WriteAllText(path, insect.ToJsonString());
            Assert.That(run.Run("fly", path, "--no-pictures", "--out", home), Is.Zero, run.Errors);
            var summary = JsonNode.Parse(File.ReadAllText(Path.Combine(home, "summary.json")));
            Assert.That(Number(rows[k]["lift_over_weight"]), Is.EqualTo((double)summary["lift_over_weight"]).Within(1e-6));
        }
    }

    [Test]
    public void WhatFollowsFromFiles_IsMadeOnce_OfEachName()
    {
        int made = 0;
        var kept = new KeptFiles(InputFiles.Instance);
        string[] all = [.. new[] { "a", "b", "a", "a", "b" }.Select(name => kept.Make(name, () => name + made++))];

        Assert.That(all, Is.EqualTo(new[] { "a0", "b1", "a0", "a0", "b1" }));
        Assert.That(InputFiles.Instance.Make("a", () => "of others"), Is.EqualTo("of others"), "which keep nothing");
    }

    // What a flight reads belongs to the study: a motion that has changed makes another one.
    [Test]
    public void AMotionThatHasChanged_MakesAnotherStudy()
    {
        using var run = new CommandRun();
        string motion = Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics", "dragonfly-tethered.json"),
            copy = run.Write("motion.json", File.ReadAllText(motion));
        string file = run.Write("s.study.json", $$"""
            { "version": 1, "insect": "dragonfly", "options": ["--kinematics", "{{copy}}", "--speed", "0"], "parameters": [
                { "key": "elasticity", "values": [1] } ], "measures": ["lift_over_weight"] }
            """);
        Assert.That(run.Run("study", file, "--out", run.Out), Is.Zero, run.Errors);
        File.AppendAllText(copy, "\n");
        Assert.That(run.Run("study", file, "--out", run.Out), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain("rows of another study"));
        File.Delete(copy);
        Assert.That(run.Run("study", file, "--out", Path.Combine(run.Folder, "none")), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain("motion.json"));
    }
}
