using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of painted surfaces and scenes: light and margins sample by sample, patterns at a slant, turned insects, trails.</summary>
public sealed class SurfaceLaws
{
    private static readonly float3 s_Paper = new(0.9f, 0.8f, 0.7f);

    // Seen twice at an edge of its triangles, a sheet counts once; two surfaces on one place are two.
    [Test]
    public void TwoSurfacesOnOnePlace_AreDenserThanOneThatIsDrawnTwice()
    {
        float3[] places = [new(5f, 5f, 1f), new(55f, 6f, 1f), new(20f, 55f, 1f)], normals = [.. places.Select(_ => new float3(0f, 1f, 0f))];
        float4[] values = [.. places.Select(_ => new float4(0.1f, 0.1f, 0.1f, 0.5f))];
        var shading = new Shading(new PictureCamera(PictureView.FrontLeft, 5f));
        int Sum(params int[] indices)
        {
            var grid = new SampleGrid(20, 20);
            foreach (int index in indices)
            {
                PhotoSurface.Thin(index, places, [0, 1, 2], values, (value, _) => value, hasEdge: false)
                    .Draw(grid, places, normals, shading, 0.1f);
            }

            return grid.Pixels(s_Paper).Sum(pixel => pixel.r);
        }

        Assert.That(Sum(1, 1), Is.EqualTo(Sum(1)));
        Assert.That(Sum(1, 2), Is.LessThan(Sum(1) - 4000));
    }

    // Ten times as far away as what covers it, a line of 1.6 pixels around it is seen all the same, in its own light.
    [Test]
    public void AnOutline_LiesBeforeAllElse_InItsOwnLight_AndFillsNothing()
    {
        float3[] far = [new(12f, 13.5f, 9f), new(48f, 13.5f, 9f), new(30f, 48f, 9f)],
            near = [new(0f, 0f, 1f), new(140f, 0f, 1f), new(0f, 140f, 1f)], normals = [.. far.Select(_ => new float3(0f, 1f, 0f))];
        var shading = new Shading(new PictureCamera(PictureView.FrontLeft, 5f));
        Color32[] Painted(float3 light)
        {
            var grid = new SampleGrid(20, 20);
            PhotoSurface.Thin(1, near, [0, 1, 2], [.. near.Select(_ => new float4(0f, 0f, 0f, 1f))], (value, _) => value, hasEdge: false)
                .Draw(grid, near, normals, shading, 0.1f);
            PhotoSurface.Outline(2, far, [0, 1, 2], light).Draw(grid, far, normals, shading, 0.1f);
            return grid.Pixels(s_Paper);
        }

        Color32[] blue = Painted(new float3(0f, 0f, 1f)), dim = Painted(new float3(0f, 0f, 0.25f));
        int side = 4 * 20 + 10, middle = 8 * 20 + 10;
        Assert.That((blue[side].r, (int)blue[side].b), Is.EqualTo(((byte)0, 255)).Within(40), "the side at the top");
        Assert.That(blue[middle].b, Is.EqualTo(dim[middle].b), "the middle is what lies behind");
        Assert.That(dim[side].b / 255.0, Is.EqualTo(Math.Pow(0.25, 1 / 2.2)).Within(0.15), "as light as it is told");
        Color32[] none = Painted(default);
        double covered = blue.Zip(none, (lit, dark) => (lit.b - dark.b) / (255.0 - dark.b)).Where(share => share > 0).Sum();
        Assert.That(covered, Is.EqualTo(1.6 * (36 + 2 * 38.9) / 3).Within(10).Percent, "1.6 pixels wide");
    }

    [TestCase("front", 0f, 8f)]
    [TestCase("side", 90f, 4f)]
    [TestCase("top", 180f, 90f)]
    [TestCase("back", 180f, 24f)]
    [TestCase("front-left", 36f, 28f)]
    public void ASide_IsThatOfItsName(string name, float aside, float above)
    {
        float3 towards = new PictureCamera(PictureView.ByName[name], 5f).Towards;
        float a = math.radians(aside), h = math.radians(above);

        float3 expected = new(-math.sin(a) * math.cos(h), math.sin(h), math.cos(a) * math.cos(h));
        Assert.That(math.distance(towards, expected), Is.LessThan(1e-5f), "left of the insect is −x, ahead +z");
    }

    // A wing of one triangle, sample by sample: its light, and over it a line of 1.1 pixels along each side, 3/10 as light, of the mean of
    // what its ends have, that begins and ends a quarter of its width beyond them.
    [TestCase(1f, 1.01f, 1.02f)]
    [TestCase(1.02f, 1.01f, 1f)]
    [TestCase(1.01f, 1f, 1.02f)]
    public void AWing_HasItsLight_AndALineAlongItsMargin(float a, float b, float c)
    {
        float3[] places = [new(8.2f, 9.1f, a), new(48.7f, 14.3f, b), new(21.4f, 50.9f, c)];
        float4[] values = [new(0.9f, 0.1f, 0.1f, 1f), new(0.1f, 0.9f, 0.1f, 1f), new(0.2f, 0.2f, 0.9f, 1f)];
        float3[] normals = [new(0f, 1f, 0f), new(0f, 0f, 1f), new(1f, 0f, 0f)];
        var shading = new Shading(new PictureCamera(PictureView.FrontLeft, 5f));
        float3[] rest = [new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, 1f)];
        SampleGrid drawn = new(20, 20), expected = new(20, 20);
        PhotoSurface.Thin(1, rest, [0, 1, 2], values, (value, _) => value).Draw(drawn, places, normals, shading, 0.1f);
        for (int y = 0; y < 60; y++)
        {
            for (int x = 0; x < 60; x++)
            {
                var middle = new float2(x + 0.5f, y + 0.5f);
                float whole = Cross(places[1].xy - places[0].xy, places[2].xy - places[0].xy);
                float3 share = new float3(Cross(places[2].xy - places[1].xy, middle - places[1].xy),
                    Cross(places[0].xy - places[2].xy, middle - places[2].xy),
                        Cross(places[1].xy - places[0].xy, middle - places[0].xy)) / whole;
                if (math.all(share >= 0f))
                {
                    float4 value = share.x * values[0] + share.y * values[1] + share.z * values[2];
                    float3 normal = math.normalize(share.x * normals[0] + share.y * normals[1] + share.z * normals[2]);
                    expected.Add(x, y, 2f, new float4(shading.Light(value.xyz, normal, true), 1f), 1);
                }

                // Nearer lines lie over farther ones; of two as near the first stays.
                float nearest = float.PositiveInfinity;
                for (int side = 0; side < 3; side++)
                {
                    float3 from = places[side], to = places[(side + 1) % 3];
                    float2 along = math.normalize(to.xy - from.xy);
                    float way = math.dot(middle - from.xy, along), aside = math.abs(Cross(along, middle - from.xy));
                    if (way < -0.825f || way > math.distance(from.xy, to.xy) + 0.825f || aside > 1.65f || math.min(from.z, to.z) >= nearest)
                        continue;
                    nearest = math.min(from.z, to.z);
                    expected.Add(x, y, 1f, new float4(0.15f * (values[side] + values[(side + 1) % 3]).xyz, 1f), 1);
                }
            }
        }

        Color32[] one = drawn.Pixels(s_Paper), other = expected.Pixels(s_Paper);
        int off = Enumerable.Range(0, one.Length).Max(k =>
            math.max(math.abs(one[k].r - other[k].r), math.max(math.abs(one[k].g - other[k].g), math.abs(one[k].b - other[k].b))));
        Assert.That(off, Is.LessThanOrEqualTo(2));
        Assert.That(one.Distinct().Count(), Is.GreaterThan(60));
    }

    [Test]
    public void AWingWithoutColours_IsAPaleMembrane_AndABodyHasThoseOfItsVertices()
    {
        float3[] places = [new(0f, 0f, 1f), new(60f, 0f, 1f), new(0f, 60f, 1f)], normals = [.. places.Select(_ => new float3(0f, 1f, 0f))];
        var shading = new Shading(new PictureCamera(PictureView.ByName["top"], 5f));
        var colour = new Color(0.84f, 0.79f, 0.66f, 1f);
        var body = new SurfaceMesh { triangles = [0, 1, 2], colours = [colour, colour, colour] };
        SampleGrid thin = new(12, 12), painted = new(12, 12), solid = new(12, 12);
        PhotoSurface.Thin(1, [new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, 1f)], [0, 1, 2], new float4[3], null)
            .Draw(thin, places, normals, shading, 0.1f);
        PhotoSurface.Thin(1, [new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, 1f)], [0, 1, 2],
            [.. Enumerable.Repeat(Shading.Linear(colour), 3)], (value, _) => value).Draw(painted, places, normals, shading, 0.1f);
        PhotoSurface.Of(body).Draw(solid, places, normals, shading, 0.1f);

        Assert.That(thin.Pixels(s_Paper), Is.EqualTo(painted.Pixels(s_Paper)));
        float3 shone = 255f * Shading.ToEncoded(shading.Light(Shading.Linear(colour).xyz, normals[0], false));
        Color32 seen = solid.Pixels(s_Paper)[0];
        Assert.That(math.cmax(math.abs(shone - new float3(seen.r, seen.g, seen.b))), Is.LessThan(1f), "no line along a body's edge");
    }

    // Where a triangle is seen at a slant, places along the long way of a sample's piece of the pattern are averaged: as many as it is
    // longer than wide, over a sample's three steps a pixel.
    [TestCase(2.9f, 1)]
    [TestCase(3.1f, 2)]
    [TestCase(8.9f, 3)]
    [TestCase(11.5f, 4)]
    [TestCase(80f, 4)]
    public void APatternAtASlant_IsAveragedAlongItsLongWay(float ratio, int taps)
    {
        foreach ((float turn, float aside) in new[] { (0f, 0f), (0.6f, 1.1f), (-1.2f, 0.4f) })
        {
            // Values over the picture: turned, stretched, and turned again.
            float2 Map(float2 place) => Turned(new float2(0.001f * ratio, 0.001f) * Turned(place, aside), turn);
            float2[] corners = [new(2f, 3f), new(27f, 6f), new(9f, 26f)];
            var asked = new List<float4>();
            PhotoSurface.Thin(1, [new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, 1f)], [0, 1, 2],
                [.. corners.Select(corner => new float4(Map(corner), 0f, 0f))],
                (value, softness) =>
                {
                    if (softness == 0.25f)
                        asked.Add(value);
                    return new float4(0.5f, 0.5f, 0.5f, 1f);
                }, hasPattern: true).Draw(new SampleGrid(10, 10), [.. corners.Select(corner => new float3(corner, 1f))],
                [.. corners.Select(_ => new float3(0f, 1f, 0f))], new Shading(new PictureCamera(PictureView.FrontLeft, 5f)), 0.25f);
            var samples = new List<float2>();
            TriangleSamples.Visit(corners[0], corners[1], corners[2], (x, y, _) => samples.Add(new float2(x + 0.5f, y + 0.5f)));

            Assert.That(asked, Has.Count.EqualTo(taps * samples.Count + 3), "and once for each side's line");
            float2 step = 0.001f * ratio / taps * Turned(new float2(1f, 0f), turn);
            for (int k = 0; k < samples.Count; k++)
            {
                float2[] shown = [.. asked.Skip(k * taps).Take(taps).Select(value => value.xy)];
                Assert.That(math.distance(shown.Aggregate((one, other) => one + other) / taps, Map(samples[k])), Is.LessThan(1e-4f));
                for (int tap = 1; tap < taps; tap++)
                {
                    float2 way = shown[tap] - shown[tap - 1];
                    Assert.That(math.min(math.distance(way, step), math.distance(way, -step)),
                        Is.LessThan(1e-2f * math.length(step) + 1e-6f));
                }
            }
        }

        static float2 Turned(float2 place, float angle) => new(
            math.cos(angle) * place.x - math.sin(angle) * place.y, math.sin(angle) * place.x + math.cos(angle) * place.y);
    }

    [Test]
    public void OfAPatternHalfOfGlass_TheOtherHalfGivesTheColour()
    {
        float3[] places = [new(-5f, -5f, 1f), new(200f, -5f, 1f), new(-5f, 200f, 1f)],
            normals = [.. places.Select(_ => new float3(0f, 1f, 0f))];
        var shading = new Shading(new PictureCamera(PictureView.ByName["top"], 5f));
        SampleGrid mixed = new(4, 4), half = new(4, 4);
        float4[] slanted = [new(0f, 0f, 0f, 0f), new(205f, 0f, 0f, 0f), new(0f, 40f, 0f, 0f)];
        float3[] rest = [new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, 1f)];
        int count = 0;
        PhotoSurface.Thin(1, rest, [0, 1, 2], slanted,
            (_, _) => count++ % 2 == 0 ? new float4(0.8f, 0.2f, 0.1f, 1f) : new float4(0f, 1f, 1f, 0f), true)
            .Draw(mixed, places, normals, shading, 0.1f);
        PhotoSurface.Thin(1, rest, [0, 1, 2], slanted, (_, _) => new float4(0.8f, 0.2f, 0.1f, 0.5f)).Draw(half, places, normals, shading,
            0.1f);

        SampleGrid none = new(4, 4);
        PhotoSurface.Thin(1, rest, [0, 1, 2], slanted, (_, _) => new float4(0.8f, 0.2f, 0.1f, 0f), true)
            .Draw(none, places, normals, shading, 0.1f);
        Assert.That(none.Pixels(s_Paper), Is.EqualTo(new SampleGrid(4, 4).Pixels(s_Paper)), "nothing but glass");
        Assert.That(count % 2, Is.EqualTo(1), "two places a sample, and three lines");
        Assert.That(mixed.Pixels(s_Paper), Is.EqualTo(half.Pixels(s_Paper)));
    }

    // Of a fan of 24 triangles around a middle, moved and turned: the circle that touches the sides in their middles, in one closed line.
    [TestCase(1f)]
    [TestCase(-1f)]
    public void ARoundedRim_IsASmoothLine_WhereverTheMeshIs(float side)
    {
        const int corners = 24;
        float3[] rest = [0f, .. Enumerable.Range(0, corners).Select(k => new float3(
            math.cos(2f * math.PI * k / corners), 0f, side * math.sin(2f * math.PI * k / corners)))];
        int[] triangles = [.. Enumerable.Range(0, corners).SelectMany(k => new[] { 0, 1 + k, 1 + (k + 1) % corners })];
        var rim = new RoundedRim(rest, triangles);
        float3 way = new(3f, -2f, 7f);
        quaternion turn = math.mul(quaternion.RotateX(0.4f), quaternion.RotateY(-0.7f));
        (int Vertex, float3 From, float3 To)[] pieces = [.. rim.Pieces([.. rest.Select(place => way + math.rotate(turn, place))])];

        Assert.That(rim.Vertices(rest.Length), Is.EqualTo(rest.Select((_, k) => k > 0)));
        for (int k = 0; k < pieces.Length; k++)
        {
            Assert.That(math.distance(pieces[k].To, pieces[(k + 1) % pieces.Length].From), Is.LessThan(1e-5f), "closed");
            Assert.That(math.distance(pieces[k].From, way), Is.EqualTo(math.cos(math.PI / corners)).Within(1e-3f));
            float3 beside = way + math.rotate(turn, rest[pieces[k].Vertex]);
            Assert.That(math.distance(pieces[k].From, beside), Is.LessThan(1.2f * math.PI / corners), "beside its vertex");
        }
    }

    [Test]
    public void AMargin_HasTheSidesOfOneTriangle_AndNoSeams()
    {
        // Two triangles with a seam between them: their common side stands there twice.
        float3[] rest = [new(0f, 0f, 0f), new(1f, 0f, 0f), new(1f, 0f, 1f), new(0f, 0f, 0f), new(1f, 0f, 1f), new(0f, 0f, 1f)];

        Assert.That(MeshMargin.Of(rest, [0, 1, 2, 3, 4, 5]),
            Is.EqualTo(new MarginEdge[] { new(0, 0, 1), new(0, 1, 2), new(1, 4, 5), new(1, 5, 3) }));
    }

    [Test]
    public void AnInsect_IsTurnedAboutItsThoraxAndMoved_ThenSeen_AndItsTrailWhereItIsNotTooNear()
    {
        float3[] places = [new(0.1f, 0.2f, 0.3f), new(-0.4f, 0f, 0.2f)], normals = [new(0f, 1f, 0f), new(1f, 0f, 0f)];
        PhotoPart body = new(null, 1f, turns => ([.. places.Select(place => (float)turns * place)], normals)),
            wing = body with { Rest = [new(0.5f, 0f, 0f), new(0.5f, 0f, 0.5f)] };
        var view = new PictureView("", 20f, 10f);
        var scene = new PhotoScene(view, 2f, [body, wing]);
        var camera = new PictureCamera(view, 10f);
        var turn = quaternion.AxisAngle(math.normalize(new float3(1f, 2f, 3f)), 0.7f);
        float3 way = new(0.3f, -0.2f, 0.5f);
        float3[] trail = [new(0f, 0f, 0f), camera.Towards * 5.9f, camera.Towards * 6.1f, camera.Towards * -3f];
        Pose pose = scene.PoseAt(2.0, turn, way, trail), still = scene.PoseAt(1.0), rest = scene.Rest();
        for (int part = 0; part < 2; part++)
        {
            for (int k = 0; k < 2; k++)
            {
                AssertNear(pose.Places[part][k], camera.Project(way + math.rotate(turn, 2f * places[k])));
                AssertNear(pose.Normals[part][k], math.rotate(turn, normals[k]));
                AssertNear(still.Places[part][k], camera.Project(places[k]));
                AssertNear(rest.Places[part][k], part == 0 ? camera.Project(0f) : camera.Project(wing.Rest[k]));
                AssertNear(rest.Normals[part][k], part == 0 ? normals[k] : new float3(0f, 1f, 0f));
            }
        }

        Assert.That(pose.Trail.Select(place => (int)math.round(place.z * 10f)), Is.EqualTo(new[] { 100, 41, 130 }),
            "not the one at 39 of 100");
        Assert.That(still.Trail, Is.Empty);
        AssertNear(scene.From(PictureView.FrontLeft).PoseAt(1.0).Places[0][0],
            new PictureCamera(PictureView.FrontLeft, 10f).Project(places[0]));

        static void AssertNear(float3 one, float3 other) => Assert.That(math.distance(one, other), Is.LessThan(1e-4f));
    }

    // A dot is 1.3 units wide around where it was, at the camera's own distance; nearer ones are larger.
    [TestCase(0f, 1f)]
    [TestCase(5f, 2f)]
    public void ADotOfATrail_IsAsLargeAsItIsNear(float nearer, float times)
    {
        var view = new PictureView("", 0f, 0f);
        var scene = new PhotoScene(view, 2f, []);
        Pose pose = scene.PoseAt(0.0, quaternion.identity, 0f, [new PictureCamera(view, 10f).Towards * nearer]);
        var panel = new StripPanel(5f, 6f, 30f, 20f, 10f, new float2(0.2f, -0.3f));
        Color32[] drawn = scene.Draw(pose, panel, 2f);
        var expected = new SampleGrid(60, 40);
        expected.AddDisc(6f * panel.Place(new float3(0f, 0f, 10f)).xy, 6f * 1.3f * times, 1f, PhotoScene.TrailLight);

        Assert.That(PhotoScene.SizeOf(panel, 2f), Is.EqualTo(new int2(60, 40)));
        Assert.That(PhotoScene.SizeOf(panel with { Width = 30.1f }, 2f), Is.EqualTo(new int2(61, 40)));
        Assert.That(drawn, Is.EqualTo(expected.Pixels(Shading.ToLinear(Shading.Paper))));
        Assert.That(drawn.Distinct().Count(), Is.GreaterThan(3));
        Assert.That(math.all(PhotoScene.TrailLight < 0.5f) && PhotoScene.TrailLight.x > PhotoScene.TrailLight.y
            && PhotoScene.TrailLight.y > PhotoScene.TrailLight.z, Is.True, "a warm grey");
    }

    // A pattern is softened over 0.6 of a pixel, told in lengths of the wing.
    [Test]
    public void SurfacesOfAScene_AreSoftenedByTheSizeOfAPixel()
    {
        var softened = new List<float>();
        float3[] square = [new(-1f, -1f, 0f), new(1f, -1f, 0f), new(0f, 1f, 0f)], normals = [.. square.Select(_ => new float3(0f, 0f, 1f))];
        var surface = PhotoSurface.Thin(1, square, [0, 1, 2], new float4[3], (_, softness) =>
        {
            softened.Add(softness);
            return 1f;
        });
        var scene = new PhotoScene(new PictureView("", 0f, 0f), 2f, [new PhotoPart(surface, 4f, _ => (square, normals))]);
        Pose pose = scene.PoseAt(0.0);
        scene.Draw(pose, StripPanel.Around(pose, 50f, 5f), 1.5f);

        Assert.That(softened, Is.All.EqualTo(0.6f / (1.5f * 20f * 4f)).Within(1).Percent);
    }

    private static float Cross(float2 a, float2 b) => a.x * b.y - a.y * b.x;
}
