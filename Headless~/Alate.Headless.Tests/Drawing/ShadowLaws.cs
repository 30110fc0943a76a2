using System;
using System.Linq;
using Alate.Drawing;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of shadows among the surfaces of a photo: plates before a light, whose shadows are known.</summary>
public sealed class ShadowLaws
{
    private const float k_Softness = 0.06f, k_Finest = 0.001f;

    private static readonly float3 s_Up = new(0f, 1f, 0f);

    [TestCase(1f)]
    [TestCase(0.3f)]
    [TestCase(0f)]
    public void BelowAPlate_ItsShareIsTaken_AndNoneAboveIt_OrBeside(float taken)
    {
        var map = new ShadowMap([Plate(0f, taken), null], s_Up, k_Softness, k_Finest);

        Assert.That(map.At(1, new float3(0.2f, -0.5f, -0.3f)), Is.EqualTo(1f - taken).Within(1e-4f), "below");
        Assert.That(map.At(1, new float3(0.2f, 0.01f, -0.3f)), Is.EqualTo(1f).Within(1e-4f), "above");
        Assert.That(map.At(1, new float3(1.3f, -0.5f, 0f)), Is.EqualTo(1f).Within(1e-4f), "beside");
        Assert.That(map.At(1, new float3(9f, -0.5f, -9f)), Is.EqualTo(1f), "far off");
        Assert.That(map.At(0, new float3(0.2f, -0.5f, -0.3f)), Is.EqualTo(1f), "nothing shades itself");
    }

    // A place at the plate's height lies in the light; the whole shade begins as far below as an edge is blurred.
    [Test]
    public void AShadow_BeginsAtThePlate_AndIsWholeASoftnessBelow()
    {
        var map = new ShadowMap([Plate(0.4f, 0.8f), null], s_Up, k_Softness, k_Finest);
        float At(float below) => map.At(1, new float3(0f, 0.4f - below, 0f));

        Assert.That(At(0f), Is.EqualTo(1f).Within(1e-3f));
        Assert.That(At(0.5f * k_Softness), Is.EqualTo(0.6f).Within(1e-3f));
        Assert.That(At(k_Softness), Is.EqualTo(0.2f).Within(1e-3f));
        Assert.That(At(3f), Is.EqualTo(0.2f).Within(1e-4f));
    }

    // At the edge half of the light arrives; two means over a softness to either side, one after the other, end two of them away.
    [TestCase(0.001f)]
    [TestCase(0.06f)]
    public void AnEdge_IsBlurredEvenly_ToBothSides(float finest)
    {
        var map = new ShadowMap([Plate(0f, 1f), null], s_Up, k_Softness, finest);
        float At(float beyond) => map.At(1, new float3(1f + beyond, -0.5f, 0f));

        Assert.That(At(0f), Is.EqualTo(0.5f).Within(finest < 0.01f ? 0.03f : 0.1f), "coarse cells are of two samples");
        for (float away = 0.01f; away < 0.2f; away += 0.01f)
            Assert.That(At(away) + At(-away), Is.EqualTo(1f).Within(finest < 0.01f ? 0.06f : 0.2f), $"{away} to either side");
        Assert.That(At(0.5f * k_Softness), Is.InRange(0.6f, 0.85f));
        Assert.That(At(4f * k_Softness), Is.EqualTo(1f).Within(1e-4f));
        Assert.That(At(-4f * k_Softness), Is.EqualTo(0f).Within(1e-4f));
    }

    [Test]
    public void WhatTwoPlatesLeave_IsTheProduct()
    {
        var map = new ShadowMap([Plate(0f, 0.5f), Plate(1f, 0.2f), null], s_Up, k_Softness, k_Finest);

        Assert.That(map.At(2, new float3(0f, -1f, 0f)), Is.EqualTo(0.5f * 0.8f).Within(1e-3f), "below both");
        Assert.That(map.At(2, new float3(0f, 0.5f, 0f)), Is.EqualTo(0.8f).Within(1e-3f), "between them");
        Assert.That(map.At(0, new float3(0f, 0f, 0f)), Is.EqualTo(0.8f).Within(1e-3f), "on the lower one");
        Assert.That(map.At(1, new float3(0f, 1f, 0f)), Is.EqualTo(1f).Within(1e-3f), "on the upper one");
    }

    // Of two faces of one surface the nearer to the light counts: a closed body is met once.
    [Test]
    public void FacesBehindOneAnother_AreOneSurface_AsNearAsTheNearest()
    {
        ShadowCaster low = Plate(0f, 0.5f), high = Plate(1f, 0.5f);
        ShadowCaster both = new([.. low.Places, .. high.Places], [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7], [.. low.Taken, .. high.Taken]);
        var map = new ShadowMap([both, null], s_Up, k_Softness, k_Finest);

        Assert.That(map.At(1, new float3(0f, -1f, 0f)), Is.EqualTo(0.5f).Within(1e-3f));
        Assert.That(map.At(1, new float3(0f, 0.5f, 0f)), Is.EqualTo(0.5f).Within(1e-3f));
    }

    // What a plate takes changes over it as its corners say.
    [Test]
    public void BetweenCorners_TheShareChangesEvenly()
    {
        ShadowCaster plate = Plate(0f, 1f) with { Taken = [0.2f, 1f, 1f, 0.2f] };
        var map = new ShadowMap([plate, null], s_Up, k_Softness, k_Finest);

        foreach (float x in new[] { -0.6f, -0.2f, 0.3f, 0.7f })
            Assert.That(1f - map.At(1, new float3(x, -1f, 0.1f)), Is.EqualTo(0.6f + 0.4f * x).Within(0.01f));
    }

    // Nothing depends on the axes: turned and moved with its light, a scene has the shadows that it had.
    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void Turned_ASceneKeepsItsShadows()
    {
        Gen<float> number = Gen.Choose(-1000, 1000).Select(k => 0.001f * k);
        Gen<float3> vector = number.SelectMany(x => number.SelectMany(y => number.Select(z => new float3(x, y, z))));
        Arbitrary<(float3 Axis, float3 Way, float3 Place)> scenes = vector.Where(axis => math.length(axis) > 0.1f)
            .SelectMany(axis => vector.SelectMany(way => vector.Select(place => (axis, way, place)))).ToArbitrary();
        Prop.ForAll(scenes, scene =>
        {
            var turn = quaternion.AxisAngle(math.normalize(scene.Axis), 3f * scene.Way.x);
            ShadowCaster still = Plate(0.1f, 0.7f);
            ShadowCaster moved = still with { Places = Array.ConvertAll(still.Places, place => scene.Way + math.rotate(turn, place)) };
            float3 towards = math.normalize(new float3(0.4f, 1f, 0.3f));
            float one = new ShadowMap([still, null], towards, k_Softness, 0.01f).At(1, scene.Place),
                other = new ShadowMap([moved, null], math.rotate(turn, towards), k_Softness, 0.01f)
                    .At(1, scene.Way + math.rotate(turn, scene.Place));
            return one is >= 0.3f - 1e-4f and <= 1f && math.abs(one - other) < 0.08f;
        }).Check(FixedRuns.Of());
    }

    // Half of what a plate above takes away of the sky is light from all around.
    [Test]
    public void TheSky_IsHalfAsDimAsTheKeyLight()
    {
        float3 key = math.normalize(new float3(1f, 1f, 0f)), below = new(0f, -0.5f, 0f), aside = new(-1.5f, -0.9f, 0f);
        var shadows = new Shadows([Plate(0f, 0.6f), null], key, 1f, k_Finest);

        Assert.That((shadows.Key(1, below), shadows.Sky(1, below)), Is.EqualTo((0.4f, 0.7f)).Within(1e-3f));
        Assert.That((shadows.Key(1, aside), shadows.Sky(1, aside)), Is.EqualTo((0.4f, 1f)).Within(1e-3f),
            "where the slanted light is taken, but not the sky's");
        Assert.That((shadows.Key(0, below), shadows.Sky(0, below)), Is.EqualTo((1f, 1f)), "the plate itself");
    }

    // A wing lets through what it lets through, a body nothing; lines and air cast no shadow.
    [Test]
    public void OfASurface_WhatTakesLightIsItsOpacity_LessWhatPassesAWing()
    {
        float3[] rest = [new(0f, 0f, 0f), new(1f, 0f, 0f), new(0f, 0f, 1f)];
        float4[] values = [new(0f, 0f, 0f, 1f), new(0f, 0f, 0f, 0.5f), new(0f, 0f, 0f, 0f)];
        float3[] points = [.. rest.Select(place => place + 1f)];
        ShadowCaster wing = PhotoSurface.Thin(1, rest, [0, 1, 2], values, (value, _) => value).Caster(points),
            body = PhotoSurface.Of(new SurfaceMesh { triangles = [0, 1, 2], colours = [Color.white, Color.white, Color.white] })
                .Caster(points);

        Assert.That(wing.Taken, Is.EqualTo(new[] { 0.58f, 0.29f, 0f }).Within(1e-5f));
        Assert.That(body.Taken, Is.EqualTo(new[] { 1f, 1f, 1f }));
        Assert.That((wing.Places, body.Triangles), Is.EqualTo((points, new[] { 0, 1, 2 })));
        Assert.That(PhotoSurface.Thin(1, rest, [0, 1, 2], values, (value, _) => value, hasEdge: false).Caster(points), Is.Null);
        Assert.That(PhotoSurface.Outline(1, rest, [0, 1, 2], 0f).Caster(points), Is.Null);
    }

    // Of the key light's part and of that from all around the shares that arrive; what gleams at the rim stays.
    [Test]
    public void InTheShade_EachLightHasItsShare([Values] bool isThin)
    {
        var shading = new Shading(new PictureCamera(PictureView.FrontLeft, 10f));
        var random = new System.Random(3);
        float3 colour = new(0.3f, 0.5f, 0.7f);
        for (int k = 0; k < 100; k++)
        {
            float Signed() => 2f * (float)random.NextDouble() - 1f;
            float3 normal = math.normalize(new float3(Signed(), Signed(), Signed()));
            float3 At(float key, float sky) => shading.Light(colour, normal, isThin, key, sky);
            float3 none = At(0f, 0f), key = At(1f, 0f) - none, sky = At(0f, 1f) - none;

            Assert.That(math.distance(At(1f, 1f), shading.Light(colour, normal, isThin)), Is.LessThan(1e-6f));
            Assert.That(math.distance(At(0.3f, 0.6f), none + 0.3f * key + 0.6f * sky), Is.LessThan(1e-5f));
            Assert.That(math.all(none >= 0f) && math.all(none <= 0.16f * (0.4f * colour + 0.25f) + 1e-5f), Is.True, "the rim alone");
            Assert.That(math.cmin(sky), Is.GreaterThan(0.07f), "nothing is black");
        }
    }

    // A body below a wing: dark where the wing is before the light, and as ever where a scene shows numbers.
    [Test]
    public void AScene_HasShadows_ButWhereColoursAreNumbers()
    {
        PhotoScene Scene(bool hasShadows, params float[] heights) =>
            new(PictureView.ByName["side"], 2f, [.. heights.Select(Part)], hasShadows);

        Color32[] Painted(PhotoScene scene) =>
            scene.Draw(scene.PoseAt(0.0, quaternion.identity, new float3(0.1f, 0f, 0f)), new StripPanel(0f, 0f, 60f, 60f, 8f, 0f), 1f);

        int Lowest(Color32[] pixels) => pixels.Min(pixel => pixel.g);

        Color32[] shaded = Painted(Scene(true, -0.5f, 0.6f)), plain = Painted(Scene(false, -0.5f, 0.6f));
        int darker = shaded.Zip(plain, (one, other) => other.g - one.g).Count(difference => difference > 20);
        Assert.That(darker, Is.GreaterThan(40), "pixels of the lower plate");
        Assert.That(shaded.Zip(plain, (one, other) => one.g - other.g).Max(), Is.LessThanOrEqualTo(0), "nothing is lighter");
        Assert.That(Lowest(Painted(Scene(true, -0.5f))), Is.EqualTo(Lowest(plain)).Within(1), "a plate alone");

        // Air far behind it, of a wake, moves the camera away; it does not make the shadows dim.
        Color32[] Far(bool hasShadows) => Painted(Scene(hasShadows, -0.5f, 0.6f).With([], 20f));
        Assert.That(Far(true).Zip(Far(false), (one, other) => other.g - one.g).Count(difference => difference > 20),
            Is.EqualTo(darker).Within(40).Percent);

        static PhotoPart Part(float height, int index)
        {
            // Upright plates, one before the other as the light from the upper left before the viewer's side sees them.
            float3[] places = [new(-0.8f, height - 0.4f, -0.8f), new(-0.8f, height - 0.4f, 0.8f), new(0.8f, height + 0.4f, 0.8f),
                new(0.8f, height + 0.4f, -0.8f)];
            float3 normal = math.normalize(math.cross(places[1] - places[0], places[2] - places[0]));
            return new PhotoPart(PhotoSurface.Of(new SurfaceMesh
            {
                triangles = [0, 1, 2, 0, 2, 3],
                colours = [.. Enumerable.Repeat(new Color(0.8f, 0.8f, 0.8f, 1f), 4)],
            }), 1f, _ => (places, [.. places.Select(_ => normal)]));
        }
    }

    // Two units wide and deep about the axis.
    private static ShadowCaster Plate(float height, float taken) => new(
        [new(-1f, height, -1f), new(1f, height, -1f), new(1f, height, 1f), new(-1f, height, 1f)], [0, 1, 2, 0, 2, 3],
        [taken, taken, taken, taken]);
}
