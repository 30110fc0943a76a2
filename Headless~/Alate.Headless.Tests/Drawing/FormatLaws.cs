using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json.Nodes;
using Alate.Formats;
using Alate.Tests.Bakes;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of files: what is written is read back, or is what its format says.</summary>
public sealed class FormatLaws
{
    [Test]
    public void AMesh_ComesBackFromItsFile_CornerByCorner([Values] bool hasMaterial)
    {
        var random = new System.Random(3);
        SurfaceMesh mesh = new()
        {
            positions = [.. Enumerable.Range(0, 5).Select(_ => new Vector3(Number(random), Number(random), Number(random)))],
            uvs = [.. Enumerable.Range(0, 5).Select(_ => new Vector2(Number(random), Number(random)))],
            triangles = [0, 1, 2, 3, 2, 1, 4, 0, 3],
        };
        using var stream = new MemoryStream();
        ObjWriter.Write(mesh, stream, hasMaterial ? "wing.mtl" : null, hasMaterial ? "paint" : null);
        string text = Encoding.UTF8.GetString(stream.ToArray());
        ObjMesh read = ObjReader.ReadTextured(new StringReader(text));

        Assert.That(read.Library, Is.EqualTo(hasMaterial ? "wing.mtl" : null));
        Assert.That(text.Contains("usemtl paint\n"), Is.EqualTo(hasMaterial));
        for (int corner = 0; corner < mesh.triangles.Length; corner++)
        {
            int own = mesh.triangles[corner], other = read.Triangles[corner];
            Assert.That(read.Positions[other], Is.EqualTo(mesh.positions[own]));
            Assert.That(read.Uvs[other], Is.EqualTo(mesh.uvs[own]));
            Assert.That(read.Normals[other], Is.EqualTo(Vector3.up));
        }
    }

    [Test]
    public void CellsOfATable_AreQuotedWhereTheyMustBe_AndComeBack()
    {
        string[][] rows = [["a", "b,c", "d \"e\""], ["1\n2", "", "°"], [",", "\"", "\n"]];
        using var stream = new MemoryStream();
        CsvTable.Write(stream, rows);
        string text = Encoding.UTF8.GetString(stream.ToArray());

        Assert.That(text, Is.EqualTo("a,\"b,c\",\"d \"\"e\"\"\"\n\"1\n2\",,°\n\",\",\"\"\"\",\"\n\"\n"));
        Assert.That(stream.CanWrite, Is.True, "left open");
    }

    [Test]
    public void APictureOfSixteenBits_HasItsPixels()
    {
        var random = new System.Random(5);
        var picture = new PngPicture(7, 4);
        double[,,] set = new double[7, 4, 3];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 7; column++)
            {
                var colour = new float3(1.4f * Number(random) - 0.2f, Number(random), Number(random));
                picture.Set(column, row, colour);
                for (int channel = 0; channel < 3; channel++)
                    set[column, row, channel] = Math.Clamp(colour[channel], 0f, 1f);
            }
        }

        using var stream = new MemoryStream();
        picture.Write(stream);
        var read = new WidePng(stream.ToArray());

        Assert.That((picture.Width, picture.Height, read.Width, read.Height), Is.EqualTo((7, 4, 7, 4)));
        for (int k = 0; k < 7 * 4 * 3; k++)
        {
            Assert.That(read[k % 7, k / 7 % 4, k / 28], Is.EqualTo(set[k % 7, k / 7 % 4, k / 28]).Within(0.51 / 65535.0));
        }
    }

    // Boxes of colours: as many as are asked for, each colour in the mean of those beside it, none farther than the boxes are wide.
    [Test]
    public void AFewColours_StandForMany_EachForItsOwnNeighbours()
    {
        Color32 ground = new(250, 250, 250, 255);
        // Three clouds, far apart in one channel each.
        Color32[] centres = [new(40, 40, 40, 255), new(200, 40, 40, 255), new(40, 200, 40, 255), new(40, 40, 200, 255)];
        var random = new System.Random(9);
        Color32[] pixels =
        [
            .. Enumerable.Range(0, 400).Select(k => new Color32((byte)(centres[k % 4].r + random.Next(4)),
                (byte)(centres[k % 4].g + random.Next(4)), (byte)(centres[k % 4].b + random.Next(4)), 255)),
        ];
        var table = new ColourTable(ground, pixels.Append(ground), 5);

        Assert.That(table.Colours, Has.Length.EqualTo(5));
        Assert.That(table.Colours[0], Is.EqualTo(ground));
        for (int cloud = 0; cloud < 4; cloud++)
        {
            Color32[] own = [.. pixels.Where((_, k) => k % 4 == cloud)];
            var mean = new Color32((byte)own.Average(pixel => pixel.r), (byte)own.Average(pixel => pixel.g),
                (byte)own.Average(pixel => pixel.b), 255);
            Assert.That(table.Colours, Has.Some.EqualTo(mean), "the mean of all that it stands for, rounded down");
            Assert.That(table.Colours[table.IndexOf(mean, 3, 3)], Is.EqualTo(mean));
        }

        Assert.That(new ColourTable(ground, [ground, ground], 5).Colours, Is.EqualTo(new[] { ground }));
        Assert.That(new ColourTable(ground, pixels, 3).Colours, Has.Length.EqualTo(3));
    }

    // Of two entries the nearer one; a colour between them is either by turns, in the share of its distance.
    [Test]
    public void AColourBetweenTwoEntries_IsShownAsBothByTurns_AndOneNearAnEntryAsThat()
    {
        Color32 dark = new(100, 100, 100, 255), light = new(112, 112, 112, 255);
        var table = new ColourTable(dark, [dark, light], 255);
        Assert.That(table.Colours, Is.EqualTo(new[] { dark, light }));
        for (int grey = 100; grey <= 112; grey++)
        {
            var colour = new Color32((byte)grey, (byte)grey, (byte)grey, 255);
            int[] shown = [.. Enumerable.Range(0, 16).Select(k => (int)table.IndexOf(colour, k % 4, k / 4))];
            if (grey <= 101 || grey >= 111)
                Assert.That(shown.Distinct().Count(), Is.EqualTo(1), $"{grey}: a sum of at most four off");
            else if (grey is >= 104 and <= 108)
                Assert.That(shown.Average(), Is.EqualTo((grey - 100) / 12.0).Within(0.3), $"{grey}");
            Assert.That(Enumerable.Range(0, 16).Select(k => (int)table.IndexOf(colour, 4 + k % 4, 8 + k / 4)), Is.EqualTo(shown),
                "every four pixels");
        }

        // Of the sixteen places of a pattern each has a threshold of its own, so that shares rise by steps (Bayer 1973).
        Color32 low = new(100, 100, 100, 255), high = new(122, 122, 122, 255);
        var wide = new ColourTable(low, [low, high], 255);
        int[] shares = [.. Enumerable.Range(105, 13).Select(grey => Enumerable.Range(0, 16)
            .Sum(k => wide.IndexOf(new Color32((byte)grey, (byte)grey, (byte)grey, 255), k % 4, k / 4)))];
        // (3 t - 23) / 4, towards nought, of the thresholds 0 to 15: how many shift a grey beyond the middle.
        int[] expected = [.. Enumerable.Range(105, 13).Select(grey => Enumerable.Range(0, 16).Count(t => grey + (3 * t - 23) / 4 > 111))];
        Assert.That(shares, Is.EqualTo(expected));
        int[,] order = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 }, { 3, 11, 1, 9 }, { 15, 7, 13, 5 } };
        for (int grey = 106; grey < 117; grey++)
        {
            for (int k = 0; k < 16; k++)
            {
                Assert.That(wide.IndexOf(new Color32((byte)grey, (byte)grey, (byte)grey, 255), k % 4, k / 4),
                    Is.EqualTo(grey + (3 * order[k % 4, k / 4] - 23) / 4 > 111 ? 1 : 0));
            }
        }

        // Four off in one channel is near, five is not; the threshold is that of all channels together.
        foreach ((int r, int g, int b) in new[] { (4, 0, 0), (0, 4, 0), (0, 0, 4), (-4, 0, 0), (0, -4, 0), (0, 0, -4), (1, -2, 1),
            (0, 2, -2) })
        {
            Assert.That(Shown(r, g, b), Has.Length.EqualTo(1), $"{r}, {g}, {b}");
        }

        var many = new ColourTable(dark, [dark, .. Enumerable.Range(0, 8).Select(Corner)], 255);
        foreach ((int r, int g, int b) in new[] { (5, 0, 0), (0, 5, 0), (0, 0, 5), (-3, 1, 1), (2, 2, -1) })
        {
            var colour = new Color32((byte)(100 + r), (byte)(100 + g), (byte)(100 + b), 255);
            Assert.That(Enumerable.Range(0, 16).Select(k => many.IndexOf(colour, k % 4, k / 4)).Distinct().Count(), Is.GreaterThan(1),
                $"{r}, {g}, {b}");
        }

        byte[] Shown(int r, int g, int b) => [.. Enumerable.Range(0, 16).Select(k =>
            table.IndexOf(new Color32((byte)(100 + r), (byte)(100 + g), (byte)(100 + b), 255), k % 4, k / 4)).Distinct()];
        static Color32 Corner(int k) => new((byte)(k % 2 == 0 ? 96 : 106), (byte)(k / 2 % 2 == 0 ? 96 : 106),
            (byte)(k / 4 == 0 ? 96 : 106), 255);
    }

    [Test]
    public void ColoursOfTheSmallestSteps_AreLinearInBothBranchesOfTheirCode()
    {
        var buffer = new GlbBuffer();
        buffer.AddColours([.. Enumerable.Range(0, 30).Select(k => new Color32((byte)k, (byte)(30 + k), 0, 255))]);
        byte[] told = buffer.ToArray();
        for (int k = 0; k < 30; k++)
        {
            // IEC 61966-2-1: straight up to 0.04045, which lies between ten and eleven of 255, a power beyond.
            double code = k / 255.0, light = k <= 10 ? code / 12.92 : Math.Pow((code + 0.055) / 1.055, 2.4);
            Assert.That(BitConverter.ToUInt16(told, 8 * k), Is.EqualTo(65535 * light).Within(0.51), $"{k}");
        }
    }

    // A frame has what changed since the one before, and nothing around it.
    [Test]
    public void AFrameOfAFilm_IsAsSmallAsWhatChanged()
    {
        Color32 ground = new(250, 250, 250, 255), spot = new(200, 30, 0, 255);
        Color32[] Frame(int left, int top, int right, int bottom) => [.. Enumerable.Range(0, 20 * 12).Select(k =>
            k % 20 >= left && k % 20 < right && k / 20 >= top && k / 20 < bottom ? spot : ground)];
        byte[] film = IndexedPng.Write(20, 12, [Frame(0, 0, 0, 0), Frame(5, 3, 9, 6), Frame(5, 3, 9, 6), Frame(5, 3, 20, 12)], 10, true,
            []);
        var frames = new List<(int, int, int, int)>();
        for (int at = 8; at < film.Length;)
        {
            int Number(int place) => System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(film.AsSpan(at + place));
            if (Encoding.ASCII.GetString(film, at + 4, 4) == "fcTL")
                frames.Add((Number(12), Number(16), Number(20), Number(24)));
            at += 12 + Number(0);
        }

        Assert.That(frames, Is.EqualTo(new[] { (20, 12, 0, 0), (4, 3, 5, 3), (1, 1, 0, 0), (15, 9, 5, 3) }), "width, height, left, top");
    }

    // The eye sees green best, then red.
    [TestCase(10, 0, 0, 0, 10, 0, true)]
    [TestCase(0, 0, 10, 10, 0, 0, true)]
    [TestCase(0, 10, 0, 0, 0, 14, false)]
    public void TheNearestEntry_IsTheOneThatTheEyeSeesNearest(int r, int g, int b, int otherR, int otherG, int otherB, bool isFirst)
    {
        Color32 one = new((byte)(96 + r), (byte)(96 + g), (byte)(96 + b), 255),
            other = new((byte)(96 + otherR), (byte)(96 + otherG), (byte)(96 + otherB), 255);
        var table = new ColourTable(new Color32(0, 0, 0, 255), [one, other], 255);
        var colour = new Color32(96, 96, 96, 255);
        int nearest = Enumerable.Range(0, 16).Select(k => (int)table.IndexOf(colour, k % 4,
            k / 4)).GroupBy(index => index).MaxBy(group => group.Count()).Key;

        Assert.That(table.Colours[nearest].Equals(isFirst ? one : other), Is.True);
    }

    [Test]
    public void AMembraneWithoutPaint_IsAPaleSolidBrown_AndPaintIsShownAsItIs()
    {
        double[] membrane = Factor(false), painted = Factor(true);

        Assert.That(painted, Is.EqualTo(new[] { 1.0, 1.0, 1.0, 1.0 }));
        Assert.That(membrane[3], Is.EqualTo(1.0), "solid");
        Assert.That(membrane[0] > membrane[1] && membrane[1] > membrane[2], Is.True);
        // The light of the pictures' membrane, less what lies on it.
        float3 pictures = Alate.Drawing.Shading.ToLinear(new float3(0.84f, 0.79f, 0.66f));
        for (int channel = 0; channel < 3; channel++)
            Assert.That(membrane[channel], Is.EqualTo(pictures[channel]).Within(10).Percent);

        static double[] Factor(bool isPainted)
        {
            JsonObject look = GltfMaterial.Of(isPainted, PictureOpacity.Clear, "name");
            Assert.That(((string)look["name"], (string)look["alphaMode"], (bool)look["doubleSided"]), Is.EqualTo(("name", "BLEND", true)));
            Assert.That((string)GltfMaterial.Of(isPainted, PictureOpacity.Solid, "name")["alphaMode"], Is.EqualTo("OPAQUE"));
            Assert.That((string)GltfMaterial.Of(isPainted, PictureOpacity.Cut, "name")["alphaMode"], Is.EqualTo("MASK"));
            JsonNode shown = look["pbrMetallicRoughness"];
            Assert.That(((double)shown["metallicFactor"], (double)shown["roughnessFactor"]), Is.EqualTo((0.0, 0.75)), "dull, no metal");
            return [.. shown["baseColorFactor"].AsArray().Select(value => (double)value)];
        }
    }

    [TestCase(true, false, "painted", false)]
    [TestCase(false, false, "membrane", false)]
    [TestCase(true, true, "glass", true)]
    public void PlainLooks_AreNamedForWhatTheyAre_AndMadeOnce(bool isPainted, bool isGlass, string name, bool blends)
    {
        var looks = new GlbLooks(new GlbBuffer());
        int first = looks.Plain(isPainted, isGlass);
        var gltf = new JsonObject();
        looks.WriteTo(gltf);

        Assert.That((first, looks.Plain(isPainted, isGlass), looks.Plain(!isPainted, isGlass)), Is.EqualTo((0, 0, 1)));
        Assert.That((string)gltf["materials"][0]["name"], Is.EqualTo(name));
        Assert.That((string)gltf["materials"][0]["alphaMode"], Is.EqualTo(blends ? "BLEND" : "OPAQUE"));
        Assert.That(gltf.ContainsKey("textures") || gltf.ContainsKey("extensionsUsed"), Is.False);
    }

    // Light passes a wing that is no glass; where all is glass the file does not ask for it.
    [Test]
    public void APicture_IsALookOfItsOwn_AndAsksForWhatItUses([Values(0, 1, 2)] int of)
    {
        var opacity = (PictureOpacity)of;
        bool isGlass = opacity == PictureOpacity.Clear;
        var buffer = new GlbBuffer();
        var looks = new GlbLooks(buffer);
        byte[] png = [1, 2, 3], other = [4, 5];
        int first = looks.Of(png, opacity, "fore"), second = looks.Of(other, opacity, "hind");
        var gltf = new JsonObject();
        looks.WriteTo(gltf);

        Assert.That((first, second, looks.Of(png, opacity, "fore")), Is.EqualTo((0, 1, 0)));
        for (int k = 0; k < 2; k++)
        {
            JsonNode look = gltf["materials"][k], image = gltf["images"][k];
            Assert.That((int)look["pbrMetallicRoughness"]["baseColorTexture"]["index"], Is.EqualTo(k));
            Assert.That(((int)gltf["textures"][k]["source"], (int)gltf["textures"][k]["sampler"]), Is.EqualTo((k, 0)));
            Assert.That(((string)image["name"], (string)image["mimeType"]), Is.EqualTo((k == 0 ? "fore" : "hind", "image/png")));
            Assert.That((long)buffer.Views[(int)image["bufferView"]]["byteLength"], Is.EqualTo(k == 0 ? 3 : 2));
            Assert.That(look["extensions"]?["KHR_materials_diffuse_transmission"]?["diffuseTransmissionFactor"] is { } passing
                && (double)passing is > 0.1 and < 0.9, Is.EqualTo(!isGlass));
        }

        // Linear between pixels and pictures of half the size, and no pixels of the other side at the edges.
        JsonNode sampler = gltf["samplers"][0];
        Assert.That(((int)sampler["magFilter"], (int)sampler["minFilter"], (int)sampler["wrapS"], (int)sampler["wrapT"]),
            Is.EqualTo((9729, 9987, 33071, 33071)));
        Assert.That(gltf.ContainsKey("extensionsUsed"), Is.EqualTo(!isGlass));
        if (!isGlass)
            Assert.That((string)gltf["extensionsUsed"][0], Is.EqualTo("KHR_materials_diffuse_transmission"));
    }

    // Numbers of the specification: what a vertex has, what names vertices, and neither.
    [Test]
    public void Views_SayWhatTheyAreFor()
    {
        var buffer = new GlbBuffer();
        buffer.AddVectors([0f]);
        buffer.AddIndices([0, 0, 0], 1);
        buffer.AddScalars([1f]);
        buffer.AddPairs([new float2(1f, 2f)]);
        buffer.AddFile([1]);
        buffer.AddQuadruples([new float4(1f)], isVertexData: true);

        Assert.That(buffer.Views.Select(view => (int?)view["target"]), Is.EqualTo(new int?[] { 34962, 34963, null, 34962, null, 34962 }));
    }

    [Test]
    public void Samples_AreThirtyTwoThousandthsOfOne_AndCutOffBeyond()
    {
        using var stream = new MemoryStream();
        WavFile.Write(stream, [0f, 1f, -1f, 0.5f, 1.5f, -40f], 8000);
        byte[] file = stream.ToArray();
        short[] samples = [.. Enumerable.Range(0, 6).Select(k => BitConverter.ToInt16(file, 44 + 2 * k))];

        Assert.That(file, Has.Length.EqualTo(44 + 12));
        Assert.That(samples, Is.EqualTo(new short[] { 0, 32767, -32767, 16384, 32767, -32767 }));
    }

    [Test]
    public void AxesOfFiles_KeepLengthsAndTurns_AndSwapTheHand()
    {
        var random = new System.Random(4);
        for (int k = 0; k < 20; k++)
        {
            float3 place = new(Number(random), Number(random), Number(random));
            quaternion turn = math.normalize(new quaternion(Number(random) - 0.5f, Number(random), Number(random) - 0.5f, Number(random)));
            float3 gltf = FileAxes.ToGltf(place), blender = FileAxes.ToBlender(place);

            Assert.That(gltf, Is.EqualTo(new float3(-place.x, place.y, place.z)));
            // Blender reads glTF's Y as Z, and its Z as -Y.
            Assert.That(blender, Is.EqualTo(new float3(gltf.x, -gltf.z, gltf.y)));
            Assert.That(math.distance(FileAxes.ToGltf(math.rotate(turn, place)), math.rotate(FileAxes.ToGltf(turn), gltf)),
                Is.LessThan(1e-5f));
            Assert.That(math.distance(FileAxes.Unit(3f * place), math.normalize(gltf)), Is.LessThan(1e-5f));
            Assert.That(math.distance(FileAxes.Unit((Vector3)place), math.normalize(gltf)), Is.LessThan(1e-5f));
        }

        Assert.That(FileAxes.Unit(float3.zero), Is.EqualTo(new float3(0f, 1f, 0f)), "a normal that is none looks up");
    }

    private static float Number(System.Random random) => (float)random.NextDouble();
}
