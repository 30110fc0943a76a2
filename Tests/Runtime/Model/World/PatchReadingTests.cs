using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Places of the patches, and their loads.</summary>
    public sealed unsafe class PatchReadingTests
    {
        [Test]
        public void PatchesOfARestingWing_LieAtTheirRestCentres()
        {
            WingParameters still = WingParameters.Default;
            still.amplitude = float3.zero;
            still.meanFlap = 0f;
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, still);
                rig.Release();
                WingReading reading = world.Read(wing);
                for (int patch = 0; patch < reading.PatchCount; patch++)
                {
                    float3 position = reading.PatchPosition(patch);
                    Assert.That(position.x, Is.EqualTo(rig.View.patchSpan[patch]).Within(1e-5f), $"patch {patch}");
                    Assert.That(position.z, Is.EqualTo(rig.View.patchChord[patch]).Within(1e-5f), $"patch {patch}");
                }
            }
        }

        [Test]
        public void PatchForces_AndWhatJointsFeelBeside_AddUpToTheAirForce()
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.RecordPatches(flown.wing, true);
                for (int step = 0; step < 40; step++)
                    flown.world.Step(1f / 300f);

                WingReading reading = flown.Reading;
                float3 sum = float3.zero;
                for (int patch = 0; patch < reading.PatchCount; patch++)
                    sum += reading.PatchForce(patch);
                for (int joint = 0; joint < reading.ChainCount * reading.JointsPerChain; joint++)
                    sum += reading.JointForce(joint);

                Assert.That(reading.Substeps, Is.EqualTo(1), "the air force is the mean of several substeps");
                Assert.That(math.length(sum), Is.GreaterThan(0f));
                Assert.That(math.distance(sum, reading.AirForce), Is.LessThan(1e-4f * math.length(sum)));
            }
        }

        [Test]
        public void JointLoads_AreThePatchForces_InSumAndMoment()
        {
            using (var flown = new FlownMonarch())
            {
                flown.world.RecordPatches(flown.wing, true);
                for (int step = 0; step < 40; step++)
                    flown.world.Step(1f / 300f);

                WingReading reading = flown.Reading;
                var loads = new float3[reading.ChainCount * reading.JointsPerChain];
                reading.AddJointLoads(loads);
                float3 force = default, moment = default, first = default, jointForce = default, jointMoment = default;
                for (int patch = 0; patch < reading.PatchCount; patch++)
                {
                    force += reading.PatchForce(patch);
                    moment += math.cross(reading.PatchPosition(patch), reading.PatchForce(patch));
                }

                for (int joint = 0; joint < loads.Length; joint++)
                {
                    force += reading.JointForce(joint);
                    moment += math.cross(
                        reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain), reading.JointForce(joint));
                    first += joint == 0 ? loads[joint] : default;
                    jointForce += loads[joint];
                    jointMoment += math.cross(
                        reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain), loads[joint]);
                }

                Assert.That(math.distance(jointForce, force), Is.LessThan(1e-4f * math.length(force)));
                Assert.That(math.distance(jointMoment, moment), Is.LessThan(1e-4f * math.length(moment)));
                reading.AddJointLoads(loads);
                Assert.That(math.distance(loads[0], 2f * first), Is.LessThan(1e-6f + 1e-4f * math.length(first)), "added");
            }
        }

        [Test]
        public void PlacesWithinAStep_AreThoseOfTheDrawnMesh()
        {
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.Parameters, Monarch.Flying());
                rig.Release();
                float3 before = default, after = default;
                for (int step = 0; step < 5; step++)
                {
                    before = world.Read(wing).JointPosition(2, 4);
                    world.Step(0.02f);
                    after = world.Read(wing).JointPosition(2, 4);
                }

                Assert.That(math.distance(before, after), Is.GreaterThan(0.1f));
                Assert.That(math.distance(world.Read(wing).JointPosition(2, 4, 0f), before), Is.LessThan(1e-6f));
                Assert.That(math.distance(world.Read(wing).JointPosition(2, 4, 1f), after), Is.LessThan(1e-6f));
                float3 middle = world.Read(wing).JointPosition(2, 4, 0.5f);
                Assert.That(math.length(middle), Is.InRange(0.5f, 1.1f), "the joint leaves its circle between two steps");
                Assert.That(math.distance(middle, before) + math.distance(middle, after), Is.LessThan(1.5f * math.distance(before, after)));
            }
        }

        [Test]
        public void PatchThatIsNotThere_IsRefused()
        {
            using (var flown = new FlownMonarch())
            {
                WingReading reading = flown.Reading;
                Assert.That(() => reading.PatchPosition(-1), Throws.InstanceOf<System.ArgumentOutOfRangeException>());
                Assert.That(() => reading.PatchPosition(reading.PatchCount), Throws.InstanceOf<System.ArgumentOutOfRangeException>());
            }
        }

        [Test]
        public void AReadingOfBefore_IsToldFromOneOfNow([Values] bool stepped)
        {
            using (var flown = new FlownMonarch())
            {
                WingReading reading = flown.Reading;
                Assert.That(() => reading.JointPosition(0, 0), Throws.Nothing);
                if (stepped)
                    flown.world.Step(1f / 300f);
                else
                    flown.world.SetDetail(flown.wing, WingDetail.WavesOnly);

                Assert.That(() => reading.JointPosition(0, 0), Throws.InvalidOperationException.With.Message.Contains("out of date"));
                Assert.That(() => reading.Frequency, Throws.InvalidOperationException);
                Assert.That(() => flown.Reading.JointPosition(0, 0), Throws.Nothing);
            }
        }
    }
}
