using System;
using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// The time scheme remembers the substep before. Whatever interrupts a wing, it stays finite and is back on the path of a wing that
    /// nothing interrupted within a few beats, at the same phase.
    /// </summary>
    public sealed class HistoryTests
    {
        /// <summary>
        /// Frames of a beat of four substeps each, of three with fewer substeps; and of one substep each, whose lengths are those of the
        /// frames.
        /// </summary>
        private const int k_Steps = 4, k_ShortSteps = 24;

        private const int k_Settling = 6, k_Back = 4;
        private const double k_Same = 1e-3, k_Felt = 1e-5;

        // A wing that was made up for a time beats as one that has always been commanded so: nothing glides on from the beat before it.
        [Test]
        public void AfterAResume_NothingOfTheLastCommandIsLeft()
        {
            var drive = new WingDrive { frequency = 12f, amplitude = 0.7f, meanFlap = 0.5f };
            drive.meanSweep = 0.2f;
            drive.meanFeather = -0.3f;
            drive.tilt = 0.4f;
            WingRig rig = Monarch.Rig(32);
            using (var world = new WingWorld())
            {
                WingHandle changed = world.Add(rig, Monarch.Parameters), always = world.Add(rig, Monarch.Parameters);
                rig.Release();
                world.SetDrive(changed, drive);
                world.SetDrive(always, drive);
                while (world.Read(changed).Beats < 1)
                    world.Step(0.004f);
                world.Reset(always);
                float phase = world.Read(changed).Phase / (2f * math.PI);
                Assert.That(phase, Is.LessThan(0.2f), "in the middle of a glide");
                world.Resume(changed, 10f / 12f);
                world.Resume(always, (10f + phase) / 12f);
                for (int chain = 0; chain < 5; chain++)
                {
                    float3 tip = world.Read(changed).JointPosition(chain, 4), wanted = world.Read(always).JointPosition(chain, 4);
                    Assert.That(math.distance(tip, wanted), Is.LessThan(1e-3f), $"chain {chain}");
                }
            }
        }

        [Test]
        public void AfterAReset_TheWingIsSoonBackInItsBeat() => AssertBack((world, wing, dt) =>
        {
            world.Reset(wing);
            Assert.That(world.Read(wing).Phase, Is.Zero);
        });

        [Test]
        public void AfterAResume_TheWingIsSoonBackInItsBeat()
        {
            using (var flight = new SpeciesFlight(InsectCatalogue.Find("monarch").Wings[0]))
            using (WingWorld one = new WingWorld(), other = new WingWorld())
            {
                WingHandle steady = one.Add(flight.Rig, flight.parameters, flight.Air()),
                    halted = other.Add(flight.Rig, flight.parameters, flight.Air());
                float dt = 1f / (k_Steps * one.Read(steady).Frequency);
                Step(one, dt, k_Settling * k_Steps);
                Step(other, dt, k_Settling * k_Steps);
                Step(one, dt, 7);
                other.Resume(halted, 7 * dt);
                AssertBack(one, steady, other, halted, dt, k_Steps);
            }
        }

        [TestCase(WingDetail.FewerSubsteps)]
        [TestCase(WingDetail.CoarsePatches)]
        [TestCase(WingDetail.WavesOnly)]
        public void AfterATimeAtLessDetail_TheWingIsSoonBackInItsBeat(WingDetail detail) => AssertBack((world, wing, dt) =>
        {
            world.SetDetail(wing, detail);
            Step(world, dt, k_Steps);
            world.SetDetail(wing, WingDetail.Full);
        });

        [Test]
        public void AfterFramesOfAnotherLength_TheWingIsSoonBackInItsBeat() => AssertBack(k_ShortSteps, (world, wing, dt) =>
        {
            // Ratios of 3 and a third both ways; the longer one restarts the history.
            foreach (float length in new[] { dt / 3f, dt, dt / 3f, dt / 9f, dt / 3f, dt })
                Step(world, length, (int)math.round(dt / length * 4f));
        });

        [TestCase(3f)]
        [TestCase(1f / 3f)]
        public void AfterFramesThatAlternate_TheWingIsSoonBackInItsBeat(float ratio) => AssertBack(k_ShortSteps, (world, wing, dt) =>
        {
            // One long and one short frame fill two.
            for (int k = 0; k < k_ShortSteps / 2; k++)
            {
                world.Step(2f * dt / (1f + ratio));
                world.Step(2f * dt * ratio / (1f + ratio));
            }
        });

        [Test]
        public void AfterOtherParameters_TheWingIsSoonBackInItsBeat() => AssertBack((world, wing, dt) =>
        {
            WingParameters own = Monarch.Parameters, soft = own;
            soft.elasticity *= 0.3f;
            soft.jointLimit *= 0.5f;
            world.SetParameters(wing, soft);
            Step(world, dt, k_Steps / 2);
            world.SetParameters(wing, own);
            Step(world, dt, k_Steps / 2);
        });

        [TestCase(TimeScheme.BackwardEuler, MembraneCoupling.TwoWay)]
        [TestCase(TimeScheme.SecondOrder, MembraneCoupling.OneWay)]
        [TestCase(TimeScheme.BackwardEuler, MembraneCoupling.OneWay)]
        public void AfterATimeInAnotherModel_TheWingIsSoonBackInItsBeat(
            TimeScheme scheme, MembraneCoupling coupling) => AssertBack((world, wing, dt) =>
        {
            WingParameters own = Monarch.Parameters, other = own;
            other.options.timeScheme = scheme;
            other.options.coupling = coupling;
            world.SetParameters(wing, other);
            Step(world, dt, k_Steps / 2);
            world.SetParameters(wing, own);
            Step(world, dt, k_Steps / 2);
        });

        [Test]
        public void AResetWing_FliesAsANewOne()
        {
            using (var flight = new SpeciesFlight(InsectCatalogue.Find("monarch").Wings[0]))
            using (WingWorld one = new WingWorld(), other = new WingWorld())
            {
                WingHandle reset = one.Add(flight.Rig, flight.parameters, flight.Air());
                float dt = 1f / (k_Steps * one.Read(reset).Frequency);
                Step(one, dt, 13);
                one.Reset(reset);
                WingHandle fresh = other.Add(flight.Rig, flight.parameters, flight.Air());
                for (int k = 0; k < 40; k++)
                {
                    one.Step(dt);
                    other.Step(dt);
                    Assert.That(SpeciesFlight.Joints(one.Read(reset)), Is.EqualTo(SpeciesFlight.Joints(other.Read(fresh))), $"step {k}");
                }
            }
        }

        [Test]
        public void AWingThatMovesToAnotherLane_FliesOn_ToTheBit()
        {
            // The neighbour beats as often, in more wind; where both worlds step alike, its leaving must not be felt.
            using (var flight = new SpeciesFlight(InsectCatalogue.Find("monarch").Wings[0]))
            using (WingWorld one = new WingWorld(), other = new WingWorld())
            {
                one.Add(flight.Rig, flight.parameters, flight.Air(new float3(0f, 0f, -1f), flight.Speed));
                WingHandle leaves = other.Add(flight.Rig, flight.parameters, flight.Air(new float3(0f, 0f, -1f), flight.Speed));
                WingHandle stays = one.Add(flight.Rig, flight.parameters, flight.Air()),
                    moves = other.Add(flight.Rig, flight.parameters, flight.Air());
                float dt = 1f / (k_Steps * one.Read(stays).Frequency);
                Step(one, dt, 50);
                Step(other, dt, 50);
                float3[] before = SpeciesFlight.Joints(other.Read(moves));
                other.Remove(leaves);
                Assert.That(SpeciesFlight.Joints(other.Read(moves)), Is.EqualTo(before), "moving");
                for (int k = 0; k < 3 * k_Steps; k++)
                {
                    one.Step(dt);
                    other.Step(dt);
                    Assert.That(
                        SpeciesFlight.Joints(other.Read(moves)), Is.EqualTo(SpeciesFlight.Joints(one.Read(stays))), $"step {k} after it");
                }
            }
        }

        private static void AssertBack(Action<WingWorld, WingHandle, float> interrupt) => AssertBack(k_Steps, interrupt);

        // Interrupts one of two settled wings and flies the other one on for as long; both are at the same phase then, a reset one after
        // whole beats.
        private static void AssertBack(int steps, Action<WingWorld, WingHandle, float> interrupt)
        {
            using (var flight = new SpeciesFlight(InsectCatalogue.Find("monarch").Wings[0]))
            using (WingWorld one = new WingWorld(), other = new WingWorld())
            {
                WingHandle steady = one.Add(flight.Rig, flight.parameters, flight.Air()),
                    interrupted = other.Add(flight.Rig, flight.parameters, flight.Air());
                float dt = 1f / (steps * one.Read(steady).Frequency);
                Step(one, dt, k_Settling * steps);
                Step(other, dt, k_Settling * steps);
                interrupt(other, interrupted, dt);
                for (int k = 0; k < 2 * steps && Apart(one.Read(steady).Phase, other.Read(interrupted).Phase) > 1e-3f; k++)
                    one.Step(dt);
                AssertBack(one, steady, other, interrupted, dt, steps);
            }
        }

        private static void AssertBack(WingWorld one, WingHandle steady, WingWorld other, WingHandle interrupted, float dt, int steps)
        {
            double first = 0.0, last = 0.0;
            for (int k = 0; k < (k_Back + 1) * steps; k++)
            {
                one.Step(dt);
                other.Step(dt);
                double distance = SpeciesFlight.Distance(
                    SpeciesFlight.Joints(one.Read(steady)), SpeciesFlight.Joints(other.Read(interrupted)));
                Assert.That(distance, Is.LessThan(0.5), $"step {k}");
                if (k < steps)
                    first = Math.Max(first, distance);
                if (k >= k_Back * steps)
                    last = Math.Max(last, distance);
            }

            Assert.That(other.Read(interrupted).Resets, Is.Zero);
            Assert.That(Apart(one.Read(steady).Phase, other.Read(interrupted).Phase), Is.LessThan(1e-3f));
            TestContext.Progress.WriteLine(FormattableString.Invariant(
                $"{TestContext.CurrentContext.Test.Name}: off by {first:P3} in the first beat, {last:P4} after {k_Back}"));
            Assert.That(first, Is.GreaterThan(k_Felt), "what interrupts is felt");
            Assert.That(last, Is.LessThan(k_Same));
        }

        private static float Apart(float a, float b) => math.abs(a - b) > math.PI ? 2f * math.PI - math.abs(a - b) : math.abs(a - b);

        private static void Step(WingWorld world, float dt, int count)
        {
            for (int k = 0; k < count; k++)
                world.Step(dt);
        }
    }
}
