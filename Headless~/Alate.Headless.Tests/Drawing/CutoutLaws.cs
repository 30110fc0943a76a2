using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of pictures with nothing behind them: on any ground they look as if they were painted there.</summary>
public sealed class CutoutLaws
{
    private const int k_Width = 24, k_Height = 16;

    [Test]
    public void OnAnyGround_ACutout_LooksAsPaintedThere()
    {
        SampleGrid grid = Filled(glass: 1f);
        Color32[] cutout = grid.Cutout();
        foreach (float3 ground in new[] { 0f, 1f, new float3(0.9f, 0.1f, 0.2f), new float3(0.1f, 0.3f, 0.8f), 0.5f })
        {
            Color32[] painted = grid.Pixels(Shading.ToLinear(ground));
            float off = cutout.Zip(painted, (over, seen) => math.cmax(math.abs(Over(over, ground) - Bytes(seen)))).Max();
            Assert.That(off, Is.LessThanOrEqualTo(2.5f), $"of 255, on {ground}");
        }

        Assert.That(cutout.Count(pixel => pixel.a == 0), Is.GreaterThan(20), "nothing");
        Assert.That(cutout.Count(pixel => pixel.a == 255), Is.GreaterThan(20), "solid");
        Assert.That(cutout.Count(pixel => pixel.a is > 20 and < 235), Is.GreaterThan(5), "edges");
    }

    // What is blended as light over a ground of middle brightness lies a little off where it is blended as encoded values.
    [Test]
    public void GlassOnBlackAndOnWhite_IsAsPaintedThere_AndNearOnOthers()
    {
        SampleGrid grid = Filled(glass: 0.4f);
        Color32[] cutout = grid.Cutout();
        foreach ((float3 ground, float most) in new[] { ((float3)0f, 14f), (1f, 14f), (0.5f, 30f) })
        {
            Color32[] painted = grid.Pixels(Shading.ToLinear(ground));
            float[] off = [.. cutout.Zip(painted, (over, seen) => math.csum(math.abs(Over(over, ground) - Bytes(seen))) / 3f)];
            Assert.That(off.Max(), Is.LessThan(most), $"on {ground}");
        }

        Assert.That(cutout.Any(pixel => pixel.a is > 60 and < 200), Is.True);
    }

    [Test]
    public void OfNothing_NothingIsSeen() =>
        Assert.That(new SampleGrid(3, 2).Cutout(), Is.All.EqualTo(new Color32(0, 0, 0, 0)));

    // A disc and a square over it, of light colours and dark ones.
    private static SampleGrid Filled(float glass)
    {
        var grid = new SampleGrid(k_Width, k_Height);
        grid.AddDisc(new float2(20f, 20f), 15f, 2f, new float3(0.7f, 0.2f, 0.05f));
        for (int y = 10; y < 31; y++)
        {
            for (int x = 25; x < 60; x++)
                grid.Add(x, y, 1f, new float4(0.1f, 0.4f, 0.3f, glass), 0);
        }

        return grid;
    }

    private static float3 Over(Color32 pixel, float3 ground) => math.lerp(255f * ground, Bytes(pixel), pixel.a / 255f);

    private static float3 Bytes(Color32 pixel) => new(pixel.r, pixel.g, pixel.b);
}
