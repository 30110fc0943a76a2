using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of pages of pixels: panels lie where they are asked for, lines and words have their places, widths and colours.</summary>
public sealed class PageLaws
{
    private static readonly Color32 s_Paper = new(0xf7, 0xf4, 0xec, 255);

    [Test]
    public void Panels_HaveOneScaleAndWidth_AndRowsAsHighAsTheirPosesNeed()
    {
        var random = new System.Random(3);
        List<Pose> poses = [.. Enumerable.Range(0, 6).Select(_ => RandomPose(random))];
        const float k_Left = 7f, k_Top = 40f, k_Width = 150f, k_Label = 21f, k_Inset = 13f;
        var layout = new StripLayout(poses, 2, k_Left, k_Top, k_Width, k_Label);
        float2 min = poses.Select(pose => pose.Bounds().Min).Aggregate(math.min),
            max = poses.Select(pose => pose.Bounds().Max).Aggregate(math.max);
        float top = k_Top;
        for (int row = 0; row < 3; row++)
        {
            Pose[] shown = [.. poses.Skip(2 * row).Take(2)];
            float low = shown.Min(pose => pose.Bounds().Min.y), high = shown.Max(pose => pose.Bounds().Max.y);
            for (int column = 0; column < 2; column++)
            {
                StripPanel panel = layout[2 * row + column];
                Assert.That((panel.Left, panel.Width), Is.EqualTo((k_Left + column * k_Width, k_Width)));
                Assert.That(panel.Top, Is.EqualTo(top).Within(1e-3f));
                Assert.That(panel.Height, Is.EqualTo(math.ceil((high - low) * panel.Scale + 2f * k_Inset)));
                // The leftmost and the rightmost place of all, and the highest and lowest of the row, are an inset from the edges.
                Assert.That(panel.Place(new float3(min.x, low, 5f)).x, Is.EqualTo(k_Inset).Within(1e-2f));
                Assert.That(panel.Place(new float3(max.x, low, 5f)).x, Is.EqualTo(k_Width - k_Inset).Within(1e-2f));
                Assert.That(panel.Place(new float3(max.x, low, 5f)).z, Is.EqualTo(5f));
                Assert.That(panel.Place(new float3(0f, low, 0f)).y + panel.Place(new float3(0f, high, 0f)).y,
                    Is.EqualTo(panel.Height).Within(1e-2f), "as much above as below");
            }

            top += layout[2 * row].Height + k_Label;
        }

        Assert.That((layout.Width, layout.Height), Is.EqualTo((k_Left + 2f * k_Width, top)));
    }

    [Test]
    public void AStripOfABeat_BeginsBelowItsHeading_AndHasLabelsBelowItsRows()
    {
        var random = new System.Random(4);
        List<Pose> poses = [.. Enumerable.Range(0, 4).Select(_ => RandomPose(random))];
        StripLayout strip = new(poses, 2), same = new(poses, 2, 0f, 62f, 300f, 32f);

        for (int k = 0; k < 4; k++)
            Assert.That(strip[k], Is.EqualTo(same[k]));
        Assert.That((strip.Width, strip.Height), Is.EqualTo((same.Width, same.Height)));
    }

    [Test]
    public void APoseWithoutWidth_HasAScaleAllTheSame()
    {
        var pose = new Pose();
        pose.Places.Add([new float3(1f, 2f, 3f)]);

        Assert.That(float.IsFinite(new StripLayout([pose], 1)[0].Scale), Is.True);
        Assert.That(pose.Bounds(), Is.EqualTo((new float2(1f, 2f), new float2(1f, 2f))));
    }

    [Test]
    public void APanelAroundAPose_HasIt_AnInsetFromTheNearerEdges()
    {
        var pose = new Pose();
        pose.Places.Add([new float3(-1f, 2f, 0f), new float3(3f, 4f, 0f)]);
        var panel = StripPanel.Around(pose, new float2(200f, 150f), 10f);

        Assert.That((panel.Left, panel.Top, panel.Width, panel.Height), Is.EqualTo((0f, 0f, 200f, 150f)));
        Assert.That(panel.Place(new float3(-1f, 2f, 0f)).xy, Is.EqualTo(new float2(10f, 30f)));
        Assert.That(panel.Place(new float3(3f, 4f, 0f)).xy, Is.EqualTo(new float2(190f, 120f)));
        pose.Places[0][1] = new float3(0f, 8f, 0f);
        Assert.That(StripPanel.Around(pose, new float2(200f, 150f), 10f).Scale, Is.EqualTo(130f / 6f).Within(1e-4f),
            "as high as it may be");
    }

    [TestCase(4f)]
    [TestCase(1f)]
    public void ALine_HasItsColourAndThickness(float thickness)
    {
        var page = new PixelPage();
        page.Line(10f, 20f, 50f, 20f, 0x102030, thickness);
        var size = new int2(90, 60);
        Color32[] drawn = page.Draw(size);
        for (int column = 20; column < 70; column++)
        {
            double covered = Enumerable.Range(0, size.y).Sum(row => (0xf4 - drawn[row * size.x + column].g) / (double)(0xf4 - 0x20));
            Assert.That(covered, Is.EqualTo(PixelPage.Fineness * thickness).Within(0.02));
        }

        if (thickness > 1f)
        {
            double along = Enumerable.Range(0, size.x).Sum(column => (0xf4 - drawn[29 * size.x + column].g) / (double)(0xf4 - 0x20));
            Assert.That(along, Is.EqualTo(60.0 + PixelPage.Fineness * thickness).Within(0.6), "40 units, and its round ends");
            Assert.That(drawn[29 * size.x + 40], Is.EqualTo(new Color32(0x10, 0x20, 0x30, 255)));
        }

        Assert.That(drawn[0], Is.EqualTo(s_Paper));
        Assert.That(page.Texts, Is.Empty);
    }

    [TestCase("t", 0x746d60)]
    [TestCase("b", 0x3d3a34)]
    [TestCase("", 0x3d3a34)]
    public void Words_HaveTheirInk_AtTheirPlace(string look, int ink)
    {
        // An I is one upright stroke, 72 hundredths of its size high, as thick as the pen allows.
        var page = new PixelPage();
        page.Text(20f, 60f, 60f, "I", "start", look);
        var size = new int2(60, 120);
        Color32[] drawn = page.Draw(size);
        float pen = Lettering.Strokes("I", 60f, look == "b").Pen;

        Assert.That(drawn[60 * size.x + 30], Is.EqualTo(new Color32((byte)(ink >> 16), (byte)(ink >> 8), (byte)ink, 255)));
        double covered = Enumerable.Range(0, size.x).Sum(column =>
            (0xf4 - drawn[60 * size.x + column].g) / (double)(0xf4 - (ink >> 8 & 255)));
        Assert.That(covered, Is.EqualTo(2.0 * pen * PixelPage.Fineness).Within(0.03));
        int[] rows = [.. Enumerable.Range(0, size.y).Where(row => drawn[row * size.x + 30].g < 0xb0)];
        Assert.That((rows[0], rows[^1]), Is.EqualTo((90.0 - 64.8 - 1.5 * pen, 90.0 + 1.5 * pen - 1.0)).Using<(int, int), (double, double)>(
            (one, other) => System.Math.Abs(one.Item1 - other.Item1) <= 1.0 && System.Math.Abs(one.Item2 - other.Item2) <= 1.0));
    }

    [Test]
    public void APage_IsAsLargeAsAsked_AndNamesItsTitleAndWords()
    {
        var page = new PixelPage();
        page.Text(5f, 20f, 10f, "words");
        page.Text(5f, 30f, 10f, "more");
        var picture = PngFile.Read(page.Finish(101f, 51f, "title"));

        Assert.That((picture.Width, picture.Height), Is.EqualTo((152, 76)), "1.5 pixels a unit, to the nearest even");
        Assert.That(page.Texts, Is.EqualTo(new[] { "words", "more" }));
    }

    [Test]
    public void Photos_LieInTheirPanels_AndLeaveTheirNeighboursAsTheyAre()
    {
        PhotoScene scene = Scene(new Color(0.8f, 0.1f, 0.1f, 1f)), other = Scene(new Color(0.1f, 0.1f, 0.8f, 1f));
        Pose pose = scene.PoseAt(0.0);
        StripPanel first = StripPanel.Around(pose, new float2(60f, 50f), 12f) with { Left = 11f, Top = 7f },
            second = first with { Left = 21f, Top = 15f }, beyond = first with { Left = 61f, Top = -21f };
        var size = new int2(120, 100);
        var page = new PixelPage();
        page.Add(scene, pose, first);
        page.Add(other, pose, second);
        page.Add(other, pose, beyond);
        Color32[] drawn = page.Draw(size), expected = [.. Enumerable.Repeat(s_Paper, size.x * size.y)];
        foreach ((PhotoScene shown, StripPanel panel) in new[] { (scene, first), (other, second), (other, beyond) })
        {
            Color32[] photo = shown.Draw(pose, panel, PixelPage.Fineness);
            // Half pixels go to the even neighbour.
            int left = (int)math.round(1.5f * panel.Left), top = (int)math.round(1.5f * panel.Top);
            for (int k = 0; k < photo.Length; k++)
            {
                int x = left + k % 90, y = top + k / 90;
                if (!photo[k].Equals(s_Paper) && x >= 0 && x < size.x && y >= 0 && y < size.y)
                    expected[y * size.x + x] = photo[k];
            }
        }

        int same = drawn.Zip(expected, (a, b) => System.Math.Abs(a.r - b.r) + System.Math.Abs(a.g - b.g) + System.Math.Abs(a.b - b.b))
            .Count(distance => distance <= 3);
        Assert.That(same, Is.EqualTo(drawn.Length), "but for what is nearly paper");
        Assert.That(drawn.Count(pixel => pixel.b > pixel.r + 60), Is.GreaterThan(300));
    }

    [Test]
    public void AGridOfPoses_HasAColumnAScene_ARowAPhase_AndItsAnglesOnTheLeft()
    {
        PhotoScene[] scenes = [Scene(Color.red), Scene(Color.blue, 1.5f), Scene(Color.green)];
        double[] phases = [0.0, 0.25];
        var grid = new PoseGrid(scenes, phases, 50f, 30f, 80f);
        var page = new PixelPage();
        grid.Draw(page);
        var size = new int2((int)(1.5f * grid.Right) + 20, (int)(1.5f * grid.Bottom) + 20);
        Color32[] drawn = page.Draw(size);

        Assert.That(grid.Right, Is.EqualTo(50f + 3f * 80f));
        for (int row = 0; row < 2; row++)
        {
            for (int column = 0; column < 3; column++)
            {
                StripPanel panel = grid[row, column];
                Assert.That((panel.Left, panel.Width), Is.EqualTo((50f + column * 80f, 80f)));
                Assert.That(panel.Top, Is.EqualTo(row == 0 ? 30f : 30f + grid[0, 0].Height + 4f), "a gap of four");
                Color32 middle = drawn[(int)(1.5f * (panel.Top + 0.5f * panel.Height)) * size.x + (int)(1.5f * (panel.Left + 40f))];
                Assert.That(column == 0 ? middle.r - middle.b : column == 1 ? middle.b - middle.r : middle.g - middle.r,
                    Is.GreaterThan(60));
            }
        }

        Assert.That(grid.Bottom, Is.EqualTo(grid[1, 0].Top + grid[1, 0].Height + 4f));

        var labels = new PixelPage();
        grid.LabelRows(labels, phases, 40f);
        Assert.That(labels.Texts, Is.EqualTo(new[] { "0°", "90°" }));
        Color32[] written = labels.Draw(size);
        for (int row = 0; row < 2; row++)
        {
            StripPanel panel = grid[row, 0];
            int2[] ink = [.. Enumerable.Range(0, written.Length).Where(k => written[k].g < 200).Select(k => new int2(k % size.x,
                k / size.x))
                .Where(place => place.y > 1.5f * panel.Top && place.y < 1.5f * (panel.Top + panel.Height))];
            Assert.That(ink.Max(place => place.x), Is.EqualTo(59.5).Within(1.1), "they end there");
            Assert.That(0.5 * (ink.Min(place => place.y) + ink.Max(place => place.y) + 1),
                Is.EqualTo(1.5 * (panel.Top + 0.5 * panel.Height)).Within(0.6),
                "at half the height of the row");
        }
    }

    // A square that faces the front.
    private static PhotoScene Scene(Color colour, float size = 1f)
    {
        SurfaceMesh square = new()
        {
            positions = [new(-size, -size, 0f), new(size, -size, 0f), new(size, size, 0f), new(-size, size, 0f)],
            colours = [colour, colour, colour, colour],
            triangles = [0, 1, 2, 0, 2, 3],
        };
        return new PhotoScene(new PictureView("the front", 0f, 0f), 2f, [new PhotoPart(PhotoSurface.Of(square), 1f,
            _ => ([.. square.positions.Select(place => (float3)place)], [.. square.positions.Select(_ => new float3(0f, 0f, 1f))]))]);
    }

    private static Pose RandomPose(System.Random random)
    {
        var pose = new Pose();
        for (int k = 0; k < 2; k++)
        {
            pose.Places.Add([.. Enumerable.Range(0, 5).Select(_ =>
                new float3((float)random.NextDouble() - 0.3f, 0.4f * (float)random.NextDouble() + 0.5f, 3f))]);
        }

        return pose;
    }
}
