using System;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingWorldTests
    {
        [Test]
        public void RestingWing_KeepsItsRestMesh()
        {
            WingParameters still = WingParameters.Default;
            still.amplitude = float3.zero;
            still.meanFlap = 0f;
            WingRig rig = Monarch.Rig();
            SurfaceMesh mesh = InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, still);
                rig.Release();
                world.Step(0.02f);
                world.Skin(0.5f);
                NativeArray<SkinnedVertex> vertices = world.Vertices(wing);
                for (int k = 0; k < vertices.Length; k++)
                {
                    Assert.That(math.distance(vertices[k].position, mesh.positions[k]), Is.LessThan(1e-6f * 0.61f));
                    Assert.That(math.distance(vertices[k].normal, mesh.normals[k]), Is.LessThan(2e-6f));
                }
            }
        }

        [TestCase(24f)]
        [TestCase(30f)]
        [TestCase(60f)]
        [TestCase(90f)]
        [TestCase(144f)]
        public void StepsOfOtherLengths_LeadToTheSameWing(float stepsPerSecond)
        {
            float3[] reference = Fly(1f / 50f, 1.2f), other = Fly(1f / stepsPerSecond, 1.2f);
            for (int joint = 0; joint < reference.Length; joint++)
                Assert.That(math.distance(reference[joint], other[joint]), Is.LessThan(0.01f), $"joint {joint}");
        }

        [Test]
        public void ZeroOrNegativeTime_ChangesNothing()
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.Step(0.02f);
                float3 before = flown.Reading.JointPosition(0, 4);
                flown.world.Step(0f);
                flown.world.Step(-1f);
                Assert.That(flown.Reading.JointPosition(0, 4), Is.EqualTo(before));
            }
        }

        [Test]
        public void ALongHitch_IsCutToSixteenBeats_AndStaysFinite()
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.Step(5f);
                WingReading reading = flown.Reading;
                Assert.That(reading.Substeps, Is.LessThanOrEqualTo(16 * 24));
                Assert.That(reading.Beats, Is.LessThanOrEqualTo(16));
                Assert.That(math.all(math.isfinite(reading.JointPosition(4, 4))));
                Assert.That(reading.Resets, Is.Zero);
            }
        }

        [Test]
        public void StartingFromRest_BeatsWithinOneSecond()
        {
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.Parameters);
                rig.Release();
                float lowest = 1f, highest = -1f;
                for (int k = 0; k < 50; k++)
                {
                    world.Step(0.02f);
                    float height = world.Read(wing).JointPosition(0, 4).y;
                    lowest = math.min(lowest, height);
                    highest = math.max(highest, height);
                }

                Assert.That(world.Read(wing).Beats, Is.GreaterThanOrEqualTo(8));
                Assert.That(highest - lowest, Is.GreaterThan(0.7f));
            }
        }

        [Test]
        public void TwoHundredBeats_StayPeriodic()
        {
            using (var flown = new FlownMonarch())
            {
                float dt = flown.Substep;
                float EnergyAfter(int beats)
                {
                    for (int k = 0; k < 24 * beats; k++)
                        flown.world.Step(dt);
                    return flown.Reading.SpringEnergy;
                }

                float settled = EnergyAfter(12);
                float late = EnergyAfter(188);
                Assert.That(late, Is.EqualTo(settled).Within(1e-3 * settled));
                Assert.That(flown.Reading.Resets, Is.Zero);
                Assert.That(flown.Reading.Beats, Is.InRange(199, 200));
            }
        }

        [Test]
        public void NeighboursInAPack_DoNotFeelEachOther()
        {
            WingRig rig = Monarch.Rig();
            using (var alone = new WingWorld())
            using (var crowd = new WingWorld())
            {
                WingHandle single = alone.Add(rig, Monarch.Parameters, Monarch.Flying());
                WingParameters soft = Monarch.Parameters;
                soft.elasticity = 0.3f;
                soft.chordDelay = 0.4f;
                crowd.Add(rig, soft, Monarch.Flying(0.4f, 0.6f));
                crowd.Add(rig, soft, Monarch.Flying(1.9f, -0.2f));
                WingHandle inCrowd = crowd.Add(rig, Monarch.Parameters, Monarch.Flying());
                rig.Release();
                float dt = 1f / (24f * 11f);
                for (int k = 0; k < 100; k++)
                {
                    alone.Step(dt);
                    crowd.Step(dt);
                }

                for (int chain = 0; chain < 5; chain++)
                {
                    for (int joint = 0; joint < 5; joint++)
                    {
                        float3 a = alone.Read(single).JointPosition(chain, joint), b = crowd.Read(inCrowd).JointPosition(chain, joint);
                        Assert.That(math.distance(a, b), Is.LessThan(1e-6f), $"joint {chain}, {joint}");
                    }
                }
            }
        }

        [Test]
        public void RemovingWings_MovesOthersIntoTheirPlace_WithoutAJump()
        {
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                var wings = new WingHandle[9];
                for (int k = 0; k < wings.Length; k++)
                {
                    wings[k] = world.Add(rig, Monarch.Parameters, Monarch.Flying(0.2f * k));
                    world.Step(0.013f);
                }

                rig.Release();
                float3 eighth = world.Read(wings[8]).JointPosition(2, 3), fifth = world.Read(wings[5]).JointPosition(2, 3);
                world.Remove(wings[1]);
                world.Remove(wings[6]);
                Assert.That(world.Count, Is.EqualTo(7));
                Assert.That(world.PackCount, Is.EqualTo(2));
                Assert.That(world.Read(wings[8]).JointPosition(2, 3), Is.EqualTo(eighth));
                Assert.That(world.Read(wings[5]).JointPosition(2, 3), Is.EqualTo(fifth));
                Assert.Throws<ArgumentException>(() => world.Read(wings[1]));
                world.Step(0.02f);
                world.Skin();
                Assert.That(math.all(math.isfinite(world.Vertices(wings[8])[10].position)));
            }
        }

        [Test]
        public void ChangedOptions_KeepTheMotion()
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.Step(0.05f);
                float3 before = flown.Reading.JointPosition(1, 4);
                WingParameters changed = Monarch.Parameters;
                changed.options.coefficients = CoefficientSet.FlatPlate;
                flown.world.SetParameters(flown.wing, changed);
                Assert.That(flown.Reading.JointPosition(1, 4), Is.EqualTo(before));
                flown.world.Step(0.05f);
                Assert.That(flown.Reading.Resets, Is.Zero);
            }
        }

        [Test]
        public void ATimeToMakeUpFor_LeavesAPhase([Values(1e3f, 1e9f)] float seconds)
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.Resume(flown.wing, seconds);
                flown.world.Step(0.02f);
                Assert.That(flown.Reading.Phase, Is.InRange(0f, 2f * math.PI));
                Assert.That(math.all(math.isfinite(flown.Reading.JointPosition(4, 4))));
                ArgumentException tooLong = Assert.Throws<ArgumentException>(() => flown.world.Resume(flown.wing, 1e38f));
                Assert.That(tooLong.Message, Does.Contain("1E+38"));
            }
        }

        [Test]
        public void BadInput_IsNamed_AndChangesNothing()
        {
            using (var flown = new FlownMonarch())
            {
                WingParameters bad = Monarch.Parameters;
                bad.elasticity = float.NaN;
                ArgumentException parameterError = Assert.Throws<ArgumentException>(() => flown.world.SetParameters(flown.wing, bad));
                Assert.That(parameterError.Message, Does.Contain("elasticity"));
                var wind = new WingSurroundings { wind = new float3(float.PositiveInfinity, 0f, 0f) };
                ArgumentException windError = Assert.Throws<ArgumentException>(() => flown.world.SetSurroundings(flown.wing, wind));
                Assert.That(windError.Message, Does.Match(@"wind is \((Infinity|∞), 0, 0\); it must be finite"));
                Assert.Throws<ArgumentException>(() => flown.world.Step(float.NaN));
                Assert.Throws<ArgumentException>(() => flown.world.Remove(default));
                Assert.Throws<ArgumentNullException>(() => flown.world.Add(null, bad));
                flown.world.Step(0.02f);
                Assert.That(flown.Reading.Resets, Is.Zero);
            }
        }

        [Test]
        public void Bounds_HoldEveryVertex_AndNoMore()
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.Step(0.03f);
                flown.world.Skin(0.7f);
                AssertBounds(flown.world, flown.wing);
            }
        }

        [Test]
        public void BoundsOfALargeMesh_WhichSeveralWorkersSkin_AreThoseOfAllItsVertices()
        {
            WingRig rig = TestWings.Bake(TestWings.Fan(), TestWings.Rectangle(100, 60, 1f, 0.4f));
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, WingParameters.Default);
                rig.Release();
                for (int step = 0; step < 12; step++)
                {
                    world.Step(0.01f);
                    world.Skin(0.5f);
                    AssertBounds(world, wing);
                }
            }
        }

        private static void AssertBounds(WingWorld world, WingHandle wing)
        {
            Bounds bounds = world.Bounds(wing);
            float3 min = float.MaxValue, max = float.MinValue;
            foreach (SkinnedVertex vertex in world.Vertices(wing))
            {
                min = math.min(min, vertex.position);
                max = math.max(max, vertex.position);
            }

            Assert.That(math.distance(min, bounds.min), Is.LessThan(1e-6f));
            Assert.That(math.distance(max, bounds.max), Is.LessThan(1e-6f));
        }

        private static float3[] Fly(float step, float seconds)
        {
            using (var flown = new FlownMonarch())
            {
                for (double time = 0.0; time < seconds - 1e-6; time += step)
                    flown.world.Step((float)math.min(step, seconds - time));
                var joints = new float3[25];
                for (int joint = 0; joint < joints.Length; joint++)
                    joints[joint] = flown.Reading.JointPosition(joint / 5, joint % 5);
                return joints;
            }
        }

        [Test]
        public void JobsOfOthers_AreWaitedFor_AlsoWhereNothingIsToDo([Values] bool withWings, [Values] bool skin)
        {
            using (var world = new WingWorld())
            using (var numbers = new NativeArray<int>(1, Allocator.TempJob))
            {
                if (withWings)
                {
                    WingRig rig = Monarch.Rig();
                    world.Add(rig, Monarch.Parameters);
                    rig.Release();
                }

                JobHandle other = new CountJob { numbers = numbers }.Schedule();
                JobHandle last = skin ? world.ScheduleSkin(1f, other) : world.ScheduleStep(0f, other);
                last.Complete();

                Assert.That(other.IsCompleted, Is.True);
                Assert.That(() => numbers[0], Throws.Nothing);
                world.Complete();
            }
        }

        private struct CountJob : IJob
        {
            public NativeArray<int> numbers;

            public void Execute() => numbers[0]++;
        }
    }
}
