using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Inflow replayed at wings: its series, how it comes and goes, and that it is felt as a wind.</summary>
    public sealed unsafe class WakeInflowLaws
    {
        private static readonly WingInflow s_Inflow = new WingInflow
        {
            mean = new float3(1f, -2f, 3f),
            cosine1 = new float3(0.5f, 0f, -1f),
            sine1 = new float3(0f, 2f, 0.25f),
            cosine2 = new float3(-1f, 1f, 0f),
            sine2 = new float3(0.3f, 0.1f, 0.7f),
        };

        // e-folds in 0.4 beats, whatever the length of a substep; each wing by its own.
        [Test]
        public void AnInflow_ComesWithinABeat_AndGoesAgain()
        {
            LaneInflow inflow = default;
            BeatState beat = default;
            beat.frequency = new float4(10f, 10f, 20f, 10f);
            beat.phase = new float4(0.3f, 1.7f, 4f, 5f);
            var pack = new WingPack { inflow = &inflow, beat = &beat };
            for (int lane = 0; lane < 3; lane++)
                inflow.Set(lane, s_Inflow * (lane + 1f));
            Assert.That((float3)inflow.velocity[0], Is.EqualTo(float3.zero));
            for (int step = 0; step < 8; step++)
                WakeInflow.Advance(pack, 0.005f);
            for (int lane = 0; lane < 3; lane++)
            {
                float share = 1f - math.exp(-0.04f * beat.frequency[lane] / 0.4f);
                float3 expected = (lane + 1f) * share * s_Inflow.At(beat.phase[lane]);
                Assert.That(math.distance(inflow.velocity[lane], expected), Is.LessThan(1e-4f), $"wing {lane}");
            }

            Assert.That(math.length(inflow.velocity[3]), Is.Zero, "it has none");

            inflow.Set(1, default);
            float before = math.length(inflow.velocity[1]);
            WakeInflow.Advance(pack, 0.04f);
            Assert.That(math.length(inflow.velocity[1]), Is.EqualTo(before * math.exp(-1f)).Within(1e-3f * before), "it goes as it came");
            for (int step = 0; step < 100; step++)
                WakeInflow.Advance(pack, 0.04f);
            Assert.That(math.length(inflow.velocity[1]), Is.Zero);
            Assert.That(inflow.acts, Is.EqualTo(new float4(1f, 0f, 1f, 0f)));
            Assert.That(math.distance(inflow.velocity[0], s_Inflow.At(0.3f)), Is.LessThan(1e-4f));

            WakeInflow.Reset(pack, new bool4(true, false, false, false));
            Assert.That(math.length(inflow.velocity[0]), Is.Zero, "air at rest");
            Assert.That(math.distance(inflow.velocity[2], 3f * s_Inflow.At(4f)), Is.LessThan(1e-3f), "the others go on");
            WakeInflow.Advance(pack, 0.04f);
            Assert.That(math.distance(inflow.velocity[0], (1f - math.exp(-1f)) * s_Inflow.At(0.3f)), Is.LessThan(1e-4f), "it comes again");
        }

        [Test]
        public void ASteadyInflow_IsFeltAsTheSameWind([Values] bool addedMass)
        {
            var blow = new float3(0.7f, -3f, -4f);
            using (var world = new WingWorld())
            {
                WingRig rig = Monarch.Rig(64);
                WingParameters parameters = WingParameters.Default;
                parameters.strongestWind = 1000f;
                parameters.options.addedMass = addedMass;
                WingHandle windy = world.Add(rig, parameters, new WingSurroundings { wind = blow, speed = 1f }),
                    still = world.Add(rig, parameters, new WingSurroundings { speed = 1f });
                parameters.inflow.mean = blow;
                WingHandle replayed = world.Add(rig, parameters, new WingSurroundings { speed = 1f });
                rig.Release();
                for (int step = 0; step < 200; step++)
                    world.Step(0.005f);
                float3[] a = SpeciesFlight.Joints(world.Read(windy)), b = SpeciesFlight.Joints(world.Read(replayed));
                Assert.That(SpeciesFlight.Distance(a, b), Is.LessThan(1e-4));
                Assert.That(SpeciesFlight.Distance(a, SpeciesFlight.Joints(world.Read(still))), Is.GreaterThan(1e-3));
                Assert.That(math.distance(world.Read(windy).AirForce, world.Read(replayed).AirForce),
                    Is.LessThan(1e-3f * math.length(world.Read(windy).AirForce)));
            }
        }

        [Test]
        public void PartsOfAnInflow_AreAddedAndScaled_AndNamedWhereTheyAreNone()
        {
            Assert.That((s_Inflow + s_Inflow * -1f).IsSet, Is.False);
            Assert.That(math.distance((s_Inflow * 2f).At(1.1f), 2f * s_Inflow.At(1.1f)), Is.LessThan(1e-5f));
            Assert.That(s_Inflow.At(0.4f + 2f * math.PI).Equals(default), Is.False);
            Assert.That(default(WingInflow).IsSet, Is.False);
            WingParameters parameters = WingParameters.Default;
            Assert.That(parameters.FindProblem(), Is.Null);
            parameters.inflow.sine2.y = float.NaN;
            Assert.That(parameters.FindProblem(), Does.StartWith("inflow.sine2 is (0, NaN, 0) wing lengths per second"));
            Assert.That(parameters.Clamped().inflow.IsSet, Is.False);
            parameters.inflow.sine2.y = 1f;
            Assert.That(parameters.SameAs(WingParameters.Default), Is.False);
        }

        [Test]
        public void NumbersOfAPreset_AreMetresASecond_WithinAHundred()
        {
            WingPreset preset = ScriptableObject.CreateInstance<WingPreset>();
            Assert.That(preset.ToParameters().inflow.IsSet, Is.False);
            preset.Inflow.mean = new Vector3(0.1f, -0.2f, 0.3f);
            preset.Inflow.cosine1 = new Vector3(1f, 2f, 3f);
            preset.Inflow.sine1 = new Vector3(4f, 5f, 6f);
            preset.Inflow.cosine2 = new Vector3(7f, 8f, 9f);
            preset.Inflow.sine2 = new Vector3(1e9f, float.NaN, -1e9f);
            WingInflow inflow = preset.ToParameters().inflow * preset.WingLength;
            preset.Size.wingLength = 1e-9f;
            Assert.That(preset.ToParameters().inflow.sine2.x, Is.EqualTo(2e5f).Within(1f), "of the shortest wing in the fastest air");
            Object.DestroyImmediate(preset);

            Assert.That(math.distance(inflow.mean, new float3(0.1f, -0.2f, 0.3f)), Is.LessThan(1e-6f));
            Assert.That(math.distance(inflow.cosine1, new float3(1f, 2f, 3f)), Is.LessThan(1e-5f));
            Assert.That(math.distance(inflow.sine1, new float3(4f, 5f, 6f)), Is.LessThan(1e-5f));
            Assert.That(math.distance(inflow.cosine2, new float3(7f, 8f, 9f)), Is.LessThan(1e-5f));
            Assert.That(math.distance(inflow.sine2, new float3(100f, 0f, -100f)), Is.LessThan(1e-3f));
        }
    }
}
