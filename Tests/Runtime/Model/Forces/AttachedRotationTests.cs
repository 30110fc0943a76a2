using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Rotation of a wing whose flow is attached, beside the three-quarter-chord rule.</summary>
    public sealed class AttachedRotationTests
    {
        private const float k_Speed = 20f, k_Turning = 0.5f;

        // A plate that turns nose up at q meets at three quarters of its chord what one that does not would meet in a wind that rises by
        // q c/4 more; what stands across the stream feels none of it.
        [TestCase(5f)]
        [TestCase(20f)]
        [TestCase(45f)]
        [TestCase(-20f)]
        public void AWingThatTurns_MeetsTheAirOfItsThreeQuarterChord(float degrees)
        {
            math.sincos(math.radians(degrees), out float sin, out float cos);
            var wind = new float3(0f, k_Speed * sin, -k_Speed * cos);
            float rise = 0.25f * RigidPlate.k_Chord * k_Turning * cos * cos;
            float3 turns = Force(wind, true), keeps = Force(wind, false), rises = Force(wind + new float3(0f, rise, 0f), false);

            float3 gained = turns - keeps, wanted = rises - keeps;
            Assert.That(math.length(gained - wanted), Is.LessThan(0.02f * math.length(wanted)));
            Assert.That(gained.y, Is.GreaterThan(0f), "nose up lifts");
        }

        [Test]
        public void AWingAcrossTheStream_FeelsNothingOfIt()
        {
            var wind = new float3(0f, k_Speed, 0f);
            Assert.That(math.length(Force(wind, true) - Force(wind, false)), Is.LessThan(1e-3f * math.length(Force(wind, false))));
        }

        [Test]
        public void AWingThatDoesNotTurn_FeelsNothingOfIt()
        {
            var wind = new float3(0f, 5f, -k_Speed);
            Assert.That(Force(wind, true, 0f), Is.EqualTo(Force(wind, false, 0f)));
        }

        private static float3 Force(float3 wind, bool attached, float turning = k_Turning)
        {
            WingParameters parameters = RigidPlate.Parameters;
            parameters.options.attachedRotation = attached;
            WingRig rig = RigidPlate.Rig();
            using (var world = new WingWorld())
            {
                // +X turns the nose down.
                WingHandle wing = world.Add(
                    rig, parameters, new WingSurroundings { wind = wind, angularVelocity = new float3(-turning, 0f, 0f) });
                rig.Release();
                world.Step(1e-3f);
                return world.Read(wing).AirForce;
            }
        }
    }
}
