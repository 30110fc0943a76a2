using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>The module of Documentation~/python that reads outputs into arrays, and its examples.</summary>
public sealed class PythonTests
{
    private const string k_Python = "/usr/bin/python3";

    private static string Folder => Path.Combine(PackageRoot.Find(), "Documentation~", "python");

    [Test]
    [Explicit]
    [Category("Long")]
    public void WhatIsRead_IsWhatTheFilesHold()
    {
        using var run = new CommandRun();
        Assert.That(run.Run("fly", "painted-lichen-moth", "--no-pictures", "--out", run.Out), Is.Zero, run.Errors);
        JsonElement read = JsonDocument.Parse(Python("-c", """
            import alate, json, sys
            run = alate.read(sys.argv[1])
            strips = run["spanwise"].where(side="left")
            phases, places, lift = strips.grid("lift_n", "phase_deg", "span_m")
            scene = run.scene("wings")
            part = next(name for name in scene.names if "left" in name)
            times, poses = scene.poses(part)
            print(json.dumps({
                "tables": run.tables,
                "name": run.summary["species"],
                "lift": run["forces"]["lift_n"].tolist(),
                "strokes": run["forces"]["half_stroke"].tolist(),
                "unit": run["forces"].units["moment_x_nm"],
                "strips": [list(lift.shape), phases.tolist(), places.tolist(), float(lift[3, 7]), float(lift[-1, 0])],
                "empty": int(sum(strips["attack_deg"] != strips["attack_deg"])),
                "times": times.tolist(),
                "poses": [list(poses.shape), poses[2, 10].tolist()],
            }))
            """, run.Out)).RootElement;

        Dictionary<string, string>[] forces = Rows(run, "forces"),
            strips = [.. Rows(run, "spanwise").Where(row => row["side"] == "left")];
        Assert.That(Texts(read.GetProperty("tables")), Is.EqualTo(new[] { "forces", "joints", "spanwise" }));
        Assert.That(read.GetProperty("name").GetString(), Is.EqualTo("painted-lichen-moth"));
        Assert.That(Numbers(read.GetProperty("lift")), Is.EqualTo(forces.Select(row => Number(row["lift_n"]))));
        Assert.That(Texts(read.GetProperty("strokes")), Is.EqualTo(forces.Select(row => row["half_stroke"])));
        Assert.That(read.GetProperty("unit").GetString(), Is.EqualTo("N m"));

        double[] phases = [.. strips.Select(row => Number(row["phase_deg"])).Distinct().Order()],
            places = [.. strips.Select(row => Number(row["span_m"])).Distinct().Order()];
        JsonElement grid = read.GetProperty("strips");
        Assert.That(Numbers(grid[0]), Is.EqualTo(new double[] { phases.Length, places.Length }));
        Assert.That((Numbers(grid[1]), Numbers(grid[2])), Is.EqualTo((phases, places)));
        Assert.That(grid[3].GetDouble(), Is.EqualTo(Lift(phases[3], places[7])));
        Assert.That(grid[4].GetDouble(), Is.EqualTo(Lift(phases[^1], places[0])));
        Assert.That(read.GetProperty("empty").GetInt32(), Is.EqualTo(strips.Count(row => row["attack_deg"] == "")).And.Positive);

        // The file has a shape for each key frame but that at rest, and weights of one.
        var file = new GlbFile(File.ReadAllBytes(Path.Combine(run.Out, "wings.glb")));
        JsonElement mesh = file.Root.GetProperty("meshes").EnumerateArray()
            .Single(mesh => Name(mesh).EndsWith("left", StringComparison.Ordinal));
        JsonElement part = mesh.GetProperty("primitives")[0], animation = file.Root.GetProperty("animations")[0];
        int node = file.Root.GetProperty("nodes").EnumerateArray().ToList()
            .FindIndex(node => node.TryGetProperty("mesh", out _) && Name(node) == Name(mesh));
        JsonElement channel = animation.GetProperty("channels").EnumerateArray()
            .Single(channel => channel.GetProperty("target").GetProperty("node").GetInt32() == node);
        JsonElement sampler = animation.GetProperty("samplers")[channel.GetProperty("sampler").GetInt32()];
        double[] times = file.Read(sampler.GetProperty("input").GetInt32()), weights = file.Read(sampler.GetProperty("output").GetInt32());
        double[] at = file.Read(part.GetProperty("attributes").GetProperty("POSITION").GetInt32())[30..33];
        int shapes = part.GetProperty("targets").GetArrayLength();
        for (int k = 0; k < shapes; k++)
        {
            double[] shape = file.Read(part.GetProperty("targets")[k].GetProperty("POSITION").GetInt32());
            for (int axis = 0; axis < 3; axis++)
                at[axis] += weights[2 * shapes + k] * shape[30 + axis];
        }

        Assert.That(Numbers(read.GetProperty("times")), Is.EqualTo(times).Within(1e-6));
        Assert.That(Numbers(read.GetProperty("poses")[1]), Is.EqualTo(at).Within(1e-7));

        double Lift(double phase, double place) => Number(
            strips.Single(row => Number(row["phase_deg"]) == phase && Number(row["span_m"]) == place)["lift_n"]);
    }

    [TestCase("alate.read('table.txt')", "read takes a folder, or a file .csv, .json or .glb")]
    [TestCase("alate.read('none')", "none: read takes")]
    [TestCase("alate.Run('none')", "none is no folder")]
    [TestCase("alate.read('.')['forces']", "has no forces.csv, but ragged, twice")]
    [TestCase("alate.read('ragged.csv')", "ragged.csv: its rows have not all as many cells as its first line")]
    [TestCase("alate.read('twice.csv')['lift']", "no column lift, but time_s, span_m, lift_n")]
    [TestCase("alate.read('twice.csv').grid('lift_n', 'time_s', 'span_m')", "time_s and span_m do not tell the rows apart")]
    [TestCase("alate.read('no.glb')", "no.glb is no GLB file of version 2")]
    [Explicit]
    [Category("Long")]
    public void WhatIsWrong_IsNamed(string statement, string problem)
    {
        using var run = new CommandRun();
        run.Write("ragged.csv", "a,b\n1,2\n3\n");
        run.Write("twice.csv", "time_s,span_m,lift_n\n0,1,2\n0,1,3\n");
        run.Write("no.glb", "no");
        Assert.That(Python("-c", $"""
            import alate, os, sys
            os.chdir(sys.argv[1])
            try:
                {statement}
            except (ValueError, KeyError, FileNotFoundError) as error:
                print(error)
            """, run.Folder), Does.Contain(problem));
    }

    [TestCase("force_over_beat", "of the strips")]
    [TestCase("polar", "lift/weight")]
    [TestCase("own_wing", "flap 114.6°  lift 0.79 of the weight")]
    [Explicit]
    [Category("Long")]
    public void AnExample_FliesAndDraws(string name, string said)
    {
        using var run = new CommandRun();
        string picture = Path.Combine(run.Folder, name + ".png");
        string[] words = name == "force_over_beat" ? ["monarch", picture] : name == "polar" ? ["monarch", "1", picture] : [picture];
        string output = Python([Path.Combine(Folder, name + ".py"), .. words]);
        Assert.That(output, Does.Contain(said));
        if (name == "force_over_beat")
        {
            double[] lifts = [.. Regex.Matches(output, @"(-?[\d.]+) mN").Select(match => Number(match.Groups[1].Value))];
            Assert.That(lifts, Has.Length.EqualTo(3).And.All.EqualTo(lifts[0]).Within(0.002));
        }

        if (name == "polar")
        {
            // Lift over its share of the weight is the weight, at every pitch.
            double[][] rows = [.. output.Trim().Split('\n').Skip(1).Select(line =>
                line.Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(Number).ToArray())];
            double weight = rows[^1][1] / rows[^1][4];
            Assert.That(rows.Select(row => row[1]), Is.EqualTo(rows.Select(row => weight * row[4])).Within(0.03));
        }

        Assert.That(new FileInfo(picture).Length, Is.GreaterThan(10000));
    }

    private static Dictionary<string, string>[] Rows(CommandRun run, string table)
    {
        string[][] lines = [.. File.ReadLines(Path.Combine(run.Out, table + ".csv")).Select(line => line.Split(','))];
        return [.. lines.Skip(1).Select(line => lines[0].Zip(line).ToDictionary(pair => pair.First, pair => pair.Second))];
    }

    private static string Name(JsonElement part) => part.GetProperty("name").GetString();

    private static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);

    private static double[] Numbers(JsonElement values) => [.. values.EnumerateArray().Select(value => value.GetDouble())];

    private static string[] Texts(JsonElement values) => [.. values.EnumerateArray().Select(value => value.GetString())];

    private static string Python(params string[] words)
    {
        if (!File.Exists(k_Python))
            Assert.Ignore($"{k_Python} is not installed.");
        (int code, string output, string errors) = Run(words);
        if (errors.Contains("No module named 'numpy'") || errors.Contains("No module named 'matplotlib'"))
            Assert.Ignore($"{k_Python} lacks numpy or matplotlib.");
        Assert.That(code, Is.Zero, errors);
        return output;
    }

    private static (int Code, string Output, string Errors) Run(params string[] words)
    {
        var start = new ProcessStartInfo(k_Python, words) { RedirectStandardOutput = true, RedirectStandardError = true };
        start.Environment["PYTHONPATH"] = Folder;
        start.Environment["PYTHONDONTWRITEBYTECODE"] = "1";
        start.Environment["ALATE_CLI"] = typeof(KnownSpecies).Assembly.Location;
        using var process = Process.Start(start);
        string output = process.StandardOutput.ReadToEnd(), errors = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, output, errors);
    }
}
