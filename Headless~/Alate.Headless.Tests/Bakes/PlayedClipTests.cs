using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes;

/// <summary>Clips of an insect that lands and takes off, played from the files.</summary>
[Category("Faults")]
public sealed class PlayedClipTests
{
    private const string k_Bake = "monarch --variant flight --clips cruise,land,take-off --fps 24 --beats-per-second 2";

    private const int k_Frames = 40;

    private readonly BakedFiles m_Files = new();
    private GltfPlayer m_Played;

    [OneTimeSetUp]
    public void Bake() => m_Played = new GltfPlayer(File.ReadAllBytes(Glb()));

    [OneTimeTearDown]
    public void RemoveFiles() => m_Files.Dispose();

    [Test]
    public void AnInsect_ComesIn_AndSitsOnTheOrigin()
    {
        float3[][] frames = Frames("land");

        Assert.That(frames[0].Average(place => place.y), Is.GreaterThan(0.05f));
        Assert.That(frames[0].Average(place => place.z), Is.LessThan(-0.04f), "from behind");
        Assert.That(frames[^1].Min(place => place.y), Is.EqualTo(0f).Within(1e-3f), "on its feet");
        float3 middle = frames[^1].Aggregate((a, b) => a + b) / frames[^1].Length;
        Assert.That(math.length(middle.xz), Is.LessThan(0.03f));
        Assert.That(frames.Min(frame => frame.Min(place => place.y)), Is.GreaterThan(-1e-3f), "no wing is below the spot");
        Assert.That(frames[^1].Max(place => math.abs(place.x)), Is.LessThan(0.02f), "its wings are folded");
        Assert.That(frames[0].Max(place => math.abs(place.x)), Is.GreaterThan(0.02f));
    }

    [Test]
    public void TakingOff_BeginsWhereTheLandingEnded_AndLeadsAhead()
    {
        float3[][] frames = Frames("take-off");
        float3[] seated = Frames("land")[^1];

        Assert.That(frames[0].Zip(seated, math.distance).Max(), Is.LessThan(1e-3f));
        Assert.That(frames[^1].Average(place => place.z), Is.GreaterThan(0.3f));
        Assert.That(frames[^1].Average(place => place.y), Is.GreaterThan(0.1f));
        Assert.That(frames.Min(frame => frame.Min(place => place.y)), Is.GreaterThan(-1e-3f));
    }

    [Test]
    public void InSlowMotion_ItsFramesAreThoseOfTheFile([Values("land", "take-off")] string clip)
    {
        double[] times = Root(clip, "translation").Times;

        for (int frame = 0; frame < times.Length; frame++)
            Assert.That(times[frame], Is.EqualTo(frame / 24.0).Within(1e-4));
    }

    [Test]
    public void ItsWay_HasNoJump([Values("land", "take-off")] string clip)
    {
        double[] places = Root(clip, "translation").Values, turns = Root(clip, "rotation").Values;

        for (int key = 1; key < places.Length / 3; key++)
        {
            double way = Math.Sqrt(Enumerable.Range(0, 3).Sum(k => Math.Pow(places[3 * key + k] - places[3 * key - 3 + k], 2.0)));
            double cosine = Enumerable.Range(0, 4).Sum(k => turns[4 * key + k] * turns[4 * key - 4 + k]);
            Assert.That(way, Is.LessThan(0.012), $"metres, key {key}");
            Assert.That(cosine, Is.GreaterThan(Math.Cos(0.5 * 0.25)), $"key {key}");
        }
    }

    // An abdomen goes with the flap: the same way in a loop and on the way to the spot.
    [Test]
    public void TheAbdomen_SwingsWithTheWingsAsInALoop()
    {
        double loop = Together("cruise", 1.0), way = Together("land", 1.0 / 3.0);

        Assert.That(Math.Abs(loop), Is.GreaterThan(0.3));
        Assert.That(way * loop, Is.GreaterThan(0.05), $"{way}, {loop}");
    }

    [Test]
    public void TheAbdomen_SwingsInFlight_AndHangsStillWhereItSits()
    {
        double[] turns = Track("land", NodeOf("Abdomen"), "rotation").Values;
        double[] angles =
            [.. Enumerable.Range(0, turns.Length / 4).Select(key => 2.0 * Math.Acos(Math.Min(1.0, Math.Abs(turns[4 * key + 3]))))];

        Assert.That(angles[..(angles.Length / 3)].Max(), Is.InRange(0.03, 0.3), "radians");
        Assert.That(angles[^1], Is.LessThan(0.01));
    }

    [Test]
    public void ALoopBeside_StaysWhereItIs()
    {
        using var gltf = JsonDocument.Parse(new GlbFile(File.ReadAllBytes(Glb())).Root.GetRawText());
        JsonElement loop = gltf.RootElement.GetProperty("animations").EnumerateArray()
            .Single(one => one.GetProperty("name").GetString() == "cruise");

        Assert.That(
            loop.GetProperty("channels").EnumerateArray().Select(one => one.GetProperty("target").GetProperty("node").GetInt32()),
            Has.No.Member(0), "the root");
    }

    [Test]
    public void UsdHasTheSameWay([Values("land", "take-off")] string clip)
    {
        string folder = m_Files.Folder(k_Bake + " --format usd");
        var file = new UsdaFile(Path.Combine(folder, "monarch_usd", "monarch.usda"));
        string path = $"/monarch/joints/{clip.Replace('-', '_')}";
        (double Time, float[] Numbers)[] places = file.Samples(path + ".translations");
        double[] wanted = Root(clip, "translation").Values;

        Assert.That(places, Has.Length.EqualTo(wanted.Length / 3));
        for (int key = 0; key < places.Length; key++)
        {
            Assert.That(places[key].Time, Is.EqualTo(key).Within(1e-4));
            for (int k = 0; k < 3; k++)
                Assert.That(places[key].Numbers[k], Is.EqualTo(wanted[3 * key + k]).Within(1e-6), $"key {key}");
        }
    }

    [Test]
    public void TheExtentOfAFile_OfSuchAClipAlone_HoldsItsWay()
    {
        string folder = m_Files.Folder("monarch --variant flight --clips land --frames 8 --format usd");
        string extent = File.ReadLines(Path.Combine(folder, "monarch_usd", "monarch.usda")).First(line => line.Contains("extent"));
        double[] numbers = [.. extent[(extent.IndexOf('=') + 1)..].Split('[', ']', '(', ')', ',', ' ')
            .Where(word => word.Length > 0).Select(word => double.Parse(word, CultureInfo.InvariantCulture))];

        Assert.That(numbers, Has.Length.EqualTo(6).And.All.Matches<double>(number => Math.Abs(number) < 1.0));
        Assert.That(numbers[2], Is.LessThan(-0.15), "behind the spot");
        Assert.That(numbers[4], Is.GreaterThan(0.2), "above it");
    }

    [TestCase("monarch --clips land",
        "Clip 'land' is played by an insect that flies by its own wings: add --variant flight, and no --mesh.")]
    [TestCase("monarch --clips Take-Off --variant flight",
        "Clip 'take-off' goes from one place to another: add --format gltf-skin or --format usd, whose joints move.")]
    [TestCase("monarch --clips land,land --variant flight --format usd", "Clip 'land' is asked for twice.")]
    [TestCase("firefly --clips land --variant flight --format usd --frames 240",
        "Clips that play once would have more than 20000 frames: take fewer --frames than 240.")]
    [TestCase("snailfish --clips land --variant flight --format usd --frames 4",
        "Clip 'land' cannot be played: snailfish is Landing after 30.0 s. Only insects that land have it.")]
    public void WhatCannotBePlayed_IsOneLine(string arguments, string message)
    {
        using var run = new CommandRun();

        Assert.That(run.Run([.. $"bake {arguments}".Split(' '), "--out", run.Out]), Is.EqualTo(2));
        Assert.That(run.Errors.Trim(), Is.EqualTo($"alate: {message}"));
        Assert.That(Directory.Exists(run.Out), Is.False);
    }

    private string Glb() => Path.Combine(m_Files.Folder(k_Bake + " --format gltf-skin"), "monarch-skin.glb");

    private float3[][] Frames(string clip) =>
        [.. Enumerable.Range(0, k_Frames).Select(k => m_Played.Play(clip, k * m_Played.Length(clip) / (k_Frames - 1)).Positions)];

    private int NodeOf(string name) => Array.FindIndex(
        [.. new GlbFile(File.ReadAllBytes(Glb())).Root.GetProperty("nodes").EnumerateArray()],
        node => node.GetProperty("name").GetString().Contains(name));

    // Correlation of the abdomen's pitch with the flap of the right wing's leading edge over the first keys of a clip.
    private double Together(string clip, double share)
    {
        double[] abdomen = Track(clip, NodeOf("Abdomen"), "rotation").Values, wing = Track(clip, NodeOf("Right 1.1"), "rotation").Values;
        int keys = (int)(share * abdomen.Length / 4);
        double[] pitch = [.. Enumerable.Range(0, keys).Select(key => abdomen[4 * key] * Math.Sign(abdomen[4 * key + 3]))],
            flap = [.. Enumerable.Range(0, keys).Select(key => wing[4 * key + 2] * Math.Sign(wing[4 * key + 3]))];
        double p = pitch.Average(), f = flap.Average();
        return pitch.Zip(flap, (a, b) => (a - p) * (b - f)).Sum()
            / Math.Sqrt(pitch.Sum(a => (a - p) * (a - p)) * flap.Sum(b => (b - f) * (b - f)));
    }

    // The first node is the root.
    private (double[] Times, double[] Values) Root(string clip, string path) => Track(clip, 0, path);

    private (double[] Times, double[] Values) Track(string clip, int node, string path)
    {
        var file = new GlbFile(File.ReadAllBytes(Glb()));
        JsonElement animation = file.Root.GetProperty("animations").EnumerateArray()
            .Single(one => one.GetProperty("name").GetString() == clip);
        JsonElement channel = animation.GetProperty("channels").EnumerateArray().Single(one =>
            one.GetProperty("target").GetProperty("node").GetInt32() == node
            && one.GetProperty("target").GetProperty("path").GetString() == path);
        JsonElement sampler = animation.GetProperty("samplers")[channel.GetProperty("sampler").GetInt32()];
        return (file.Read(sampler.GetProperty("input").GetInt32()), file.Read(sampler.GetProperty("output").GetInt32()));
    }
}
