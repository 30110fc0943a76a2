using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Formats;
using Alate.Tests.Cli;
using Alate.Tests.Views;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Bakes;

/// <summary>USD files that <c>bake</c> writes, played as UsdSkel says, beside the glTF files of the same bakes.</summary>
[Explicit]
[Category("Long")]
[Category("Faults")]
public sealed class BakedUsdTests : BakedFilesFixture
{
    private const string k_Clips = "--clips cruise,hover";

    private static IEnumerable<string> Species => InsectCatalogue.Names;

    [Test]
    public void Joints_MoveTheCornersAsThoseOfTheGltf()
    {
        UsdaFile file = Open("monarch");
        var gltf = new GltfPlayer(File.ReadAllBytes(Gltf("monarch")));
        var raw = new GlbFile(File.ReadAllBytes(Gltf("monarch")));
        int[] corners = [.. raw.Root.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray()
            .SelectMany(part => raw.Read(part.GetProperty("indices").GetInt32())).Select(corner => (int)corner)];
        double rate = double.Parse(file.Text("/.timeCodesPerSecond"), CultureInfo.InvariantCulture);
        foreach (string clip in new[] { "cruise", "hover" })
        {
            string path = $"/monarch/joints/{clip}";
            (double Time, float[] Numbers)[] turns = file.Samples(path + ".rotations"), places = file.Samples(path + ".translations");
            Assert.That(turns.Select(key => key.Time), Is.EqualTo(places.Select(key => key.Time)));
            Assert.That(turns[^1].Time / rate, Is.EqualTo(gltf.Length(clip)).Within(1e-6));
            Assert.That(places[^1].Numbers, Is.EqualTo(places[0].Numbers), "a loop closes");
            foreach (int key in new[] { 0, 7, 24, 41, 47 })
            {
                float3[] wanted = gltf.Play(clip, turns[key].Time / rate).Positions;
                float3[] played = Play(file, turns[key].Numbers, places[key].Numbers);
                Assert.That(played, Has.Length.EqualTo(corners.Length));
                for (int k = 0; k < corners.Length; k++)
                    Assert.That(math.distance(played[k], wanted[corners[k]]), Is.LessThan(1e-6f), $"metres, {clip}, frame {key}");
            }
        }
    }

    // glTF's texture coordinates begin at the top.
    [Test]
    public void Corners_HaveTheNormals_TextureCoordinatesAndColours_OfTheGltf()
    {
        UsdaFile file = Open("monarch");
        var gltf = new GlbFile(File.ReadAllBytes(Gltf("monarch")));
        JsonElement[] parts = [.. gltf.Root.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray()];
        string[] meshes = file.Of("Mesh");
        Assert.That(meshes, Has.Length.EqualTo(parts.Length));
        int coloured = 0;
        for (int part = 0; part < parts.Length; part++)
        {
            JsonElement attributes = parts[part].GetProperty("attributes");
            int[] theirs = [.. gltf.Read(parts[part].GetProperty("indices").GetInt32()).Select(corner => (int)corner)];
            int[] ours = [.. file.Numbers(meshes[part] + ".faceVertexIndices").Select(corner => (int)corner)];
            bool hasColours = attributes.TryGetProperty("COLOR_0", out _);
            Assert.That(file.Has(meshes[part] + ".primvars:displayColor"), Is.EqualTo(hasColours));
            Assert.That(Corners(file.Numbers(meshes[part] + ".normals"), 3, ours),
                Is.EqualTo(Corners(Of("NORMAL"), 3, theirs)).Within(1e-6));
            Assert.That(Corners(file.Numbers(meshes[part] + ".primvars:st"), 2, ours),
                Is.EqualTo(Corners(Of("TEXCOORD_0"), 2, theirs).Select((value, k) => k % 2 == 0 ? value : 1f - value)).Within(1e-6));
            if (!hasColours)
                continue;
            coloured++;
            float[] light = [.. Corners(Of("COLOR_0"), 4, theirs).Where((_, k) => k % 4 < 3)];
            Assert.That(Corners(file.Numbers(meshes[part] + ".primvars:displayColor"), 3, ours), Is.EqualTo(light).Within(1e-4));

            float[] Of(string name) => [.. gltf.Read(attributes.GetProperty(name).GetInt32()).Select(value => (float)value)];
        }

        Assert.That(coloured, Is.Positive);
    }

    [Test]
    public void EveryPath_LeadsSomewhere_AndEveryPictureIsThere()
    {
        foreach (string species in new[] { "monarch", "dragonfly" })
        {
            UsdaFile file = Open(species);
            Assert.That(file.Targets.Where(path => !file.Has(path)), Is.Empty, species);
            string[] pictures = [.. file.Of("Shader").Select(shader => file.Text(shader + ".inputs:file")).Where(text => text != null)];
            string folder = Path.Combine(Files.Folder($"{species} {k_Clips} --format usd"), species + "_usd");
            Assert.That(pictures, Is.Not.Empty);
            Assert.That(pictures.Select(picture => picture.Trim('@')[2..]).Append(species + ".usda"),
                Is.EquivalentTo(Directory.GetFiles(folder).Select(Path.GetFileName)));
        }
    }

    [Test]
    public void TheFile_SaysItsUnits_AndNamesTheFirstClip()
    {
        UsdaFile file = Open("monarch");

        Assert.That(file.Text("/.metersPerUnit"), Is.EqualTo("1"));
        Assert.That(file.Text("/.upAxis"), Is.EqualTo("\"Y\""));
        Assert.That(file.Text("/monarch/joints.skel:animationSource"), Is.EqualTo("</monarch/joints/cruise>"));
        Assert.That(file.Samples("/monarch/joints/cruise.rotations").Select(key => key.Time), Is.EqualTo(Enumerable.Range(0, 49)));
        double end = double.Parse(file.Text("/.endTimeCode"), CultureInfo.InvariantCulture);
        Assert.That(end, Is.EqualTo(file.Samples("/monarch/joints/hover.rotations")[^1].Time).Within(1e-6).And.GreaterThan(48));
        foreach (string mesh in file.Of("Mesh"))
        {
            float3[] extent = file.Vectors(mesh + ".extent"), points = file.Vectors(mesh + ".points");
            Assert.That(extent[0], Is.EqualTo(points.Aggregate(math.min)));
            Assert.That(extent[1], Is.EqualTo(points.Aggregate(math.max)));
        }
    }

    // A body has colours a vertex, which count light; a membrane is seen through by its picture.
    [Test]
    public void ABody_ShowsItsColours_AndAMembraneItsOpacity()
    {
        UsdaFile monarch = Open("monarch"), dragonfly = Open("dragonfly");
        float[] light = monarch.Numbers("/monarch/Body.primvars:displayColor");
        Assert.That(light, Has.Length.EqualTo(3 * monarch.Vectors("/monarch/Body.points").Length));
        Assert.That(light, Is.All.InRange(0f, 1f));
        Assert.That(light.Distinct().Count(), Is.GreaterThan(3));
        string[] cut = [.. monarch.Of("Shader").Where(shader => monarch.Has(shader + ".inputs:opacity.connect"))];
        Assert.That(cut.Select(shader => monarch.Text(shader + ".inputs:opacityThreshold")), Is.Not.Empty.And.All.EqualTo("0.5"));
        Assert.That(dragonfly.Of("Shader").Where(shader => dragonfly.Has(shader + ".inputs:opacityThreshold")), Is.Empty);
        string[] seenThrough = [.. dragonfly.Of("Shader").Select(shader => dragonfly.Text(shader + ".inputs:opacity.connect"))
            .Where(path => path != null)];
        Assert.That(seenThrough, Is.Not.Empty.And.All.EndsWith("/colour.outputs:a>"));
        Assert.That(FileColours.Linear(0), Is.Zero);
        Assert.That(FileColours.Linear(255), Is.EqualTo(1).Within(1e-12));
        Assert.That(FileColours.Linear(188), Is.EqualTo(0.503).Within(1e-3), "half the light");
    }

    [TestCase("Wing Right", "Wing_Right")]
    [TestCase("3rd", "_3rd")]
    [TestCase("Flügel", "Fl_gel")]
    [TestCase("", "_")]
    public void Names_AreThoseThatAPrimMayHave(string text, string name) => Assert.That(UsdaWriter.Name(text), Is.EqualTo(name));

    [Test]
    public void TheExtent_HoldsTheCornersOfAllMeshes()
    {
        UsdaFile file = Open("monarch");
        float3[] extent = file.Vectors("/monarch.extent");

        Assert.That(extent, Has.Length.EqualTo(2));
        foreach (float3 corner in file.Of("Mesh").SelectMany(mesh => file.Vectors(mesh + ".points")))
            Assert.That(math.all(corner >= extent[0] - 1e-6f) && math.all(corner <= extent[1] + 1e-6f), Is.True, $"{corner}");
    }

    [Test]
    public void ANameThatIsUsed_GetsANumber()
    {
        var used = new HashSet<string>();

        Assert.That(
            new[] { "wing 1", "wing.1", "wing-1" }.Select(text => UsdaWriter.Unused(text, used)),
            Is.EqualTo(new[] { "wing_1", "wing_1_2", "wing_1_3" }));
        Assert.That(UsdaWriter.Text("a \"b\" \\c"), Is.EqualTo("\"a \\\"b\\\" \\\\c\""));
        Assert.That(UsdaWriter.Tuple(new quaternion(1f, 2f, 3f, 4f)), Is.EqualTo("(4, 1, 2, 3)"));
    }

    [TestCaseSource(nameof(Species))]
    [Explicit]
    [Category("Long")]
    public void ThreeJs_PlaysItAsTheGltf(string species)
    {
        WebTools.NeedChromium();
        WebTools.NeedNode();
        string folder = Files.Folder($"{species} {k_Clips} --format usd");

        (int code, string output) = WebTools.Run(
            "usd.mjs", WebTools.Chromium, folder, Path.Combine(folder, species + "_usd", species + ".usda"), Gltf(species)).Result;

        Assert.That(code, Is.Zero, output);
        JsonElement read = JsonDocument.Parse(output).RootElement;
        Assert.That(read.GetProperty("clips").EnumerateArray().Select(clip => clip.GetString()), Is.EqualTo(new[] { "cruise", "hover" }));
        Assert.That(read.GetProperty("farthest").GetDouble(), Is.LessThan(1e-6), "metres");
        Assert.That(read.GetProperty("longer").GetDouble(), Is.LessThan(1e-5), "seconds");
    }

    private UsdaFile Open(string species) =>
        new(Path.Combine(Files.Folder($"{species} {k_Clips} --format usd"), species + "_usd", species + ".usda"));

    private string Gltf(string species) =>
        Path.Combine(Files.Folder($"{species} {k_Clips} --format gltf-skin"), species + "-skin.glb");

    private static float[] Corners(float[] numbers, int each, int[] vertices) =>
        [.. vertices.SelectMany(vertex => numbers[(each * vertex)..(each * vertex + each)])];

    // Places of all corners of triangles, mesh by mesh: a vertex follows its joints by how far these are from where they were bound.
    private static float3[] Play(UsdaFile file, float[] turns, float[] places)
    {
        string[] joints = file.Words("/monarch/joints.joints");
        float4x4[] bound = [.. file.Numbers("/monarch/joints.bindTransforms").Chunk(16).Select(Matrix)];
        var moved = new float4x4[joints.Length];
        for (int k = 0; k < joints.Length; k++)
        {
            var turn = new quaternion(turns[4 * k + 1], turns[4 * k + 2], turns[4 * k + 3], turns[4 * k]);
            var local = float4x4.TRS(new float3(places[3 * k], places[3 * k + 1], places[3 * k + 2]), turn, 1f);
            int parent = Array.IndexOf(joints, Path.GetDirectoryName(joints[k])?.Replace('\\', '/'));
            moved[k] = parent < 0 ? local : math.mul(moved[parent], local);
        }

        for (int k = 0; k < joints.Length; k++)
            moved[k] = math.mul(moved[k], math.inverse(bound[k]));
        var corners = new List<float3>();
        foreach (string mesh in file.Of("Mesh"))
        {
            float3[] points = file.Vectors(mesh + ".points");
            float[] of = file.Numbers(mesh + ".primvars:skel:jointIndices"), shares = file.Numbers(mesh + ".primvars:skel:jointWeights");
            Assert.That(file.Numbers(mesh + ".faceVertexCounts"), Is.All.EqualTo(3f));
            foreach (int vertex in file.Numbers(mesh + ".faceVertexIndices").Select(index => (int)index))
            {
                float3 place = 0f;
                for (int k = 4 * vertex; k < 4 * vertex + 4; k++)
                    place += shares[k] * math.transform(moved[(int)of[k]], points[vertex]);
                corners.Add(place);
            }
        }

        return [.. corners];
    }

    // Rows as they are written: what it moves by stands in the last.
    private static float4x4 Matrix(float[] rows) => math.transpose(new float4x4(
        rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7],
        rows[8], rows[9], rows[10], rows[11], rows[12], rows[13], rows[14], rows[15]));
}
