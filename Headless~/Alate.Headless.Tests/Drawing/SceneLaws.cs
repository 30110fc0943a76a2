using System;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Drawing;

/// <summary>Laws of pictures of scenes: what is seen where, and in what light.</summary>
public sealed class SceneLaws
{
    private const int k_Width = 120, k_Height = 80;

    private static readonly SceneLight s_Even = new(1f, 1f, 1f, new float3(0f, 1f, 0f), 0f, false, []);
    private static readonly float3 s_Red = new(1f, 0f, 0f), s_Green = new(0f, 1f, 0f), s_Blue = new(0f, 0f, 1f);

    // A plate of two units at twice the distance is half as wide: its edges lie where a lens puts them.
    [TestCase(4f, 60f)]
    [TestCase(8f, 60f)]
    [TestCase(3f, 90f)]
    public void APlate_IsSeen_WhereALensPutsIt(float distance, float opening)
    {
        Color32[] picture = Paint(Camera(default, opening), s_Even, Facing(distance, 1f, s_Red));

        float reach = 0.5f * k_Height / math.tan(math.radians(0.5f * opening)) / distance;
        for (int y = 0; y < k_Height; y++)
        {
            for (int x = 0; x < k_Width; x++)
            {
                float2 from = math.abs(new float2(x + 0.5f - 0.5f * k_Width, y + 0.5f - 0.5f * k_Height)) - reach;
                float outside = math.cmax(from);
                if (math.abs(outside) < 1.5f)
                    continue;
                Assert.That(IsOf(picture[y * k_Width + x], s_Red), Is.EqualTo(outside < 0f), $"{x}, {y}");
            }
        }
    }

    // Right is right, and up is up; a camera that turns to the right sees it move to the left.
    [Test]
    public void RightAndUp_AreWhereTheyAre()
    {
        SceneSurface right = Square(new float3(1f, 0f, 5f), 0.3f, s_Red), up = Square(new float3(0f, 1f, 5f), 0.3f, s_Green);
        (float2 red, float2 green) = (Middle(s_Red), Middle(s_Green));

        Assert.That(red.x, Is.GreaterThan(0.5f * k_Width + 5f));
        Assert.That(red.y, Is.EqualTo(0.5f * k_Height).Within(0.6f));
        Assert.That(green.y, Is.LessThan(0.5f * k_Height - 5f));
        Assert.That(green.x, Is.EqualTo(0.5f * k_Width).Within(0.6f));
        Assert.That(Middle(s_Red, 5f).x, Is.LessThan(red.x - 3f));
        Assert.That(Middle(s_Red, 0f, 5f).y, Is.LessThan(red.y - 3f), "what it looks down on moves up");

        float2 Middle(float3 colour, float yaw = 0f, float pitch = 0f)
        {
            Color32[] picture = Paint(
                new SceneCamera(0f, Quaternion.Euler(pitch, yaw, 0f), 60f, 0.1f, new int2(k_Width, k_Height)), s_Even, right, up);
            float2[] places = [.. Enumerable.Range(0, picture.Length).Where(k => IsOf(picture[k], colour))
                .Select(k => new float2(k % k_Width + 0.5f, k / k_Width + 0.5f))];
            return places.Aggregate((a, b) => a + b) / places.Length;
        }
    }

    // One triangle of a floor reaches from behind the eye to far ahead; posts that stand on it hide it down to their feet, and none of them
    // is hidden by it. Depths that were blended along the screen would hide the near ones.
    [Test]
    public void OnAFloorThatGoesBehindTheEye_PostsAreSeenToTheirFeet()
    {
        const float below = 1f;
        var floor = new SceneSurface(
            [new float3(-400f, -below, -50f), new float3(0f, -below, 900f), new float3(400f, -below, -50f)], [.. Up(3)], [0, 1, 2], null,
            null, Look(s_Green));
        foreach (float distance in new[] { 2f, 5f, 12f, 40f })
        {
            SceneSurface post = Square(new float3(0f, -below + 0.2f * distance, distance), 0.2f * distance, s_Red);
            Color32[] picture = Paint(Camera(default), s_Even, floor, post);

            float focus = 0.5f * k_Height / math.tan(math.radians(30f)), foot = 0.5f * k_Height + focus * below / distance;
            for (int y = 0; y < k_Height; y++)
            {
                Color32 middle = picture[y * k_Width + k_Width / 2];
                if (math.abs(y + 0.5f - foot) < 1.5f || y + 0.5f < foot - 0.4f * focus + 1.5f)
                    continue;
                Assert.That(IsOf(middle, y + 0.5f < foot ? s_Red : s_Green), $"row {y} of a post at {distance}");
            }

            int horizon = k_Height / 2;
            Assert.That(IsOf(picture[(horizon + 3) * k_Width + 5], s_Green), "the floor ends at the horizon");
            Assert.That(IsOf(picture[(horizon - 3) * k_Width + 5], s_Blue), "above it is what is behind");
        }
    }

    [Test]
    public void BehindTheEye_NothingIsSeen() =>
        Assert.That(Paint(Camera(default), s_Even, Facing(-3f, 1f, s_Red)).Count(pixel => IsOf(pixel, s_Blue)),
            Is.EqualTo(k_Width * k_Height));

    // Colours of corners blend along the surface, not along the screen: the middle of a floor of two ends is nearer to the far one.
    [Test]
    public void ColoursOfCorners_BlendAlongTheSurface()
    {
        var floor = new SceneSurface(
            [new float3(-9f, -1f, 2f), new float3(-9f, -1f, 10f), new float3(9f, -1f, 10f), new float3(9f, -1f, 2f)], [.. Up(4)],
            [0, 1, 2, 0, 2, 3], null, [new float4(0f, 0f, 0f, 1f), 1f, 1f, new float4(0f, 0f, 0f, 1f)],
            Look(1f) with { ShowsColours = true });
        Color32[] picture = Paint(Camera(default), s_Even, floor);

        float focus = 0.5f * k_Height / math.tan(math.radians(30f));
        for (int y = 0; y < k_Height; y++)
        {
            float depth = focus / (y + 0.5f - 0.5f * k_Height);
            if (depth is < 2.3f or > 9f)
                continue;
            float shown = Shading.ToLinear(picture[y * k_Width + k_Width / 2].g / 255f).x;
            Assert.That(shown, Is.EqualTo((depth - 2f) / 8f).Within(0.03f), $"row {y}");
        }
    }

    // The shadow of a plate is the plate moved along the light.
    [Test]
    public void AShadow_LiesWhereTheSunPutsIt()
    {
        float3 sun = math.normalize(new float3(1f, 1f, 0f));
        SceneSurface plate = Flat(new float3(0f, 2f, 10f), 1f), floor = Flat(new float3(0f, 0f, 10f), 6f);
        var map = new SunMap([floor, plate], sun, new float3(0f, 0f, 10f), 40f);

        for (float x = -5f; x <= 5f; x += 0.05f)
        {
            // Two units below, under a sun at 45 degrees: two units aside.
            float inside = 1f - math.abs(x + 2f);
            if (math.abs(inside) > 0.05f)
                Assert.That(map.At(new float3(x, 0f, 10f)), Is.EqualTo(inside > 0f ? 0f : 1f), $"{x}");
        }

        var clear = new SunMap([floor, plate with { CastsShadow = false }], sun, new float3(0f, 0f, 10f), 40f);
        Assert.That(clear.At(new float3(-2f, 0f, 10f)), Is.EqualTo(1f), "a plate that casts none");
        Assert.That(map.At(new float3(0f, 2f, 10f)), Is.EqualTo(1f), "the plate itself");
        Assert.That(map.At(new float3(-2f, 0f, 12f)), Is.EqualTo(1f), "beside it");
        Assert.That(map.At(new float3(99f, 0f, 10f)), Is.EqualTo(1f), "beside all");
    }

    // What is far off keeps no shadow near the eye from being fine.
    [Test]
    public void ShadowsEnd_AtTheirDistance_AndAreAsFineForAllThatLiesBeyond()
    {
        float3 up = new(0f, 1f, 0f);
        SceneSurface near = Flat(new float3(0f, 1f, 0f), 0.1f), far = Flat(new float3(500f, 1f, 0f), 1f), floor = Flat(0f, 900f);
        var map = new SunMap([floor, near, far], up, 0f, 10f);

        Assert.That(map.At(0f), Is.Zero);
        Assert.That(map.At(new float3(0.15f, 0f, 0f)), Is.EqualTo(1f), "cells of a far floor would be half a unit wide");
        Assert.That(map.At(new float3(500f, 0f, 0f)), Is.EqualTo(1f));
    }

    [Test]
    public void ASunWithoutShadows_LightsWhatLiesBelowAPlate([Values] bool hasShadows)
    {
        var light = new SceneLight(0f, 0f, 0f, new float3(0f, 1f, 0f), 1f, hasShadows, []);
        SceneSurface floor = Flat(new float3(0f, -1f, 5f), 4f), plate = Flat(new float3(0f, 3f, 5f), 4f);
        Color32[] picture = Paint(Camera(default), light, floor, plate);

        Color32 below = picture[(k_Height - 10) * k_Width + k_Width / 2];
        Assert.That(below.r, Is.EqualTo(hasShadows ? 0 : 255));
    }

    // Bright colours go as far as it says, black ones stay, and the upper side has none of it.
    [Test]
    public void TheLowerSideOfAWing_IsPaler_WhereItIsBright()
    {
        var even = new SceneLight(1f, 1f, 1f, new float3(0f, 1f, 0f), 0f, false, []);
        float3 up = new(0f, 1f, 0f), orange = new(1f, 0.3f, 0.1f), black = 0f;
        SceneLook wing = Look(1f) with { IsTwoSided = true, Underside = new float4(0.8f, 0.7f, 0.6f, 0.5f) };

        Assert.That(math.distance(even.Of(wing, orange, 0f, up, up, 1f), orange), Is.LessThan(1e-6f), "above");
        Assert.That(math.distance(even.Of(wing, orange, 0f, up, -up, 1f), new float3(0.9f, 0.5f, 0.35f)), Is.LessThan(1e-6f), "below");
        Assert.That(math.distance(even.Of(wing, 0.5f * orange, 0f, up, -up, 1f), new float3(0.575f, 0.2875f, 0.1875f)),
            Is.LessThan(1e-6f), "half as bright");
        Assert.That(math.length(even.Of(wing, black, 0f, up, -up, 1f)), Is.Zero, "a vein");
        wing = wing with { IsTwoSided = false };
        Assert.That(math.distance(even.Of(wing, orange, 0f, up, -up, 1f), orange), Is.LessThan(1e-6f), "a body");
    }

    [TestCase(0f)]
    [TestCase(35f)]
    [TestCase(80f)]
    public void ASurface_AnswersToTheSun_AsTheCosineOfItsAngle(float degrees)
    {
        math.sincos(math.radians(degrees), out float sine, out float cosine);
        var light = new SceneLight(0f, 0f, 0f, new float3(sine, cosine, 0f), 0.8f, false, []);
        float3 up = new(0f, 1f, 0f);

        Assert.That(light.Of(Look(1f), 0.5f, 0f, up, up, 1f).x, Is.EqualTo(0.4f * cosine).Within(1e-5f));
        Assert.That(light.Of(Look(1f), 0.5f, 0f, up, up, 0.25f).x, Is.EqualTo(0.1f * cosine).Within(1e-5f), "in a half shade");
        Assert.That(light.Of(Look(1f) with { IsTwoSided = true }, 0.5f, 0f, -up, up, 1f).x, Is.EqualTo(0.4f * cosine).Within(1e-5f));
        Assert.That(light.Of(Look(1f), 0.5f, 0f, -up, -up, 1f).x, Is.EqualTo(0f), "its other side");
        float passed = light.Of(Look(1f) with { Through = 0.6f }, 0.5f, 0f, -up, -up, 1f).x;
        Assert.That(passed, Is.EqualTo(0.8f * 0.6f * 0.5f * (0.35f + 0.65f * 0.5f) * cosine).Within(1e-5f), "what passes");
    }

    [Test]
    public void LightFromAround_IsThatOfTheSideASurfaceLooksTo()
    {
        var light = new SceneLight(s_Blue, s_Green, s_Red, new float3(0f, 1f, 0f), 0f, false, []);
        float3 Of(float3 normal) => light.Of(Look(1f), 1f, 0f, normal, normal, 0f);

        Assert.That(Of(new float3(0f, 1f, 0f)), Is.EqualTo(s_Blue));
        Assert.That(Of(new float3(0f, 0f, 1f)), Is.EqualTo(s_Green));
        Assert.That(Of(new float3(0f, -1f, 0f)), Is.EqualTo(s_Red));
        Assert.That(Of(new float3(0f, 0.6f, 0.8f)), Is.EqualTo(math.lerp(s_Green, s_Blue, 0.6f)));
    }

    // By the square of the distance, and to nothing at its range.
    [Test]
    public void ALamp_FadesWithTheSquareOfTheDistance_AndEndsAtItsRange()
    {
        var light = new SceneLight(0f, 0f, 0f, new float3(0f, 1f, 0f), 0f, false, [new SceneLamp(0f, 1f, 10f)]);
        float At(float distance)
        {
            float3 up = new(0f, 1f, 0f);
            return light.Of(Look(1f), 1f, new float3(0f, -distance, 0f), up, up, 0f).x;
        }

        Assert.That(At(0.5f) / At(1f), Is.EqualTo(4f).Within(0.01f));
        Assert.That(At(1f), Is.EqualTo(1f).Within(0.001f));
        Assert.That(At(9.9f), Is.InRange(1e-9f, 1e-4f));
        Assert.That(At(10.1f), Is.Zero);
    }

    // A far checkerboard is grey, and none of a texture's colour comes from texels that are seen through.
    [Test]
    public void ATextureSeenSmall_IsItsMean()
    {
        const int side = 16;
        var board = new Color[side * side];
        for (int k = 0; k < board.Length; k++)
            board[k] = (k % side + k / side) % 2 == 0 ? Color.white : new Color(0f, 0f, 0f, 1f);
        var picture = new MippedPicture(side, side, board);

        Assert.That(picture.ColourAt(new float2(0.5f / side), 0f).x, Is.EqualTo(1f).Within(1e-5f));
        Assert.That(picture.ColourAt(new float2(1.5f / side, 0.5f / side), 0f).x, Is.EqualTo(0f).Within(1e-5f));
        foreach (float level in new[] { 1f, 1.7f, 4f, 99f })
            Assert.That(picture.ColourAt(0.37f, level).x, Is.EqualTo(0.5f).Within(1e-5f), $"level {level}");

        Color[] holes = Array.ConvertAll(board, texel => texel.r > 0f ? Color.white : Color.clear);
        float4 seen = new MippedPicture(side, side, holes).ColourAt(0.37f, 4f);
        Assert.That((seen.x, seen.w), Is.EqualTo((1f, 0.5f)).Within(1e-5f));
    }

    // A plate whose picture is clear but for a disc of half its width, from near by and from afar, where a texel is a part of a pixel.
    [TestCase(1.2f, 0.03f)]
    [TestCase(4f, 0.06f)]
    public void WhatIsCut_EndsWhereItsPictureDoes(float distance, float error)
    {
        const int side = 64;
        Color[] disc = [.. Enumerable.Range(0, side * side).Select(k =>
            math.length(new float2(k % side + 0.5f, k / side + 0.5f) / side - 0.5f) < 0.25f ? Color.red : Color.clear)];
        double Red(bool isCut) => Paint(Camera(default, 90f), s_Even, Facing(distance, 1f, 1f) with
        {
            Coordinates = [0f, new float2(1f, 0f), 1f, new float2(0f, 1f)],
            Look = Look(1f) with { Picture = new MippedPicture(side, side, disc), IsCut = isCut },
        }).Sum(pixel => (255 - pixel.b) / 255.0);

        double half = 0.5 * k_Height / distance;
        Assert.That(Red(true), Is.EqualTo(Math.PI * 0.25 * half * half).Within(100.0 * error).Percent);
        Assert.That(Red(false), Is.GreaterThan(3.0 * Red(true)), "all of the plate");
    }

    private static SceneCamera Camera(float3 place, float opening = 60f) =>
        new(place, quaternion.identity, opening, 0.1f, new int2(k_Width, k_Height));

    private static Color32[] Paint(SceneCamera camera, SceneLight light, params SceneSurface[] surfaces) =>
        ScenePicture.Paint(camera, surfaces, light, s_Blue);

    private static SceneLook Look(float3 colour) => new(null, new float4(colour, 1f), false, false, false, 0f, 0f, 24f);

    private static SceneSurface Facing(float distance, float half, float3 colour) => Square(new float3(0f, 0f, distance), half, colour);

    private static SceneSurface Square(float3 middle, float half, float3 colour) => new(
        [.. Corners(half).Select(corner => middle + new float3(corner, 0f))], [.. Enumerable.Repeat(new float3(0f, 0f, -1f), 4)],
        [0, 1, 2, 0, 2, 3], null, null, Look(colour));

    private static SceneSurface Flat(float3 middle, float half) => new(
        [.. Corners(half).Select(corner => middle + new float3(corner.x, 0f, corner.y))], [.. Up(4)], [0, 1, 2, 0, 2, 3], null, null,
        Look(1f));

    private static float2[] Corners(float half) => [new(-half, -half), new(-half, half), new(half, half), new(half, -half)];

    private static float3[] Up(int count) => [.. Enumerable.Repeat(new float3(0f, 1f, 0f), count)];

    private static bool IsOf(Color32 pixel, float3 colour) =>
        math.all(math.abs(new float3(pixel.r, pixel.g, pixel.b) / 255f - colour) < 0.02f);
}
