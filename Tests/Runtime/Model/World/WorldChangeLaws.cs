using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Changes of a world between two steps leave what is read of the other wings as it was.</summary>
    public sealed class WorldChangeLaws
    {
        private static readonly (string Name, Action<WingWorld, WingHandle, WingRig> Act)[] s_Changes =
        {
            ("another wing", (world, other, rig) => world.Add(rig, Monarch.Parameters)),
            ("one less", (world, other, rig) => world.Remove(other)),
            ("other options", (world, other, rig) => world.SetParameters(other, Printed())),
            ("less detail", (world, other, rig) => world.SetDetail(other, WingDetail.WavesOnly)),
            ("loads kept", (world, other, rig) => world.RecordPatches(other, true)),
        };

        private static IEnumerable<int> Changes => new[] { 0, 1, 2, 3, 4 };

        [Test]
        public void AChange_LeavesPosesBoundsAndSubstepsOfOthers([ValueSource(nameof(Changes))] int change)
        {
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                WingHandle first = world.Add(rig, Monarch.Parameters, Monarch.Flying()), other = world.Add(rig, Monarch.Parameters),
                    last = world.Add(rig, Monarch.Parameters, Monarch.Flying());
                for (int step = 0; step < 3; step++)
                    world.Step(0.037f);
                world.Skin();
                WingHandle[] others = { first, last };
                (int Substeps, float3 Within, float3 End, Bounds Bounds)[] before = Array.ConvertAll(others, wing => Read(world, wing));
                s_Changes[change].Act(world, other, rig);
                for (int k = 0; k < 2; k++)
                {
                    (int substeps, float3 within, float3 end, Bounds bounds) = before[k];
                    Assert.That(substeps, Is.GreaterThan(4));
                    Assert.That(math.distance(within, end), Is.GreaterThan(1e-3f));
                    Assert.That(bounds.size.x, Is.GreaterThan(0.1f));
                    Assert.That(Read(world, others[k]), Is.EqualTo(before[k]), $"{s_Changes[change].Name}: wing {k}");
                }
            }

            rig.Release();
        }

        [Test]
        public void AWingThatIsNotDrawn_StaysSo_WhateverComesOrGoes()
        {
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                WingHandle seen = world.Add(rig, Monarch.Parameters), unseen = world.Add(rig, Monarch.Parameters);
                world.Skin();
                float3 before = world.Vertices(unseen)[40].position;
                world.SetSkinned(unseen, false);
                for (int round = 0; round < 2; round++)
                {
                    world.Step(0.03f);
                    world.Skin();
                    Assert.That(world.Vertices(unseen)[40].position, Is.EqualTo(before), $"round {round}");
                    Assert.That(math.distance(world.Vertices(seen)[40].position, before), Is.GreaterThan(1e-3f), $"round {round}");
                    world.Add(rig, Monarch.Parameters);
                }

                world.SetSkinned(unseen, true);
                world.Skin();
                float3 other = world.Vertices(seen)[40].position;
                Assert.That(math.distance(world.Vertices(unseen)[40].position, other), Is.LessThan(1e-4f));
            }

            rig.Release();
        }

        [Test]
        public void ADriveOutOfRange_IsRefused_AndChangesNothing()
        {
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.Parameters);
                rig.Release();
                var drive = new WingDrive { frequency = 11f, amplitude = 1f };
                world.SetDrive(wing, drive);
                Assert.That(() => world.SetDrive(wing, new WingDrive { frequency = 11f, amplitude = 2.5f }),
                    Throws.ArgumentException.With.Message.Contains("11 Hz, 2.5 times the").And.Message.Contains("0.1 to 1000 Hz"));
                Assert.That(world.Drive(wing), Is.EqualTo(drive));
            }
        }

        [TestCase(0, 0.15f)]
        [TestCase(1, 0.2f)]
        [TestCase(2, 20f)]
        [TestCase(3, 20f)]
        [TestCase(4, 0.2f)]
        [TestCase(5, 15f)]
        public void ACommand_MayLeaveTheTrim_AsFarAsItsLimit(int command, float most)
        {
            // 15 % of the frequency, 0.2 of the amplitude, 20° of tilt and sweep, 0.2 and 15° between the sides.
            float found = FlightCommands.Limit(command) * FlightCommands.Unit(command, 1f);

            Assert.That(most > 1f ? found * Mathf.Rad2Deg : found, Is.EqualTo(most).Within(1e-4f));
        }

        // As one that was resumed after the leader's time: at its phase, unbent.
        [Test]
        public void AWingThatFollowsAnother_IsInTheDrivenPoseOfItsPhase()
        {
            WingRig rig = Monarch.Rig(16);
            using (var world = new WingWorld())
            {
                WingHandle leader = world.Add(rig, Monarch.Parameters);
                for (int step = 0; step < 9; step++)
                    world.Step(0.01f);
                WingHandle follower = world.Add(rig, Monarch.Parameters), resumed = world.Add(rig, Monarch.Parameters);
                float3 before = world.Read(follower).JointPosition(2, 4);
                world.Follow(follower, leader);
                world.Resume(resumed, 0.09f);

                WingReading followed = world.Read(follower), alone = world.Read(resumed);
                Assert.That(followed.Phase, Is.EqualTo(world.Read(leader).Phase).Within(1e-5f));
                Assert.That(math.distance(followed.JointPosition(2, 4), alone.JointPosition(2, 4)), Is.LessThan(1e-3f));
                Assert.That(math.distance(followed.JointPosition(2, 4), before), Is.GreaterThan(0.02f));
                Assert.That(math.distance(followed.JointPosition(2, 4), world.Read(leader).JointPosition(2, 4)), Is.GreaterThan(1e-3f));
            }

            rig.Release();
        }

        private static (int Substeps, float3 Within, float3 End, Bounds Bounds) Read(WingWorld world, WingHandle wing)
        {
            WingReading reading = world.Read(wing);
            return (reading.Substeps, reading.JointPosition(2, 4, 0.3f), reading.JointPosition(2, 4), world.Bounds(wing));
        }

        private static WingParameters Printed()
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.options = ModelOptions.Paper;
            return parameters;
        }
    }
}
