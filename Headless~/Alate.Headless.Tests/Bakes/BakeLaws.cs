using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Crowds;
using Alate.Tests.Cli;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using OwnWing = Alate.Tests.Cli.OwnWing;

namespace Alate.Tests.Bakes;

/// <summary>Content of baked files beside their shapes: looks, coordinates, joints and times, each beside the bake.</summary>
public sealed class BakeLaws
{
    private readonly InsectDefinition m_Insect = InsectCatalogue.Find("fishfly");
    private InsectBake m_Bake;

    [OneTimeSetUp]
    public void Bake() => m_Bake = new BakePlan
    {
        Species = m_Insect,
        Motions = [BakeMotion.Find("cruise"), BakeMotion.Find("rest")],
        Frames = 6,
    }.Bake(out _);

    [TestCase("skin")]
    [TestCase("morph")]
    public void EachPart_HasItsLookItsCornersAndItsCoordinates(string form)
    {
        GlbFile file = File(form);
        JsonElement[] primitives = [.. file.Root.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray()];
        Assert.That(primitives, Has.Length.EqualTo(m_Bake.Surface.Parts.Count));
        Assert.That(file.Root.GetProperty("meshes")[0].GetProperty("name").GetString(), Is.EqualTo("fishfly"));
        Assert.That(file.Root.GetProperty("materials").GetArrayLength(), Is.EqualTo(m_Bake.Surface.Parts.Distinct().Count()));
        for (int k = 0; k < primitives.Length; k++)
        {
            BakedPart part = m_Bake.Surface.Parts[k];
            JsonElement look = file.Root.GetProperty("materials")[primitives[k].GetProperty("material").GetInt32()],
                attributes = primitives[k].GetProperty("attributes");
            bool isGlass = part.HasColours && part.Triangles.Any(vertex => m_Bake.Surface.Colours[vertex].a < 255);
            Assert.That((look.GetProperty("name").GetString(), look.GetProperty("alphaMode").GetString()),
                Is.EqualTo((part.Name, isGlass ? "BLEND" : "OPAQUE")));
            // glTF's axes turn every triangle round.
            int[] told = [.. file.Read(primitives[k].GetProperty("indices").GetInt32()).Select(index => (int)index)];
            Assert.That(told.Chunk(3).Select(Turned),
                Is.EqualTo(part.Triangles.Chunk(3).Select(corners => Turned([corners[0], corners[2], corners[1]]))));
            double[] uvs = file.Read(attributes.GetProperty("TEXCOORD_0").GetInt32());
            Assert.That(uvs, Is.EqualTo(m_Bake.Surface.Uvs.SelectMany(uv => new double[] { uv.x, 1f - uv.y })).Within(1e-6));
            WingDefinition wing =
                m_Insect.Wings.FirstOrDefault(kind => part.Name.StartsWith(kind.Name, StringComparison.OrdinalIgnoreCase));
            bool isPainted = look.GetProperty("pbrMetallicRoughness").TryGetProperty("baseColorTexture", out JsonElement texture);
            Assert.That(isPainted, Is.EqualTo(wing != null), "a wing has its painting");
            if (isPainted)
            {
                Assert.That(attributes.TryGetProperty("COLOR_0", out _), Is.False, "colours of vertices would darken it");
                int source = file.Root.GetProperty("textures")[texture.GetProperty("index").GetInt32()].GetProperty("source").GetInt32();
                Assert.That(file.Image(source).SequenceEqual(WingPainting.Of(wing).Png));
                continue;
            }

            double[] colours = file.Read(attributes.GetProperty("COLOR_0").GetInt32());
            for (int vertex = 0; vertex < m_Bake.Surface.VertexCount; vertex += 7)
            {
                Color32 own = m_Bake.Surface.Colours[vertex];
                Assert.That(colours[4 * vertex + 3], Is.EqualTo(own.a / 255.0).Within(1e-4));
                Assert.That(colours[4 * vertex], Is.EqualTo(Math.Pow((own.r / 255.0 + 0.055) / 1.055, 2.4)).Within(3e-3), "linear light");
            }
        }

        static (int, int, int) Turned(int[] corners)
        {
            int first = Array.IndexOf(corners, corners.Min());
            return (corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]);
        }
    }

    [TestCase("skin")]
    [TestCase("morph")]
    public void EachClip_IsAnAnimation_AsLongAsItsLoop_ThatEndsAsItBegins(string form)
    {
        GlbFile file = File(form);
        JsonElement[] animations = [.. file.Root.GetProperty("animations").EnumerateArray()];
        Assert.That(animations.Select(animation => animation.GetProperty("name").GetString()), Is.EqualTo(new[] { "cruise", "rest" }));
        for (int clip = 0; clip < 2; clip++)
        {
            foreach (JsonElement sampler in animations[clip].GetProperty("samplers").EnumerateArray())
            {
                double[] times = file.Read(sampler.GetProperty("input").GetInt32()),
                    values = file.Read(sampler.GetProperty("output").GetInt32());
                int frames = m_Bake.Clips[clip].Frames.Count, width = values.Length / (frames + 1);
                Assert.That(times, Is.EqualTo(Enumerable.Range(0,
                    frames + 1).Select(k => k / (frames * (double)m_Bake.Clips[clip].Frequency))).Within(1e-6));
                double sign = Math.Sign(values[..width].Zip(values[^width..], (a, b) => a * b).Sum() + 1e-30);
                Assert.That(values[^width..].Select(value => sign * value), Is.EqualTo(values[..width]).Within(1e-6));
            }
        }
    }

    [Test]
    public void Joints_HangOnTheirChains_AtTheirRest_AndVerticesHaveTheirShares()
    {
        GlbFile file = File("skin");
        JsonElement[] nodes = [.. file.Root.GetProperty("nodes").EnumerateArray()];
        JsonElement skin = file.Root.GetProperty("skins")[0];
        int[] joints = [.. skin.GetProperty("joints").EnumerateArray().Select(joint => joint.GetInt32())];
        double[] binds = file.Read(skin.GetProperty("inverseBindMatrices").GetInt32());
        int mesh = Array.FindIndex(nodes, node => node.TryGetProperty("mesh", out _)), root = skin.GetProperty("skeleton").GetInt32();

        Assert.That((nodes[root].GetProperty("name").GetString(), joints[0], nodes[mesh].GetProperty("skin").GetInt32()),
            Is.EqualTo(("root", root, 0)));
        Assert.That(skin.GetProperty("name").GetString(), Is.EqualTo("fishfly"));
        Assert.That(file.Root.GetProperty("scenes")[0].GetProperty("nodes").EnumerateArray().Select(node => node.GetInt32()),
            Is.EquivalentTo(new[] { root, mesh }));
        Assert.That(nodes[root].GetProperty("children").EnumerateArray().Select(child =>
            nodes[child.GetInt32()].GetProperty("name").GetString()),
            Is.EqualTo(m_Bake.Wings.Select(wing => wing.Name)));
        foreach (BakedWing wing in m_Bake.Wings)
        {
            for (int k = 0; k < wing.RestJoints.Length; k++)
            {
                int own = 1 + wing.FirstJoint + k, node = joints[own], along = k % wing.JointsPerChain;
                float3 rest = wing.RestJoints[k] * new float3(-1f, 1f, 1f) * m_Bake.MetresPerUnit,
                    before = along == 0 ? 0f : wing.RestJoints[k - 1] * new float3(-1f, 1f, 1f) * m_Bake.MetresPerUnit;
                double[] told = [.. nodes[node].GetProperty("translation").EnumerateArray().Select(number => number.GetDouble())];
                Assert.That(nodes[node].GetProperty("name").GetString(),
                    Is.EqualTo($"{wing.Name} {k / wing.JointsPerChain + 1}.{along + 1}"));
                for (int axis = 0; axis < 3; axis++)
                {
                    Assert.That(told[axis], Is.EqualTo(rest[axis] - before[axis]).Within(1e-7));
                    Assert.That(binds[16 * own + 12 + axis], Is.EqualTo(-rest[axis]).Within(1e-7));
                }

                int parent = Array.FindIndex(nodes, candidate => candidate.TryGetProperty("children", out JsonElement children)
                    && children.EnumerateArray().Any(child => child.GetInt32() == node));
                Assert.That(nodes[parent].GetProperty("name").GetString(),
                    Is.EqualTo(along == 0 ? wing.Name : $"{wing.Name} {k / wing.JointsPerChain + 1}.{along}"));
                Assert.That(nodes[node].TryGetProperty("children", out _), Is.EqualTo(along < wing.JointsPerChain - 1));
            }
        }

        JsonElement attributes = file.Root.GetProperty("meshes")[0].GetProperty("primitives")[0].GetProperty("attributes");
        double[] of = file.Read(attributes.GetProperty("JOINTS_0").GetInt32()),
            shares = file.Read(attributes.GetProperty("WEIGHTS_0").GetInt32());
        var onWings = m_Bake.Wings.SelectMany(wing => wing.Vertices.Select((vertex, k) => (vertex, wing,
            k))).ToDictionary(one => one.vertex);
        for (int vertex = 0; vertex < m_Bake.Surface.VertexCount; vertex++)
        {
            double[] own = shares[(4 * vertex)..(4 * vertex + 4)], at = of[(4 * vertex)..(4 * vertex + 4)];
            Assert.That(own.Sum(), Is.EqualTo(1.0).Within(1e-5));
            if (!onWings.TryGetValue(vertex, out (int, BakedWing Wing, int K) one))
            {
                Assert.That((own[0], at.Sum()), Is.EqualTo((1.0, 0.0)), "the body hangs on the root");
                continue;
            }

            for (int c = 0; c < 4; c++)
            {
                Assert.That(own[c], Is.EqualTo(one.Wing.VertexWeights[one.K][c] / math.csum(one.Wing.VertexWeights[one.K])).Within(1e-5));
                Assert.That(at[c], Is.EqualTo(own[c] == 0.0 ? 0 : one.Wing.VertexJoints[one.K][c] + one.Wing.FirstJoint + 1));
            }
        }
    }

    // 24 frames a second, two beats: keys at whole frames of 1/24 s, and the last one after half a second.
    [Test]
    public void ASlowBeat_ClosesOnAWholeFrame()
    {
        var plan = new BakePlan
        {
            Species = m_Insect,
            Motions = [BakeMotion.Find("cruise"), BakeMotion.Find("rest")],
            Frames = BakePlan.FramesOf(24, 2),
            BeatsPerSecond = 2
        };
        InsectBake bake = plan.Bake(out _);
        using var stream = new MemoryStream();
        SkinGlb.Write(bake, plan.Pictures, stream);
        var file = new GlbFile(stream.ToArray());
        JsonElement sampler = file.Root.GetProperty("animations")[0].GetProperty("samplers")[0];

        Assert.That(file.Read(sampler.GetProperty("input").GetInt32()),
            Is.EqualTo(Enumerable.Range(0, 13).Select(k => k / 24.0)).Within(1e-6));
        Assert.That(bake.Clips.Select(clip => (clip.Frames.Count, clip.Frequency)), Is.EqualTo(new[]
        {
            (12, 2f), (1, m_Bake.Clips[1].Frequency)
        }));
    }

    [TestCase("wing right")]
    [TestCase("Wing Left")]
    public void AWingOfTheUsersOwn_HasItsPicture_OnBothSides(string name)
    {
        byte[] png = WingPainting.Of(m_Insect.Wings[0]).Png;
        var part = new BakedPart(name, null, true, []);
        Assert.That(new BakePictures(new WingFiles(null, null, png)).Of(part).Png, Is.SameAs(png));
        Assert.That(new BakePictures(new WingFiles(null, null, null)).Of(part), Is.Null);
        Assert.That(new BakePictures(m_Insect).Of(part), Is.Null, "a fishfly has fore and hind wings");
    }

    [Test]
    public void AnInsectAtRestAlone_IsAMesh_ThatNothingMoves()
    {
        InsectBake bake = new BakePlan { Species = m_Insect, Motions = [BakeMotion.Find("rest")] }.Bake(out _);
        using var stream = new MemoryStream();
        MorphGlb.Write(bake, new BakePictures(m_Insect), stream);
        JsonElement root = new GlbFile(stream.ToArray()).Root;
        Assert.That(root.TryGetProperty("animations", out _), Is.False);
        Assert.That(root.GetProperty("meshes")[0].TryGetProperty("weights", out _), Is.False);
        Assert.That(root.GetProperty("meshes")[0].GetProperty("primitives")[0].TryGetProperty("targets", out _), Is.False);
    }

    [Test]
    public void TheReport_TellsTheInsect_ItsClips_AndHowFarASmallerMeshIs()
    {
        using var run = new CommandRun();
        Assert.That(run.Run("bake", "monarch", "--frames", "4", "--triangles", "160", "--format", "gltf-morph", "--out", run.Out), Is.Zero,
            run.Errors);
        InsectBake bake = new BakePlan { Species = InsectCatalogue.Find("monarch"), Frames = 4, Triangles = 160 }.Bake(out float error);
        Match told = Regex.Match(run.Output, @"The smaller mesh is ([\d.]+) % of the wing length");

        Assert.That(error, Is.GreaterThan(0.001f));
        Assert.That(double.Parse(told.Groups[1].Value, CultureInfo.InvariantCulture), Is.EqualTo(100 * error).Within(0.0051));
        Assert.That(run.Output, Does.Contain($"Monarch: {bake.Surface.VertexCount} vertices, {bake.Surface.TriangleCount} triangles"));
        Assert.That(run.Output.ReplaceLineEndings("\n"), Does.EndWith($"Written:\n  {Path.Combine(run.Out, "monarch-morph.glb")}\n"));
        Assert.That(Directory.GetFiles(run.Out, "*", SearchOption.AllDirectories), Has.Length.EqualTo(1));
    }

    // A wing of one's own is baked where the flight on the spot has it at rest.
    [TestCase(WingSide.Right)]
    [TestCase(WingSide.Left)]
    public void AWingOfTheUsersOwn_RestsWhereItIsFlown(WingSide side)
    {
        using var run = new CommandRun();
        string mesh = run.Write("wing.obj", OwnWing.Obj(side: side)), skeleton = run.Write("wing.json", OwnWing.Skeleton(side));
        InsectBake bake = new BakePlan
        {
            Species = InsectCatalogue.Find("fishfly"),
            MeshFile = mesh,
            SkeletonFile = skeleton,
            Frames = 4
        }.Bake(out _);
        var plan = new FlightPlan { Species = "fishfly", MeshFile = mesh, SkeletonFile = skeleton };
        using var wings = new TetheredWings(plan, Insect.Of(plan));
        float3[] baked = [.. bake.Surface.Positions.Select(place => (float3)place * bake.MetresPerUnit)],
            flown = [.. wings.All.SelectMany(wing => wing.Rest.Select(wing.Placement.ToBody))];

        Assert.That(baked, Has.Length.EqualTo(flown.Length));
        Assert.That(bake.Wings.Select(wing => wing.Side), Is.EquivalentTo(new[] { WingSide.Right, WingSide.Left }));
        Assert.That(bake.Name, Is.EqualTo("wing"));
        foreach (float3 place in flown)
            Assert.That(baked.Min(other => math.distance(place, other)), Is.LessThan(2e-5f), "metres");
        foreach (BakedWing wing in bake.Wings)
        {
            Assert.That(wing.Vertices.Average(vertex => baked[vertex].x),
                wing.Side == WingSide.Right ? Is.GreaterThan(0.005) : Is.LessThan(-0.005));
        }
    }

    private GlbFile File(string form)
    {
        using var stream = new MemoryStream();
        if (form == "skin")
            SkinGlb.Write(m_Bake, new BakePictures(m_Insect), stream);
        else
            MorphGlb.Write(m_Bake, new BakePictures(m_Insect), stream);
        return new GlbFile(stream.ToArray());
    }
}
