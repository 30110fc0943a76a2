using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>
/// Palette of the editor as it was designed: hue in degrees, and strength, lightness and opacity in per cent. A colour that is changed by
/// intent is changed here too; what makes it readable is held by the laws of the gizmos and the ramps.
/// </summary>
public sealed class PaletteTests
{
    private static readonly Dictionary<string, (int Hue, int Strength, int Lightness, int Opacity)> s_Palette = new()
    {
        ["LoopPreview.s_Ground"] = (0, 0, 16, 100),
        ["LoopPreview.s_Chain"] = (32, 79, 95, 100),
        ["LoopPreview.s_Rim"] = (214, 37, 95, 100),
        ["GizmoColours.s_Early"] = (42, 78, 100, 100),
        ["GizmoColours.s_Middle"] = (351, 60, 87, 100),
        ["GizmoColours.s_Late"] = (231, 69, 87, 100),
        ["GizmoColours.Hinge"] = (0, 0, 100, 100),
        ["GizmoColours.Span"] = (7, 62, 93, 100),
        ["GizmoColours.Up"] = (99, 52, 83, 100),
        ["GizmoColours.Load"] = (190, 63, 95, 60),
        ["GizmoColours.Force"] = (188, 80, 100, 100),
        ["GizmoColours.Velocity"] = (0, 0, 100, 90),
        ["GizmoColours.Wind"] = (210, 40, 100, 90),
        ["GizmoColours.Bounds"] = (0, 0, 70, 50),
        ["BeatGraph.s_Axis"] = (0, 0, 50, 50),
        ["BeatGraph.s_DarkGround"] = (0, 0, 0, 25),
        ["BeatGraph.s_LightGround"] = (0, 0, 100, 35),
        ["RigColouring.s_Ramp[0]"] = (243, 72, 32, 100),
        ["RigColouring.s_Ramp[1]"] = (258, 65, 62, 100),
        ["RigColouring.s_Ramp[2]"] = (330, 60, 73, 100),
        ["RigColouring.s_Ramp[3]"] = (24, 70, 96, 100),
        ["RigColouring.s_Ramp[4]"] = (49, 38, 100, 100),
        ["SkeletonColours.principalChain"] = (28, 85, 100, 100),
        ["SkeletonColours.chain"] = (202, 55, 100, 100),
        ["SkeletonColours.row"] = (202, 55, 100, 30),
        ["SkeletonColours.joint"] = (210, 10, 100, 100),
        ["SkeletonColours.selected"] = (53, 90, 100, 100),
        ["SkeletonColours.hovered"] = (0, 0, 100, 100),
        ["SkeletonColours.problem"] = (4, 80, 100, 100),
        ["SkeletonColours.hinge"] = (130, 60, 100, 100),
        ["SkeletonColours.beat"] = (120, 35, 85, 35),
        ["SkeletonColours.beatEdges"] = (120, 67, 30, 25),
        ["SkeletonColours.boxEdge"] = (210, 60, 100, 80),
        ["SkeletonColours.box"] = (210, 60, 100, 20),
        ["WingTracePreview.s_Outline"] = (206, 89, 90, 100),
        ["WingTracePreview.s_Vein"] = (131, 73, 75, 100),
        ["WingTracePreview.s_OnVein"] = (295, 72, 90, 100),
        ["WingTracePreview.s_Fitted"] = (8, 79, 95, 100),
    };

    [Test]
    public void EveryColourOfTheEditor_IsThatOfThePalette()
    {
        var colours = typeof(BeatGraph).Assembly.GetTypes().SelectMany(Colours)
            .ToDictionary(one => one.Name, one => one.Colour);
        Assert.That(colours.Keys, Is.EquivalentTo(s_Palette.Keys));
        foreach ((string name, Color colour) in colours)
        {
            (int hue, int strength, int lightness, int opacity) = s_Palette[name];
            float most = Mathf.Max(colour.r, Mathf.Max(colour.g, colour.b)), least = Mathf.Min(colour.r, Mathf.Min(colour.g, colour.b));
            float[] found = [most > 0f ? 100f * (most - least) / most : 0f, 100f * most, 100f * colour.a];
            Assert.That(found, Is.EqualTo(new float[] { strength, lightness, opacity }).Within(0.6f), name);
            float off = Hue(colour, most, least) - hue;
            Assert.That(off - 360f * MathF.Round(off / 360f), Is.EqualTo(0f).Within(0.6f), name);
        }
    }

    private static IEnumerable<(string Name, Color Colour)> Colours(Type type)
    {
        foreach (FieldInfo field in type.GetFields(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
        {
            if (field.FieldType == typeof(Color))
                yield return ($"{type.Name}.{field.Name}", (Color)field.GetValue(null));
            if (field.FieldType != typeof(Color[]))
                continue;
            var many = (Color[])field.GetValue(null);
            for (int k = 0; k < many.Length; k++)
                yield return ($"{type.Name}.{field.Name}[{k}]", many[k]);
        }
    }

    private static float Hue(Color colour, float most, float least)
    {
        float range = most - least;
        if (range == 0f)
            return 0f;
        float sixth = colour.r == most ? (colour.g - colour.b) / range
            : colour.g == most ? 2f + (colour.b - colour.r) / range
            : 4f + (colour.r - colour.g) / range;
        return 60f * sixth;
    }
}
