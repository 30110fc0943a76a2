using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Numbers of a monarch's wing in flight, against the reference implementation's, their trends, and laws.</summary>
    public sealed class MonarchNumbersTests
    {
        private const double k_Reference = 0.2;

        [Test]
        public void LevelFlight_MeasuresWhatTheReferenceMeasures()
        {
            WingDeformation m = FlownBeat.Measure(Monarch.FirstOrder);
            Assert.That(math.degrees(m.TwistRange), Is.EqualTo(24).Within(24 * k_Reference), "twist");
            Assert.That(100f * m.CamberMin, Is.EqualTo(-5.0).Within(5.0 * k_Reference), "least camber");
            Assert.That(100f * m.CamberMax, Is.EqualTo(3.2).Within(3.2 * k_Reference), "largest camber");
            Assert.That(math.degrees(m.TipBendRange), Is.EqualTo(15).Within(15 * k_Reference), "tip bend");
            Assert.That(math.degrees(m.TipBendMax), Is.EqualTo(8).Within(8 * k_Reference), "largest tip bend");
            Assert.That(math.degrees(m.Lag), Is.EqualTo(27).Within(27 * k_Reference), "lag");
            Assert.That(100f * m.Stretch99, Is.EqualTo(1.4).Within(1.4 * k_Reference), "stretch of 99 of 100 edges");
            Assert.That(100f * m.StretchMax, Is.LessThan(6), "largest stretch");
        }

        [TestCase(0f, 12)]
        [TestCase(0.1f, 21)]
        [TestCase(0.15f, 25)]
        [TestCase(0.22f, 30)]
        public void Twist_GrowsWithTheDelay_AsTheReferences(float chordDelay, double twist)
        {
            WingParameters parameters = Monarch.FirstOrder;
            parameters.chordDelay = chordDelay;
            Assert.That(math.degrees(FlownBeat.Measure(parameters).TwistRange), Is.EqualTo(twist).Within(twist * k_Reference));
        }

        [Test]
        public void Twist_KeepsGrowing_UpToTheDelayOfThePrint()
        {
            double last = 0.0;
            foreach (float chordDelay in new[] { 0f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1f })
            {
                WingParameters parameters = Monarch.FirstOrder;
                parameters.chordDelay = chordDelay;
                double twist = math.degrees(FlownBeat.Measure(parameters).TwistRange);
                Assert.That(twist, Is.GreaterThan(last), $"delay {chordDelay}");
                last = twist;
            }

            Assert.That(last, Is.GreaterThan(80));
        }

        [TestCase(0.1f, 23)]
        [TestCase(0.25f, 16)]
        [TestCase(1f, 8)]
        [TestCase(4f, 6)]
        public void TipBend_FallsWithTheElasticity_AsTheReferences(float factor, double bend)
        {
            WingParameters parameters = Monarch.FirstOrder;
            parameters.elasticity *= factor;
            Assert.That(math.degrees(FlownBeat.Measure(parameters).TipBendMax), Is.EqualTo(bend).Within(bend * k_Reference));
        }

        [Test]
        public void HalvingTheSubsteps_ChangesPeakTwistByLessThanFivePerCent()
        {
            WingParameters fine = Monarch.FirstOrder;
            fine.substepsPerBeat = 48;
            double coarse = math.degrees(FlownBeat.Measure(Monarch.FirstOrder).TwistRange);
            Assert.That(math.degrees(FlownBeat.Measure(fine).TwistRange), Is.EqualTo(coarse).Within(0.05 * coarse));
        }

        [Test]
        public void Helium_ChangesPeakBendingByLessThanAQuarter()
        {
            WingParameters helium = Monarch.FirstOrder;
            helium.airDensity *= 0.15f;
            double air = math.degrees(FlownBeat.Measure(Monarch.FirstOrder).TipBendMax);
            Assert.That(math.degrees(FlownBeat.Measure(helium).TipBendMax), Is.EqualTo(air).Within(0.25 * air));
        }

        [TestCase(0f, 0.0)]
        [TestCase(18.6f, 0.75)]
        [TestCase(30f, 1.12)]
        public void MeanLift_OverWeight_RisesWithThePitchOfTheBody(float pitchDegrees, double expected)
        {
            const float wingMass = 25.1e-6f, insectMass = 0.428e-3f;
            float pitch = math.radians(pitchDegrees);
            using (var flown = new FlownMonarch(1.3f, pitch))
            {
                float dt = flown.Substep;
                float3 force = float3.zero;
                for (int k = 0; k < 8 * 24; k++)
                {
                    flown.world.Step(dt);
                    if (k >= 7 * 24)
                        force += flown.Reading.AirForce / 24f;
                }

                float3 world = math.rotate(quaternion.RotateX(-pitch), force) * (wingMass * Monarch.Length);
                double lift = 2.0 * world.y / (insectMass * 9.81);
                Assert.That(lift, Is.EqualTo(expected).Within(0.06));
            }
        }

        [Test]
        public void StillWing_DroopsUnderGravity_AndMoreUnderMore()
        {
            float none = TipHeight(0f), earth = TipHeight(1f), more = TipHeight(3f);
            Assert.That(none, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(earth, Is.LessThan(-1e-4f));
            Assert.That(more, Is.LessThan(2f * earth));
        }

        private static float TipHeight(float gravityShare)
        {
            WingParameters still = Monarch.FirstOrder;
            still.amplitude = float3.zero;
            still.meanFlap = 0f;
            WingRig rig = Monarch.Rig();
            using (var world = new WingWorld())
            {
                var air = new WingSurroundings { gravity = new float3(0f, -gravityShare * 9.81f / Monarch.Length, 0f) };
                WingHandle wing = world.Add(rig, still, air);
                rig.Release();
                for (int k = 0; k < 60; k++)
                    world.Step(0.02f);
                return world.Read(wing).JointPosition(1, 4).y;
            }
        }
    }
}
