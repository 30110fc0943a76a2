using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests;

/// <summary>Boxes around the joints of wings that the graphics card deforms, beside vertices that the processor deformed.</summary>
public sealed class PaletteBoundsTests
{
    private const int k_Steps = 100;

    private static IEnumerable<string> Species => InsectCatalogue.All.Select(species => species.Name);

    // In winds and gusts from all sides, up to the top speed.
    [TestCaseSource(nameof(Species))]
    public void ABox_HoldsEachVertex_AndIsNotMuchLarger(string name)
    {
        float farthest = float.NegativeInfinity, largest = 0f;
        foreach (WingDefinition kind in InsectCatalogue.Find(name).Wings)
        {
            foreach (WingSide side in new[] { WingSide.Left, WingSide.Right })
            {
                WingPreset preset = kind.CreatePreset();
                WingSkeleton skeleton = kind.CreateSkeleton(side);
                var rig = WingRig.Bake(skeleton, kind.CreateSurface(side), WingRigSettings.Default);
                using var world = new WingWorld();
                WingHandle drawn = world.Add(rig, preset.ToParameters()),
                    shown = world.Add(rig, preset.ToParameters(), default, default, VertexPacking.Joints);
                rig.Release();
                Assert.That(world.Vertices(shown).IsCreated || world.PackedVertices(shown).IsCreated, Is.False);
                var random = new Random(17);
                for (int step = 0; step < k_Steps; step++)
                {
                    var around = new WingSurroundings
                    {
                        wind = random.NextFloat3Direction() * random.NextFloat() * preset.ToParameters().maxSpeed / preset.WingLength,
                        gravity = new float3(0f, -EarthGravity.Size / preset.WingLength, 0f),
                        speed = 1f,
                    };
                    world.SetSurroundings(drawn, around);
                    world.SetSurroundings(shown, around);
                    world.Step(1f / 60f);
                    world.Skin();
                    Bounds exact = world.Bounds(drawn), box = world.Bounds(shown);
                    float length = rig.Frame.length, reach = rig.View.skinReach;
                    farthest = math.max(farthest, Beyond(world, shown, rig, exact) / length);
                    Assert.That(box.Contains(exact.min) && box.Contains(exact.max), Is.True, $"step {step}");
                    largest = math.max(largest, math.cmax((float3)(box.size - exact.size)) / length);
                    Assert.That(box.size.magnitude, Is.LessThan(exact.size.magnitude + 2f * 1.74f * (reach + 0.01f * length) + 1e-3f));
                }

                UnityEngine.Object.DestroyImmediate(preset);
                UnityEngine.Object.DestroyImmediate(skeleton);
            }
        }

        TestContext.Progress.WriteLine(
            $"{name}: vertices up to {farthest:F4} wing lengths beyond joints and reach, boxes up to {largest:F3} larger");
        Assert.That(farthest, Is.LessThan(0.005f), "the margin is 0.01");
    }

    // Of the exact box beyond that around the joints, less their reach.
    private static float Beyond(WingWorld world, WingHandle wing, WingRig rig, Bounds exact)
    {
        float3 least = float.PositiveInfinity, most = float.NegativeInfinity;
        NativeArray<DualQuaternion> palette = world.Palette(wing);
        for (int joint = 0; joint < palette.Length; joint++)
        {
            float3 place = palette[joint].Move(rig.Frame.ToMesh(rig.RestJoints[joint]));
            least = math.min(least, place);
            most = math.max(most, place);
        }

        return math.max(math.cmax(least - (float3)exact.min), math.cmax((float3)exact.max - most)) - rig.View.skinReach;
    }
}
