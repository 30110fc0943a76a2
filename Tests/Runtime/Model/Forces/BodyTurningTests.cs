using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Force and moment of the air on a wing of a body that turns, on either side.</summary>
    public sealed class BodyTurningTests
    {
        private const float k_Same = 2e-4f;

        // Wind, spin, hinge.
        [TestCase(0f, -2f, -20f, 0f, 0f, 0f, 0f, 0f, 0f)]
        [TestCase(3f, -8f, -15f, 0f, 0f, 0f, 0.2f, 0.1f, -0.3f)]
        [TestCase(0f, 0f, -20f, 0f, 0f, 6f, 0.1f, 0f, 0f)]
        [TestCase(0f, 1f, -20f, 0f, 9f, 0f, 0.1f, 0f, 0.2f)]
        [TestCase(0f, 0f, -20f, 12f, 0f, 0f, 0.1f, 0f, 0.4f)]
        [TestCase(2f, 5f, -11f, 7f, -4f, 9f, 0.15f, 0.05f, 0.2f)]
        public void EveryPatch_MeetsTheWindLessTheTurningOfItsPlace(
            float windX, float windY, float windZ, float spinX, float spinY, float spinZ, float hingeX, float hingeY, float hingeZ)
        {
            float3 wind = new float3(windX, windY, windZ), spin = new float3(spinX, spinY, spinZ),
                hinge = new float3(hingeX, hingeY, hingeZ);
            foreach (int side in new[] { 1, -1 })
            {
                // A left wing is read as a right one in a mirror: x of vectors, y and z of turns and moments.
                float3 mirror = new float3(side, 1f, 1f), turned = new float3(1f, side, side), at = mirror * hinge;
                RigidPlate.Read(new WingSurroundings { wind = mirror * wind, angularVelocity = turned * spin, hinge = hinge },
                    out float3 force, out float3 moment);
                RigidPlate.Sum(side, wind, spin, at, out float3 wantedForce, out float3 wantedMoment);

                Assert.That(math.length(wantedForce), Is.GreaterThan(1f));
                Assert.That(math.distance(mirror * force, wantedForce), Is.LessThan(k_Same * math.length(wantedForce)),
                    $"force, side {side}: {mirror * force}, not {wantedForce}");
                Assert.That(math.distance(turned * moment, wantedMoment), Is.LessThan(k_Same * math.length(wantedMoment)),
                    $"moment, side {side}: {turned * moment}, not {wantedMoment}");
            }
        }

        // The forces of patches beyond the last chain act on its joints, so that their moment is not theirs.
        [TestCase(0f, 0f, 6f)]
        [TestCase(12f, 0f, 0f)]
        [TestCase(7f, -4f, 9f)]
        public void PatchesBeyondTheChains_MeetTheTurningOfTheirOwnPlace(float spinX, float spinY, float spinZ)
        {
            float3 wind = new float3(2f, 5f, -11f), spin = new float3(spinX, spinY, spinZ), hinge = new float3(0.15f, 0.05f, 0.2f);
            RigidPlate.Read(new WingSurroundings { wind = wind, angularVelocity = spin, hinge = hinge }, out float3 force, out _,
                0.5f * RigidPlate.k_Chord);
            RigidPlate.Sum(1, wind, spin, hinge, out float3 wanted, out _);

            Assert.That(math.distance(force, wanted), Is.LessThan(k_Same * math.length(wanted)), $"{force}, not {wanted}");
        }

        [TestCase(0, 3f)]
        [TestCase(0, 10f)]
        [TestCase(1, 3f)]
        [TestCase(1, 10f)]
        [TestCase(2, 3f)]
        [TestCase(2, 10f)]
        public void ABodyThatTurns_IsHeldBackByItsBeatingWings_AboutEveryAxis(int axis, float rate)
        {
            float3 spin = float3.zero;
            spin[axis] = rate;
            float with = Moment(spin)[axis], against = Moment(-spin)[axis];
            TestContext.Progress.WriteLine($"axis {axis}, {rate} rad/s: {with} and {against}");

            Assert.That(with - against, Is.LessThan(-0.01f * rate));
        }

        [Test]
        public void MomentOfAFlyingWing_IsThatOfItsPatches()
        {
            WingParameters parameters = Monarch.Parameters;
            WingSurroundings air = Monarch.Flying();
            air.hinge = new float3(0.05f, 0.02f, 0.1f);
            air.angularVelocity = new float3(1f, -2f, 3f);
            WingRig rig = Monarch.Rig(64);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, parameters, air);
                rig.Release();
                world.RecordPatches(wing, true);
                float dt = 1f / (480f * world.Read(wing).Frequency);
                for (int k = 0; k < 480; k++)
                    world.Step(dt);
                for (int k = 0; k < 480; k++)
                {
                    world.Step(dt);
                    WingReading reading = world.Read(wing);
                    float3 sum = float3.zero;
                    float sizes = 0f;
                    for (int patch = 0; patch < reading.PatchCount; patch++)
                    {
                        // Loads are made on the surface as it is expected at the end of the substep; there the patches are to a thousandth.
                        float3 moment = math.cross(reading.PatchPosition(patch) + air.hinge, reading.PatchForce(patch));
                        sum += moment;
                        sizes += math.length(moment);
                    }

                    for (int joint = 0; joint < reading.ChainCount * reading.JointsPerChain; joint++)
                    {
                        float3 place = reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain);
                        sum += math.cross(place + air.hinge, reading.JointForce(joint));
                    }

                    Assert.That(math.distance(reading.AirMoment, sum), Is.LessThan(1e-3f * sizes), $"substep {k}");
                }
            }
        }

        // Of both wings about the middle of the body, mean over a beat: the left one turns as a right one with y and z of the spin
        // reversed.
        private static float3 Moment(float3 spin)
        {
            var mirror = new float3(1f, -1f, -1f);
            return Mean(spin) + mirror * Mean(mirror * spin);
        }

        private static float3 Mean(float3 spin)
        {
            const int steps = 24, beats = 4;
            WingSurroundings air = Monarch.Flying();
            air.hinge = new float3(0.03f, 0f, 0f);
            air.angularVelocity = spin;
            WingRig rig = Monarch.Rig(64);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Monarch.Parameters, air);
                rig.Release();
                float dt = 1f / (steps * world.Read(wing).Frequency);
                float3 mean = float3.zero;
                for (int k = 0; k < beats * steps; k++)
                {
                    world.Step(dt);
                    if (k >= (beats - 1) * steps)
                        mean += world.Read(wing).AirMoment / steps;
                }

                return mean;
            }
        }
    }
}
