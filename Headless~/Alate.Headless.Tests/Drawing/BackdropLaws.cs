using System;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of walls behind insects: their light, the shadows on them, and what is laid before them.</summary>
public sealed class BackdropLaws
{
    private static readonly int2 s_Size = new(100, 80);

    private static readonly BackdropLook s_Look = new(0.8f, 0.2f, 0.5f);

    [Test]
    public void AWall_IsAsBrightAsItsMiddle_AndDimsEvenlyTowardsItsEdges()
    {
        Color32[] wall = new Backdrop(s_Look, s_Size).Pixels();
        int At(int x, int y) => wall[y * s_Size.x + x].r;

        Assert.That(At(50, 33), Is.EqualTo(204).Within(1));
        Assert.That(At(0, 79), Is.EqualTo(51).Within(2), "the farthest corner");
        for (int x = 51; x < 100; x++)
        {
            Assert.That(At(x, 33), Is.LessThanOrEqualTo(At(x - 1, 33)));
            Assert.That(At(99 - x, 33), Is.EqualTo(At(x, 33)), "both sides alike");
        }

        Assert.That(wall.All(pixel => pixel.a == 255 && pixel.r == pixel.g && pixel.r == pixel.b), Is.True);
    }

    // Linear light is what a shadow takes a share of.
    [TestCase(0.5f)]
    [TestCase(1f)]
    [TestCase(0f)]
    public void BehindAPlate_TheShadesShareOfTheLightIsGone_LowerAndToTheRight_AndNothingIsBrighter(float shade)
    {
        BackdropLook look = new(0.8f, 0.8f, shade);
        (PhotoScene scene, StripPanel panel) = Plate();
        var wall = new Backdrop(look, s_Size);
        float[] before = [.. wall.Pixels().Select(Light)];
        wall.Shade(scene, scene.PoseAt(0.0), panel, 1f, 0);
        float[] left = [.. wall.Pixels().Select(Light).Zip(before, (now, then) => now / then)];

        Assert.That(left.Max(), Is.EqualTo(1f).Within(0.01f));
        Assert.That(left.Min(), Is.EqualTo(1f - shade).Within(0.02f), "behind the plate's middle");
        if (shade == 0f)
            return;
        float2 middle = 0f;
        float taken = 0f;
        for (int k = 0; k < left.Length; k++)
        {
            middle += (1f - left[k]) * (new float2(k % s_Size.x, k / s_Size.x) + 0.5f);
            taken += 1f - left[k];
        }

        middle /= taken;
        Assert.That(middle.x, Is.InRange(0.5f * panel.Width + 4f, 0.5f * panel.Width + 16f), "the light comes from the left");
        Assert.That(middle.y, Is.InRange(0.5f * panel.Height + 6f, 0.5f * panel.Height + 20f), "and from above");
    }

    // The same light, wherever the panel begins and however fine it is.
    [Test]
    public void AShadow_MovesWithItsPanel_AndGrowsWithItsFineness()
    {
        (PhotoScene scene, StripPanel panel) = Plate();
        Pose pose = scene.PoseAt(0.0);
        Func<float2, float> fine = scene.LightBehind(pose, panel, 3f), finer = scene.LightBehind(pose, panel, 6f);
        for (float x = -20f; x < 130f; x += 7f)
        {
            for (float y = -20f; y < 110f; y += 7f)
                Assert.That(finer(6f * new float2(x, y)), Is.EqualTo(fine(3f * new float2(x, y))).Within(0.05f), $"{x}, {y}");
        }

        Color32[] Shaded(int2 corner)
        {
            var wall = new Backdrop(new BackdropLook(0.8f, 0.8f, 0.5f), s_Size);
            wall.Shade(scene, pose, panel, 1f, corner);
            return wall.Pixels();
        }

        Color32[] still = Shaded(0), moved = Shaded(new int2(7, -5));
        for (int y = 0; y < s_Size.y - 5; y++)
        {
            for (int x = 7; x < s_Size.x; x++)
                Assert.That(moved[y * s_Size.x + x], Is.EqualTo(still[(y + 5) * s_Size.x + x - 7]));
        }
    }

    [Test]
    public void BeforeAWall_WhatIsSolidHidesIt_WhatIsSeenThroughTintsIt_AndTheRestIsLeftAsItWas()
    {
        var wall = new Backdrop(s_Look, s_Size);
        Color32[] before = wall.Pixels();
        Color32 solid = new(10, 200, 30, 255), half = new(10, 200, 30, 102), none = new(10, 200, 30, 0);
        wall.Lay([solid, half, none, solid], new int2(2, 2), new int2(99, 40));
        Color32[] after = wall.Pixels();

        Assert.That(after[40 * 100 + 99], Is.EqualTo(solid));
        Assert.That(after[41 * 100 + 99], Is.EqualTo(before[41 * 100 + 99]), "seen through");
        Assert.That(after.Zip(before, (now, then) => now.Equals(then)).Count(same => !same), Is.EqualTo(1), "others lie beside it");

        wall.Lay([half], new int2(1, 1), new int2(3, 4));
        float then = before[4 * 100 + 3].r;
        Color32 tinted = wall.Pixels()[4 * 100 + 3];
        Assert.That(tinted.g, Is.EqualTo(0.6f * then + 0.4f * 200f).Within(1f));
        Assert.That(tinted.r, Is.EqualTo(0.6f * then + 0.4f * 10f).Within(1f));
    }

    [Test]
    public void APlaceBehindAnother_IsSeenThere_AsFarAsAsked()
    {
        foreach (PictureView view in PictureView.ByName.Values)
        {
            var camera = new PictureCamera(view, 5f);
            foreach (float behind in new[] { -1f, 0f, 0.7f, 3f })
            {
                float3 seen = camera.Project(camera.Behind(new float2(0.4f, -0.3f), behind));
                Assert.That(math.distance(seen, new float3(0.4f, -0.3f, 5f + behind)), Is.LessThan(1e-5f), view.Words);
            }
        }
    }

    [Test]
    public void APlaceOfAPanel_IsThatOfTheCamerasPlane_ThatItShows()
    {
        StripPanel panel = new(3f, 5f, 60f, 40f, 12f, new float2(0.3f, -0.2f));
        foreach (float2 seen in new[] { float2.zero, new float2(1.5f, -0.7f), new float2(-2f, 3f) })
            Assert.That(math.distance(panel.SeenAt(panel.Place(new float3(seen, 1f)).xy), seen), Is.LessThan(1e-5f));
    }

    // Upright, half a metre to either side, before the viewer's eyes.
    private static (PhotoScene Scene, StripPanel Panel) Plate()
    {
        float3[] places = [new(-0.5f, -0.5f, 0f), new(-0.5f, 0.5f, 0f), new(0.5f, 0.5f, 0f), new(0.5f, -0.5f, 0f)];
        var part = new PhotoPart(PhotoSurface.Of(new SurfaceMesh
        {
            triangles = [0, 1, 2, 0, 2, 3],
            colours = [.. Enumerable.Repeat(Color.white, 4)],
        }), 1f, _ => (places, [.. places.Select(_ => new float3(0f, 0f, 1f))]));
        return (new PhotoScene(new PictureView("", 0f, 0f), 0.7f, [part]), new StripPanel(0f, 0f, s_Size.x, s_Size.y, 40f, 0f));
    }

    private static float Light(Color32 pixel) => Shading.ToLinear(pixel.r / 255f).x;
}
