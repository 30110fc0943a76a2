using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Crowds
{
    /// <summary>Motions that are baked: the air and gravity that the body meets, the beat, and ranges.</summary>
    public sealed class BakeMotionTests
    {
        [TestCase(0f)]
        [TestCase(20f)]
        [TestCase(-35f)]
        public void TheBody_MeetsGravityAndItsVelocity_AsItsPitchTurnsThem(float pitch)
        {
            var motion = new BakeMotion("own") { Speed = 0.5f, Climb = 0.25f, PitchDegrees = pitch };
            BodyFlight flight = motion.FlightOf(4f, 0.5f, 0.02f);

            // The clip's attitude takes the body's axes to the level ones: nose up is a negative turn about X.
            var attitude = quaternion.RotateX(-math.radians(pitch));
            Assert.That(math.distance(math.rotate(attitude, flight.gravity), new float3(0f, -9.81f, 0f)), Is.LessThan(1e-4f));
            Assert.That(math.distance(math.rotate(attitude, flight.velocity) * 0.02f, new float3(0f, 1f, 2f)), Is.LessThan(1e-4f),
                "units of 2 cm a second");
            Assert.That(flight.Pitch, Is.EqualTo(math.radians(pitch)).Within(1e-4f));
            Assert.That(math.rotate(attitude, new float3(0f, 0f, 1f)).y * pitch, Is.GreaterThanOrEqualTo(0f),
                "the nose goes up where the pitch is positive");
            Assert.That((flight.metresPerUnit, flight.angularVelocity), Is.EqualTo((0.5f, float3.zero)));
            Assert.That(motion.SpeedOf(4f), Is.EqualTo(4f * math.sqrt(0.3125f)).Within(1e-5f));
        }

        [Test]
        public void ARoll_BeatsOneSideHarder_ByWhatTheOtherLoses()
        {
            var motion = new BakeMotion("own")
            {
                Roll = 0.2f,
                Steering = new InsectSteering { frequencyScale = 2f, amplitudeScale = 0.5f, meanFlap = 10f },
            };
            var plain = new WingParameters { amplitudeScale = 1.5f, maxFrequency = 12f };
            WingParameters left = plain, right = plain;
            motion.Apply(WingSide.Left, ref left);
            motion.Apply(WingSide.Right, ref right);

            Assert.That((left.amplitudeScale - right.amplitudeScale) / (left.amplitudeScale + right.amplitudeScale),
                Is.EqualTo(0.2f).Within(1e-6f));
            Assert.That(0.5f * (left.amplitudeScale + right.amplitudeScale), Is.EqualTo(0.75f).Within(1e-6f));
            Assert.That((left.maxFrequency, right.maxFrequency), Is.EqualTo((24f, 24f)));
            Assert.That(left.meanFlap, Is.EqualTo(math.radians(10f)).Within(1e-6f));
        }

        [TestCase(1f, -1f, 90f, 180f, -1f, null)]
        [TestCase(-1f, 1f, -90f, -180f, 1f, null)]
        [TestCase(1.001f, 0f, 0f, 0f, 0f, "not 1.001 ahead and 0 up")]
        [TestCase(0f, -1.001f, 0f, 0f, 0f, "not 0 ahead and -1.001 up")]
        [TestCase(0f, 0f, -90.5f, 0f, 0f, "the pitch must lie between -90 and 90 degrees, not -90.5")]
        [TestCase(0f, 0f, 0f, 180.5f, 0f, "the turn must lie between -180 and 180 degrees a second, not 180.5")]
        [TestCase(0f, 0f, 0f, 0f, -1.001f, "the roll must lie between -1 and 1, not -1.001")]
        [TestCase(0f, 0f, 0f, 0f, float.NaN, "the roll must lie")]
        [TestCase(0f, 0f, 0f, float.NaN, 0f, "the turn must lie")]
        public void Ranges_HoldTheirLimits_AndNothingBeyond(float speed, float climb, float pitch, float turn, float roll, string problem)
        {
            string found = new BakeMotion("own") { Speed = speed, Climb = climb, PitchDegrees = pitch, TurnDegrees = turn, Roll = roll }
                .FindProblem();

            Assert.That(found, problem == null ? Is.Null : Does.StartWith("Clip 'own': ").And.Contain(problem));
        }

        [Test]
        public void EachTurnOfThePackage_HasAMirrorImage_AndEachMotionIsFoundByItsName()
        {
            BakeMotion left = BakeMotion.Find("Turn-Left"), right = BakeMotion.Find("turn-right");

            Assert.That((left.Speed, left.Roll, left.TurnDegrees, left.IsFlown),
                Is.EqualTo((right.Speed, -right.Roll, -right.TurnDegrees, right.IsFlown)));
            Assert.That(right.TurnDegrees, Is.GreaterThan(0f), "to the right");
            Assert.That(BakeMotion.All.Select(motion => motion.FindProblem()), Is.All.Null);
            Assert.That(BakeMotion.All.Select(motion => BakeMotion.Find(motion.Name)), Is.EqualTo(BakeMotion.All));
            Assert.That(() => BakeMotion.Find("none"),
                Throws.ArgumentException.With.Message.Contains("Known: " + string.Join(", ", BakeMotion.Names)));
            Assert.That(() => new BakeMotion(" "), Throws.ArgumentException);
        }

        [Test]
        public void WingsAtRestAndInAGlide_DoNotBeat_AndOnlyThatIsHeld()
        {
            foreach (BakeMotion motion in BakeMotion.All)
            {
                bool still = motion.Name is "glide" or "rest" or "folded" or "bask";
                Assert.That(motion.Steering.amplitudeScale == 0f, Is.EqualTo(still), motion.Name);
                Assert.That(motion.IsFlown, Is.EqualTo(!still), motion.Name);
                Assert.That(motion.Climb > 0f, Is.EqualTo(motion.Name == "climb"), motion.Name);
                Assert.That(motion.Speed == 0f, Is.EqualTo(motion.Name is "hover" or "rest" or "folded" or "bask"), motion.Name);
                Assert.That(motion.Steering.fold > 0f, Is.EqualTo(motion.Name is "folded" or "bask"), motion.Name);
            }
        }
    }
}
