using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Laws of flights read back: shapes between frames, free flights in 3D files, gusts, paintings, films and pages.</summary>
public sealed class FlightFileLaws
{
    // A place that goes round once a beat, in frames at uneven phases.
    [Test]
    public void AWingBetweenItsFrames_IsOnTheStraightWayFromOneToTheNext_OverTheEndOfTheBeatToo()
    {
        float[] phases = [0.5f, 1.5f, 4f, 5.5f];
        var wing = new RecordedWing { Rest = [0f], Placement = new WingMount(new float3(1f, 2f, 3f), 2f, WingSide.Left) };
        foreach (float phase in phases)
        {
            wing.Frames.Add(new RecordedFrame
            {
                Phase = phase,
                Positions = [new float3(phase, 0f, 0f)],
                Normals = [new float3(0f, 1f, phase)],
                Joints = [new float3(0f, 0f, phase)],
            });
        }

        var joints = new float3[1];
        foreach ((double phase, float expected) in new[] { (0.5, 0.5f), (1.0, 1f), (2.5, 2.5f), (5.5, 5.5f),
            (5.5 + 0.25 * (2 * Math.PI - 5), 4.25f), (0.5 + 2 * Math.PI, 0.5f), (1.0 - 4 * Math.PI, 1f) })
        {
            (float3[] places, float3[] normals) = wing.At(phase / (2 * Math.PI));
            wing.JointsAt(phase / (2 * Math.PI), joints);
            // A left wing: its hinge and all beyond mirrored in X.
            Assert.That(math.distance(places[0], new float3(-1f - 2f * expected, 2f, 3f)), Is.LessThan(1e-4f), $"{phase}");
            Assert.That(joints[0].z, Is.EqualTo(expected).Within(1e-4f));
            Assert.That(math.length(normals[0]), Is.EqualTo(1f).Within(1e-5f));
        }
    }

    [Test]
    public void AFreeFlightsFile_HasItsWayItsTurns_AndTheShapesOfItsPhases()
    {
        FlightRecord beat = TetheredFlight.Fly(new FlightPlan { Species = "monarch", Substeps = 24, Patches = 64 });
        FreeMoment[] moments =
        [
            .. Enumerable.Range(0, 9).Select(k => new FreeMoment(0.02 * (k + 1), new float3(0.1f * k, 0.2f, 0.3f * k),
                quaternion.AxisAngle(math.normalize(new float3(1f, 2f, -1f)), 0.2f * k), 0f, 0f, 0f, 0f, 0.7 * k % (2 * Math.PI), 10, 1,
                    0f, 0f, 0, 0,
                FlightState.Flying)),
        ];
        var record = new FreeRecord(InsectCatalogue.Find("monarch"), moments, new float3(0.01f, 0.02f, 0.03f), 1, beat);
        using var stream = new MemoryStream();
        WingsGlb.Write(beat, stream, record);
        var file = new GlbFile(stream.ToArray());
        JsonElement animation = file.Root.GetProperty("animations")[0];
        JsonElement Channel(string path) => animation.GetProperty("channels").EnumerateArray()
            .First(channel => channel.GetProperty("target").GetProperty("path").GetString() == path);
        double[] Output(string path) =>
            file.Read(animation.GetProperty("samplers")[Channel(path).GetProperty("sampler").GetInt32()].GetProperty("output").GetInt32());
        double[] places = Output("translation"), turns = Output("rotation"), weights = Output("weights");
        int root = Channel("translation").GetProperty("target").GetProperty("node").GetInt32();

        Assert.That(animation.GetProperty("name").GetString(), Is.EqualTo("flight"));
        Assert.That(file.Root.GetProperty("nodes")[root].GetProperty("name").GetString(), Is.EqualTo("monarch"), "all of it moves");
        Assert.That(animation.GetProperty("channels").GetArrayLength(), Is.EqualTo(5), "way, turn, two wings, and the abdomen");
        Assert.That(file.Read(animation.GetProperty("samplers")[0].GetProperty("input").GetInt32()),
            Is.EqualTo(moments.Select(at => at.Time)).Within(1e-6));
        for (int k = 0; k < moments.Length; k++)
        {
            float3 thorax = moments[k].Position - math.rotate(moments[k].Rotation, record.Centre);
            double[] way = [-thorax.x, thorax.y, thorax.z];
            Assert.That(places[(3 * k)..(3 * k + 3)], Is.EqualTo(way).Within(1e-6));
            // Turned in the mirror: what the file's turn makes of a mirrored direction is the mirrored turned one.
            var turn = new quaternion((float)turns[4 * k], (float)turns[4 * k + 1], (float)turns[4 * k + 2], (float)turns[4 * k + 3]);
            float3 direction = new(0.3f, -0.5f, 0.8f), mirror = new(-1f, 1f, 1f);
            Assert.That(math.distance(math.rotate(turn, mirror * direction), mirror * math.rotate(moments[k].Rotation, direction)),
                Is.LessThan(1e-5f));
            // Between two of 24 shapes; the first one is the mesh itself.
            double at = moments[k].Phase / (2 * Math.PI) * 24;
            double[] row = weights[(23 * k)..(23 * k + 23)], expected = new double[24];
            expected[(int)at % 24] += 1 - (at - Math.Floor(at));
            expected[((int)at + 1) % 24] += at - Math.Floor(at);
            Assert.That(row, Is.EqualTo(expected[1..]).Within(1e-5), $"phase {moments[k].Phase}");
        }
    }

    [Test]
    public void AGust_BlowsForASecond_FromTheMiddleOfTheFlightOn()
    {
        var plan = new FreePlan
        {
            Insect = InsectCatalogue.Find("monarch"),
            Pilot = FreePilot.Hover,
            Seconds = 2.4,
            Step = 0.05,
            Gust = new float3(0.25f, 0.125f, -0.5f),
            Aid = 0.5,
            Options = "--pilot hover",
        };
        var told = new List<int>();
        FreeRecord record = FreeRun.Fly(plan, told.Add);

        Assert.That(told, Is.EqualTo(Enumerable.Range(1, 48)));
        Assert.That(record.Recording.Steps, Has.Count.EqualTo(48));
        for (int k = 0; k < 48; k++)
        {
            RecordedStep step = record.Recording.Steps[k];
            double time = 0.05 * k;
            if (Math.Abs(time - 1.2) > 0.01 && Math.Abs(time - 2.2) > 0.01)
                Assert.That(step.wind, Is.EqualTo(time > 1.2 && time < 2.2 ? plan.Gust : float3.zero), $"at {time}");
            Assert.That(step.aid, Is.EqualTo(0.5f));
            Assert.That(math.length(step.gravity), Is.EqualTo(9.81f).Within(1e-3f));
        }

        FlightRecording recording = record.Recording;
        Assert.That((recording.Insect, recording.Package, recording.Options),
            Is.EqualTo(("monarch", PackageRoot.Version, "--pilot hover")));
        Assert.That(recording.Start.settled, Is.True);
    }

    // As high as the wing is deep, to the nearest half or double.
    [Test]
    public void PaintingsOfWings_AreSquarePixels_InPowersOfTwo()
    {
        string[] names = ["monarch", "dragonfly"];
        foreach (WingDefinition wing in names.SelectMany(name => InsectCatalogue.Find(name).Wings).Where(wing => wing.Pattern != null))
        {
            WingTexture painted = WingPainting.Of(wing);
            double depth = 1024 * (wing.Contour.Front - wing.Contour.Rear);
            Assert.That(painted.Width, Is.EqualTo(1024));
            Assert.That(System.Numerics.BitOperations.IsPow2(painted.Height) && painted.Height <= 1024, Is.True);
            if (painted.Height < 1024)
                Assert.That(painted.Height * 1.4, Is.GreaterThanOrEqualTo(depth));
            Assert.That(painted.Height / 2 * 1.4, Is.LessThan(depth));
            Assert.That(WingPainting.Of(wing), Is.SameAs(painted), "once");
        }
    }

    [Test]
    public void AFilmOfColumns_HasEachInItsPart_UnderItsTitle_AndSaysHowSlowItIs()
    {
        ComparisonColumn[] columns = [ComparisonColumn.RigidWing, ComparisonColumn.FullModel];
        var plan = new FilmPlan
        {
            Flight = new FlightPlan { Species = "monarch", Substeps = 12, Patches = 64 },
            Columns = columns,
            Frames = 4,
            Beats = 1,
            Width = 240,
            Rate = 10,
        };
        var film = Film.Fly(plan);
        var told = new List<int>();
        Color32[][] frames = film.Draw(told.Add);
        int width = film.Size.x, height = film.Size.y;
        Color32 paper = frames[0][0];
        using var folder = new TemporaryFolder();
        File.WriteAllBytes(folder.PathOf("film.png"), film.Animation(frames));
        double frequency = TetheredFlight.Fly(plan.Flight).Wings[0].Frequency;

        Assert.That((told.ToArray(), film.Count), Is.EqualTo((new[] { 1, 2, 3, 4 }, 4)));
        Assert.That(PngTexts.Of(folder.PathOf("film.png")), Is.EqualTo(columns.Select(column => column.Title).Prepend(
            FormattableString.Invariant($"Monarch, {frequency * 4 / 10:0.#} times slower than it beats: {frequency:0.#} Hz"))));
        // Below the titles all places of all frames lie an inset of 14 units from the sides of their halves.
        for (int half = 0; half < 2; half++)
        {
            int[] painted = [.. Enumerable.Range(0, width * height).Where(k => k / width > 55 && k % width / (width / 2) == half
                && frames.Any(frame => !frame[k].Equals(paper))).Select(k => k % width - half * width / 2)];
            Assert.That(painted.Min(), Is.InRange(16, 40));
            Assert.That(painted.Max(), Is.InRange(80, 104));
            int[] title = [.. Enumerable.Range(0, width * height).Where(k => k / width < 50 && k % width / (width / 2) == half
                && frames[0][k].g < 150)
                .Select(k => k % width - half * width / 2)];
            Assert.That(0.5 * (title.Min() + title.Max()), Is.EqualTo(60).Within(8), "in the middle of its half");
        }

        Assert.That(columns.Length * 120, Is.EqualTo(width));
    }

    [TestCase("a.html", "text/html; charset=utf-8")]
    [TestCase("a.css", "text/css; charset=utf-8")]
    [TestCase("a.b.js", "text/javascript; charset=utf-8")]
    [TestCase("icon.svg", "image/svg+xml")]
    [TestCase("three", "application/octet-stream")]
    public void FilesOfThePage_HaveTheirTypes(string name, string type) => Assert.That(PageFiles.TypeOf(name), Is.EqualTo(type));

    [Test]
    public void ThePage_LoadsThreeFromThePublicServer_WithItsHashes_OrFromItsOwnFolder()
    {
        JsonElement shared = JsonDocument.Parse(ThreeSource.Public.ImportMap()).RootElement;
        string root = $"https://cdn.jsdelivr.net/npm/three@{ThreeSource.Version}/";
        using var folder = new TemporaryFolder();
        foreach (string name in ThreeSource.Hashes.Keys)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(folder.PathOf(name)));
            folder.File(name, name);
        }

        var own = ThreeSource.Of(folder.Root);
        JsonElement local = JsonDocument.Parse(own.ImportMap()).RootElement;
        foreach ((JsonElement map, string at) in new[] { (shared, root), (local, "./three/") })
        {
            Assert.That(map.GetProperty("imports").GetProperty("three").GetString(), Is.EqualTo(at + "build/three.module.js"));
            Assert.That(map.GetProperty("imports").GetProperty("three/orbit").GetString(),
                Is.EqualTo(at + "examples/jsm/controls/OrbitControls.js"));
        }

        Assert.That(shared.GetProperty("integrity").EnumerateObject().ToDictionary(file => file.Name[root.Length..],
            file => file.Value.GetString()),
            Is.EqualTo(ThreeSource.Hashes));
        Assert.That(local.TryGetProperty("integrity", out _), Is.False);
        Assert.That((ThreeSource.Public.IsPublic, own.IsPublic, ThreeSource.Public.Names.Count()), Is.EqualTo((true, false, 0)));
        Assert.That(own.Names.ToDictionary(name => name, name => Encoding.UTF8.GetString(own.Read(name))),
            Is.EqualTo(ThreeSource.Hashes.Keys.ToDictionary(name => name)));
        foreach ((PageKind kind, string mode) in new[] { (PageKind.Live, "live"), (PageKind.Baked, "baked"), (PageKind.Scene, "scene") })
        {
            var page = new PageFiles(own, kind);
            string index = Encoding.UTF8.GetString(page.Find("index.html"));
            Assert.That(index, Does.Contain(own.ImportMap()).And.Contain($"data-mode=\"{mode}\""));
            Assert.That(page.Names, Is.SupersetOf(own.Names.Select(name => "three/" + name).Append("main.js").Append("index.html")));
            Assert.That(page.Find("none"), Is.Null);
        }
    }
}
