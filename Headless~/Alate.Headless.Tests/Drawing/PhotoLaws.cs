using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of photos: samples, light, textures, cameras and surfaces against sums and integrals of their own.</summary>
public sealed class PhotoLaws
{
    private static readonly float3 s_Paper = new(0.9f, 0.8f, 0.7f);

    [Test]
    public void SamplesOfATriangle_AreThoseWithin_EachWithItsSharesOfTheCorners()
    {
        var random = new System.Random(5);
        for (int k = 0; k < 60; k++)
        {
            float2[] t = [.. Enumerable.Range(0, 3).Select(_ => new float2(12f * (float)random.NextDouble() - 3f,
                9f * (float)random.NextDouble()))];
            var seen = new Dictionary<(int, int), float3>();
            TriangleSamples.Visit(t[0], t[1], t[2], (x, y, share) => seen.Add((x, y), share));
            for (int y = -6; y < 14; y++)
            {
                for (int x = -6; x < 14; x++)
                {
                    var middle = new float2(x + 0.5f, y + 0.5f);
                    bool[] sides = [.. Enumerable.Range(0, 3).Select(side => Cross(t[(side + 1) % 3] - t[side], middle - t[side]) > 0f)];
                    Assert.That(seen.ContainsKey((x, y)), Is.EqualTo(sides.Distinct().Count() == 1), $"{x}, {y}");
                    if (!seen.TryGetValue((x, y), out float3 share))
                        continue;
                    Assert.That(math.csum(share), Is.EqualTo(1f).Within(1e-3f));
                    Assert.That(math.distance(share.x * t[0] + share.y * t[1] + share.z * t[2], middle), Is.LessThan(1e-2f));
                }
            }
        }
    }

    // What a body and a wing send to the viewer, told again from the numbers of the light.
    [Test]
    public void Light_IsThatOfAKeyASkyARimAndAGloss_OnTheSideThatIsSeen([Values] bool isThin)
    {
        var camera = new PictureCamera(PictureView.FrontLeft, 10f);
        var shading = new Shading(camera);
        float3 towards = camera.Towards, right = camera.Direction(1f, 0f, 0f), above = camera.Direction(0f, 1f, 0f);
        float3 from = math.normalize(-0.45f * right + 0.8f * above + 0.55f * towards), half = math.normalize(from + towards);
        var random = new System.Random(8);
        float3 colour = new(0.3f, 0.5f, 0.7f);
        for (int k = 0; k < 200; k++)
        {
            float3 normal = math.normalize(new float3(Signed(random), Signed(random), Signed(random)));
            float3 seen = math.dot(normal, towards) < 0f ? -normal : normal;
            float key = math.dot(seen, from), edge = 1f - math.dot(seen, towards), rim = 0.16f * edge * edge * edge;
            float3 light = 0.42f + 0.16f * seen.y + 0.68f * math.max(key, 0f)
                + (isThin && key < 0f ? -0.42f * key * new float3(1.1f, 0.98f, 0.82f) : 0f);
            float gloss = isThin ? 0f : 0.1f * math.pow(math.max(math.dot(seen, half), 0f), 24f);
            float3 expected = colour * light + rim * (0.4f * colour + 0.25f) + gloss;

            Assert.That(math.distance(shading.Light(colour, normal, isThin), expected), Is.LessThan(1e-4f));
        }
    }

    [Test]
    public void Light_AndItsCodes_AreEachOthersInverse()
    {
        Assert.That(Shading.Colour(0x336699), Is.EqualTo(new float3(0.2f, 0.4f, 0.6f)).Using<float3>((a, b) => math.distance(a,
            b) < 1e-6f));
        for (float value = 0f; value <= 1f; value += 0.125f)
            Assert.That(Shading.ToEncoded(Shading.ToLinear(value)).y, Is.EqualTo(value).Within(1e-5f));
        Assert.That(Shading.ToLinear(0.5f).x, Is.EqualTo(Math.Pow(0.5, 2.2)).Within(1e-5));
        Assert.That(Shading.ToEncoded(new float3(-1f, 2f, 1f)), Is.EqualTo(new float3(0f, 1f, 1f)));
        float4 glass = Shading.Linear(new Color(1f, 0.5f, 0f, 0.25f));
        Assert.That((glass.x, glass.z, glass.w), Is.EqualTo((1f, 0f, 0.25f)));
        Assert.That(glass.y, Is.EqualTo(Math.Pow(0.5, 2.2)).Within(1e-5));
        Assert.That(math.distance(255f * Shading.Paper, new float3(0xf7, 0xf4, 0xec)), Is.LessThan(1e-3f), "the paper of the charts");
    }

    [Test]
    public void ATexture_HasItsPixelsInTheirMiddles_AndBlendsBetween()
    {
        Color32[] pixels = [.. Enumerable.Range(0,
            12).Select(k => new Color32((byte)(20 * k), (byte)(255 - 20 * k), (byte)(7 * k), (byte)(200 + 5 * (k % 10))))];
        var texture = new WingTexture(null, 4, 3, pixels);
        float4 At(int x, int y) => Shading.Linear(pixels[math.clamp(y, 0, 2) * 4 + math.clamp(x, 0, 3)]);
        for (int y = 0; y < 3; y++)
        {
            for (int x = 0; x < 4; x++)
            {
                AssertNear(texture.ColourAt(Place(x, y)), At(x, y));
                AssertNear(texture.ColourAt(Place(x + 0.5f, y)), 0.5f * (At(x, y) + At(x + 1, y)));
                AssertNear(texture.ColourAt(Place(x, y - 0.25f)), 0.75f * At(x, y) + 0.25f * At(x, y - 1));
                AssertNear(texture.ColourAt(Place(x - 0.25f, y + 0.5f)),
                    0.375f * (At(x, y) + At(x, y + 1)) + 0.125f * (At(x - 1, y) + At(x - 1, y + 1)));
            }
        }

        AssertNear(texture.ColourAt(new float2(-2f, 3f)), At(0, 0));
        AssertNear(texture.ColourAt(new float2(7f, -4f)), At(3, 2));
        Assert.That(texture.IsGlass, Is.True);
        Assert.That(new WingTexture(null, 1, 1, [new Color32(1, 2, 3, 255)]).IsGlass, Is.False);

        // Coordinates have v up, pixels their rows from above.
        static float2 Place(float x, float y) => new((x + 0.5f) / 4f, 1f - (y + 0.5f) / 3f);
        static void AssertNear(float4 one, float4 other) => Assert.That(math.distance(one, other), Is.LessThan(1e-5f));
    }

    [Test]
    public void PixelsOfAPicture_AreCountedFromItsHeader()
    {
        byte[] png = Alate.Formats.TrueColourPng.Write(7, 5, new Color32[35], []);

        Assert.That(WingTexture.CountPixels(png), Is.EqualTo(35));
        Assert.That(WingTexture.CountPixels(png[..24]), Is.EqualTo(35));
        Assert.That(WingTexture.CountPixels(png[..23]), Is.Zero);
        Assert.That(WingTexture.CountPixels([]), Is.Zero);
        var texture = WingTexture.Of(png);
        Assert.That((texture.Width, texture.Height, texture.Png), Is.EqualTo((7, 5, png)));
    }

    [Test]
    public void ACamera_DrawsNothingLargerThanTenTimes()
    {
        var camera = new PictureCamera(PictureView.ByName["front"], 10f);
        float3 across = camera.Direction(1f, 0f, 0f);

        Assert.That(camera.Project(across + 9.5f * camera.Towards).x, Is.EqualTo(10f).Within(1e-3f));
        Assert.That(camera.Project(across + 8f * camera.Towards).x, Is.EqualTo(5f).Within(1e-3f));
        Assert.That(camera.Distance, Is.EqualTo(10f));
    }

    // A pixel's colour is the mean of the samples around, weighted by a tent that is two pixels wide; beyond the picture the last goes on.
    // Whatever the order in which they come: what lies behind something solid is not seen.
    [Test]
    public void SheetsOfGlass_AreSeenThrough_FromTheFarthestToTheNearest()
    {
        var random = new System.Random(4);
        for (int round = 0; round < 40; round++)
        {
            var sheets = Enumerable.Range(0, 6).Select(k => (Depth: 1f + (float)random.NextDouble(),
                Light: new float4((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble(), 0.5f))).ToList();
            var grid = new SampleGrid(1, 1);
            float solid = round % 2 == 0 ? 1.5f : float.PositiveInfinity;
            float3 light = round % 2 == 0 ? new float3(0.2f, 0.3f, 0.4f) : s_Paper;
            for (int sample = 0; sample < 9; sample++)
            {
                for (int k = 0; k < sheets.Count; k++)
                    grid.Add(sample % 3, sample / 3, sheets[k].Depth, sheets[k].Light, k);
                if (round % 2 == 0)
                    grid.Add(sample % 3, sample / 3, solid, new float4(light, 1f), 9);
            }

            foreach ((float _, float4 sheet) in sheets.Where(sheet => sheet.Depth < solid).OrderByDescending(sheet => sheet.Depth))
                light = math.lerp(light, sheet.xyz, sheet.w);
            float3 expected = 255f * Shading.ToEncoded(light);
            Color32 shown = grid.Pixels(s_Paper)[0];
            Assert.That(math.distance(new float3(shown.r, shown.g, shown.b), expected), Is.LessThan(1f), $"round {round}");
        }
    }

    [TestCase(0, 0)]
    [TestCase(3, 3)]
    [TestCase(6, 9)]
    public void APixel_IsTheMeanOfTheSamplesAround_ByATent(int left, int top)
    {
        const int k_Width = 5, k_Height = 4;
        var random = new System.Random(2);
        var grid = new SampleGrid(k_Width, k_Height);
        var samples = new float3[3 * k_Width, 3 * k_Height];
        for (int y = 0; y < 3 * k_Height; y++)
        {
            for (int x = 0; x < 3 * k_Width; x++)
            {
                samples[x, y] = Shading.ToEncoded(s_Paper);
                if (x + y < 12 && random.Next(2) == 0)
                    continue;
                var light = new float3((float)random.NextDouble(), (float)random.NextDouble(), 0.5f);
                if (x >= left && x < left + 9 && y >= top && y < top + 6)
                {
                    grid.Add(x, y, 1f, new float4(light, 1f), 0);
                    samples[x, y] = Shading.ToEncoded(light);
                }
            }
        }

        Color32[] pixels = grid.Pixels(s_Paper);
        for (int y = 0; y < k_Height; y++)
        {
            for (int x = 0; x < k_Width; x++)
            {
                float3 sum = 0f;
                float weights = 0f;
                for (int dy = -2; dy <= 2; dy++)
                {
                    for (int dx = -2; dx <= 2; dx++)
                    {
                        float weight = (1f - math.abs(dx) / 3f) * (1f - math.abs(dy) / 3f);
                        sum += weight * samples[math.clamp(3 * x + 1 + dx, 0, 3 * k_Width - 1),
                            math.clamp(3 * y + 1 + dy, 0, 3 * k_Height - 1)];
                        weights += weight;
                    }
                }

                float3 expected = 255f * sum / weights;
                Color32 drawn = pixels[y * k_Width + x];
                Assert.That(math.cmax(math.abs(new float3(drawn.r, drawn.g, drawn.b) - expected)), Is.LessThan(0.51f), $"{x}, {y}");
                Assert.That(drawn.a, Is.EqualTo(255));
            }
        }
    }

    [TestCase(1.5e-4f, true)]
    [TestCase(2.5e-4f, false)]
    public void OneSheet_IsOneWithinATenThousandthOfItsDepth(float apart, bool isOne)
    {
        float4 dark = new(0f, 0f, 0f, 0.5f);
        Color32 once = Seen((2f, dark, 1)), twice = Seen((2f, dark, 1), (2f + apart, dark, 1)),
            other = Seen((2f, dark, 1), (2f + apart, dark, 2)), nearer = Seen((2f + apart, dark, 1), (2f, dark, 1));

        Assert.That(twice.r, isOne ? Is.EqualTo(once.r) : Is.LessThan(once.r));
        Assert.That(nearer.r, Is.EqualTo(twice.r));
        Assert.That(other.r, Is.LessThan(once.r), "two surfaces are two");
        Assert.That(Seen((2f, new float4(0f, 0f, 0f, 0.996f), 1)).r, Is.Zero, "nearly solid is solid");
        Assert.That(Seen((2f, dark, 1)).r, Is.EqualTo(255.0 * Math.Pow(0.5 * s_Paper.x, 1.0 / 2.2)).Within(0.51),
            "half of the light behind");

        static Color32 Seen(params (float Depth, float4 Light, int Surface)[] sheets)
        {
            var grid = new SampleGrid(1, 1);
            foreach ((float depth, float4 light, int surface) in sheets)
            {
                for (int k = 0; k < 9; k++)
                    grid.Add(k % 3, k / 3, depth, light, surface);
            }

            return grid.Pixels(s_Paper)[0];
        }
    }

    [TestCase(20f, 20f, 6f)]
    [TestCase(20.5f, 17.25f, 4.5f)]
    [TestCase(9.25f, 30f, 5f)]
    [TestCase(31f, 8.5f, 5f)]
    public void ADisc_HasTheSamplesWithinItsRadius_WhereNothingIsNearer(float x, float y, float radius)
    {
        SampleGrid plain = new(14, 14), drawn = new(14, 14);
        plain.Add(20, 18, 1f, new float4(0f, 0f, 1f, 1f), 0);
        drawn.Add(20, 18, 1f, new float4(0f, 0f, 1f, 1f), 0);
        drawn.AddDisc(new float2(x, y), radius, 2f, new float3(1f, 0f, 0f));
        drawn.AddDisc(new float2(-1f, 50f), radius, 2f, new float3(1f, 0f, 0f));
        for (int row = 0; row < 42; row++)
        {
            for (int column = 0; column < 42; column++)
            {
                bool within = Math.Pow(column + 0.5 - x, 2) + Math.Pow(row + 0.5 - y, 2) <= radius * radius && (column, row) != (20, 18);
                if (within)
                    plain.Add(column, row, 2f, new float4(1f, 0f, 0f, 1f), 0);
                if (Math.Pow(column + 0.5 + 1.0, 2) + Math.Pow(row + 0.5 - 50.0, 2) <= radius * radius)
                    plain.Add(column, row, 2f, new float4(1f, 0f, 0f, 1f), 0);
                Assert.That(drawn.IsSeen(column, row, 2f), Is.EqualTo(plain.IsSeen(column, row, 2f)), $"{column}, {row}");
            }
        }

        Assert.That(drawn.Pixels(s_Paper), Is.EqualTo(plain.Pixels(s_Paper)));
    }

    private static float Cross(float2 a, float2 b) => a.x * b.y - a.y * b.x;

    private static float Signed(System.Random random) => 2f * (float)random.NextDouble() - 1f;
}
