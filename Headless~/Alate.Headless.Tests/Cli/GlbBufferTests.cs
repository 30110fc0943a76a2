using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.Json.Nodes;
using Alate.Formats;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Accessors of a GLB file, written and read back by the strict reader of the tests.</summary>
public sealed class GlbBufferTests
{
    [TestCase(65535, 5123)]
    [TestCase(65536, 5125)]
    [TestCase(70000, 5125)]
    public void Indices_TakeSixteenBits_UpToTheValueThatIsReserved(int vertices, int type)
    {
        int[] indices = [0, 1, vertices - 1, vertices - 2, 256, 255];
        GlbFile file = Written(buffer => buffer.AddIndices(indices, vertices));

        Assert.That(file.Accessor(0).GetProperty("componentType").GetInt32(), Is.EqualTo(type));
        Assert.That(file.Read(0), Is.EqualTo(indices.Select(index => (double)index)));
    }

    [Test]
    public void Vectors_ComeBack_WithTheirBounds()
    {
        float3[] places = [new float3(1f, -2f, 3f), new float3(-4f, 5f, 0.25f), new float3(0.5f, 0.5f, -6f)];
        GlbFile file = Written(buffer => buffer.AddVectors(places), buffer => buffer.AddVectors(places, false));

        Assert.That(file.ReadVectors(0), Is.EqualTo(places));
        Assert.That(file.Accessor(0).GetProperty("min").EnumerateArray().Select(number => number.GetDouble()),
            Is.EqualTo(new[] { -4.0, -2.0, -6.0 }));
        Assert.That(
            file.Accessor(0).GetProperty("max").EnumerateArray().Select(number => number.GetDouble()), Is.EqualTo(new[] { 1.0, 5.0, 3.0 }));
        Assert.That(file.Root.GetProperty("bufferViews")[0].GetProperty("target").GetInt32(), Is.EqualTo(34962));
        Assert.That(
            file.Root.GetProperty("bufferViews")[1].TryGetProperty("target", out _), Is.False, "values of an animation are no vertices");
    }

    [Test]
    public void NumbersOfEachKind_ComeBackInTheirOrder()
    {
        GlbFile file = Written(
            buffer => buffer.AddScalars([3f, 1f, 2f]), buffer => buffer.AddPairs([new float2(0.25f, 0.5f), new float2(1f, 0f)]),
            buffer => buffer.AddQuadruples([new float4(1f, 2f, 3f, 4f)]),
            buffer => buffer.AddJoints([new int4(1, 2, 3, 300)]), buffer => buffer.AddTranslations([new float3(7f, 8f, 9f)]));

        Assert.That(file.Read(0), Is.EqualTo(new[] { 3.0, 1.0, 2.0 }));
        Assert.That((file.Accessor(0).GetProperty("min")[0].GetDouble(), file.Accessor(0).GetProperty("max")[0].GetDouble()),
            Is.EqualTo((1.0, 3.0)));
        Assert.That(file.Read(1), Is.EqualTo(new[] { 0.25, 0.5, 1.0, 0.0 }));
        Assert.That(file.Read(2), Is.EqualTo(new[] { 1.0, 2.0, 3.0, 4.0 }));
        Assert.That(file.Read(3), Is.EqualTo(new[] { 1.0, 2.0, 3.0, 300.0 }));
        Assert.That(file.Read(4), Is.EqualTo(new[] { 1.0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1 }), "columns");
    }

    [Test]
    public void Colours_AreLinear_ChannelByChannel_AndOpacityAsItIs()
    {
        Color32[] colours = [new Color32(255, 0, 128, 51), new Color32(10, 64, 200, 255)];
        double[] read = Written(buffer => buffer.AddColours(colours)).Read(0);
        for (int k = 0; k < 2; k++)
        {
            byte[] channels = [colours[k].r, colours[k].g, colours[k].b];
            for (int c = 0; c < 3; c++)
            {
                // Of sRGB (IEC 61966-2-1): encoded again it is the byte.
                double linear = read[4 * k + c],
                    encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.Pow(linear, 1.0 / 2.4) - 0.055;
                Assert.That(255.0 * encoded, Is.EqualTo(channels[c]).Within(0.05), $"colour {k}, channel {c}");
            }

            Assert.That(255.0 * read[4 * k + 3], Is.EqualTo(colours[k].a).Within(1e-6));
        }
    }

    [Test]
    public void AFileWithin_BeginsOnFourBytes_AndIsAllThere()
    {
        byte[] picture = [1, 2, 3, 4, 5, 6, 7];
        GlbFile file = Written(
            buffer => buffer.AddIndices([0, 1, 2], 3), buffer => buffer.AddFile(picture), buffer => buffer.AddScalars([1f]));
        JsonElement views = file.Root.GetProperty("bufferViews");

        Assert.That((views[1].GetProperty("byteOffset").GetInt32(), views[1].GetProperty("byteLength").GetInt32()), Is.EqualTo((8, 7)));
        Assert.That(views[2].GetProperty("byteOffset").GetInt32(), Is.EqualTo(16));
    }

    private static GlbFile Written(params Func<GlbBuffer, int>[] add)
    {
        var buffer = new GlbBuffer();
        foreach (Func<GlbBuffer, int> one in add)
            one(buffer);
        using var stream = new MemoryStream();
        var gltf = new JsonObject
        {
            ["accessors"] = buffer.Accessors,
            ["bufferViews"] = buffer.Views,
            ["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = buffer.ToArray().Length }),
        };
        GlbWriter.Write(gltf, buffer.ToArray(), stream);
        return new GlbFile(stream.ToArray());
    }
}
