using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Air of a table's wakes at the wings of a body: when it acts, and how much of it.</summary>
    public sealed unsafe class BodyWakeLaws
    {
        private static readonly WingInflow s_Air = new WingInflow
        {
            mean = new float3(0.1f, -2f, 0.3f),
            cosine1 = new float3(0.4f, 0.5f, 0.6f),
            sine1 = new float3(-0.4f, 0.7f, 0.2f),
            cosine2 = new float3(0.1f, 0.2f, 0.3f),
            sine2 = new float3(0.3f, 0.1f, -0.2f),
        };

        [Test]
        public void APoint_KeepsTheAirOfEachPair_AndHasNoneBeyond()
        {
            float[] point = new float[TrimPoint.Floats];
            for (int pair = 0; pair < TrimPoint.Pairs; pair++)
                BodyWake.Write(point, pair, s_Air * (pair + 1f));
            for (int pair = 0; pair < TrimPoint.Pairs; pair++)
                Assert.That(BodyWake.Read(point, pair), Is.EqualTo(s_Air * (pair + 1f)));
            Assert.That(BodyWake.Read(point, TrimPoint.Pairs).IsSet, Is.False);
            Assert.That(BodyWake.Read(point, -1).IsSet, Is.False);
            Assert.That(point[TrimPoint.Inflow - 1], Is.EqualTo(0f), "gains are left alone");
        }

        [TestCase(1f, 1f, 1f)]
        [TestCase(1.2f, 1f, 1.2f)]
        [TestCase(1f, 0.5f, 0.5f)]
        [TestCase(1f, 0f, 0f)]
        [TestCase(3f, 1f, 2f)]
        public void AShare_IsTheSpeedOfTheWingsOverTheTrims(float frequency, float amplitude, float expected)
        {
            float* point = stackalloc float[TrimPoint.Floats];
            point[TrimPoint.Drive] = 11f;
            point[TrimPoint.Drive + 1] = 0.9f;
            var drive = new WingDrive { frequency = 11f * frequency, amplitude = 0.9f * amplitude };
            Assert.That(BodyWake.Share(point, drive), Is.EqualTo(expected).Within(1e-5f));
            point[TrimPoint.Drive + 1] = 0f;
            Assert.That(BodyWake.Share(point, drive), Is.EqualTo(0f), "a trim that does not beat has no wake");
        }

        // The same force on a body as that of a preset's inflow, by which the replay has its laws.
        [Test]
        public void AHeldBody_MeetsTheAirOfItsPoint()
        {
            float3 still = Force(default, default), ofTable = Force(s_Air, default), ofPreset = Force(default, s_Air);
            Assert.That(math.distance(ofTable, ofPreset), Is.LessThan(1e-4f * math.length(ofPreset)));
            Assert.That(math.distance(still, ofTable), Is.GreaterThan(0.01f * math.length(still)));
        }

        [Test]
        public void BothWings_MeetTheSeriesOfTheirPhase_InFlightToo([Values] bool flies)
        {
            using var body = new CarriedBody(flies ? BodyMode.Free : BodyMode.Held, PointWith(s_Air));
            Step(body, 200);
            foreach (WingHandle wing in new[] { body.right, body.left })
            {
                WingReading reading = body.world.Read(wing);
                Assert.That(math.distance(reading.WakeVelocity, s_Air.At(reading.Phase)), Is.LessThan(1e-3f));
            }
        }

        [Test]
        public void ABodyThatFollowsItsReference_MeetsItToo_OnceItsWingsAreComputedAgain()
        {
            using var body = new CarriedBody(BodyMode.Free, PointWith(s_Air));
            body.world.SetDetail(body.right, WingDetail.WavesOnly);
            body.world.SetDetail(body.left, WingDetail.WavesOnly);
            Step(body, 50);
            body.world.SetDetail(body.right, WingDetail.Full);
            body.world.SetDetail(body.left, WingDetail.Full);
            Step(body, 200);
            WingReading reading = body.world.Read(body.right);
            Assert.That(math.distance(reading.WakeVelocity, s_Air.At(reading.Phase)), Is.LessThan(1e-3f));
        }

        [Test]
        public void ARestingBody_MeetsNone()
        {
            using CarriedBody still = new CarriedBody(BodyMode.Held, PointWith(default)),
                blown = new CarriedBody(BodyMode.Held, PointWith(s_Air));
            foreach (CarriedBody body in new[] { still, blown })
            {
                Step(body, 100);
                body.Body.mode = BodyMode.Resting;
                Step(body, 400);
            }

            float3 atRest = still.world.Read(still.right).AirForce, after = blown.world.Read(blown.right).AirForce;
            Assert.That(math.length(atRest), Is.GreaterThan(0f));
            Assert.That(math.distance(atRest, after), Is.LessThan(1e-3f * math.length(atRest)));
        }

        [Test]
        public void WingsWhoseBodyIsTakenOut_MeetTheInflowOfTheirParameters([Values] bool isSet)
        {
            using var body = new CarriedBody(BodyMode.Held, PointWith(s_Air));
            WingParameters parameters = Monarch.Parameters;
            parameters.inflow = isSet ? s_Air * 0.5f : default;
            body.world.SetParameters(body.right, parameters);
            body.world.SetParameters(body.left, parameters);
            Step(body, 100);
            body.world.RemoveBody(body.Handle);
            Step(body, 400);
            foreach (WingHandle wing in new[] { body.right, body.left })
            {
                WingReading reading = body.world.Read(wing);
                Assert.That(math.distance(reading.WakeVelocity, parameters.inflow.At(reading.Phase)), Is.LessThan(1e-3f));
            }
        }

        private static float3 Force(in WingInflow ofTable, in WingInflow ofPreset)
        {
            using var body = new CarriedBody(BodyMode.Held, PointWith(ofTable));
            WingParameters parameters = Monarch.Parameters;
            parameters.inflow = ofPreset;
            body.world.SetParameters(body.right, parameters);
            body.world.SetParameters(body.left, parameters);
            Step(body, 400);
            float3 force = default;
            for (int k = 0; k < 20; k++)
            {
                Step(body, 1);
                force += body.Body.force;
            }

            return force;
        }

        private static void Step(CarriedBody body, int count)
        {
            for (int k = 0; k < count; k++)
                body.world.Step(0.004f);
        }

        private static float[] PointWith(in WingInflow air)
        {
            float[] point = CarriedBody.Point();
            BodyWake.Write(point, 0, air);
            return point;
        }
    }
}
