using System;
using System.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Velocities of the air around wings and their wakes, against Stokes's theorem and the laws of incompressible flow.</summary>
    public sealed class VelocityLaws
    {
        private const float k_Span = 3f;

        private FreeWake m_Wake;

        [OneTimeSetUp]
        public void Shed()
        {
            var settings = new WakeSettings(WakeMethod.Panels)
            {
                SpanPanels = 6,
                Stream = new float3(0f, 0f, -6f),
                Keep = 4f,
                NearCore = 1e-3f,
                FarCore = 1e-3f,
                BoundCore = 1e-3f,
            };
            m_Wake = new FreeWake(settings, new[] { new WakeWing(ThinWing.Steady(k_Span, 0.1)) });
            Assert.That(() => Velocity(default), Throws.InvalidOperationException, "before the first step");
            for (int k = 0; k < 40; k++)
                m_Wake.Step();
        }

        [OneTimeTearDown]
        public void Free() => m_Wake.Dispose();

        // Between two points of the rows the loop passes through the rings there: it goes once around what they shed to one side.
        [TestCase(1)]
        [TestCase(3)]
        [TestCase(5)]
        public void AroundTrailingVortices_TheVelocityAddsUpToTheirCirculation(int ring)
        {
            WakeSheet sheet = m_Wake.Sheet(0);
            const int k_Row = 12, k_Parts = 2000;
            float3 middle = 0.25f * (sheet.Point(k_Row, ring) + sheet.Point(k_Row, ring + 1)
                + sheet.Point(k_Row + 1, ring) + sheet.Point(k_Row + 1, ring + 1));
            float3 centre = new(1.5f * k_Span, middle.y, middle.z);
            float radius = centre.x - middle.x;
            float3[] loop = [.. Enumerable.Range(0, k_Parts).Select(k => centre + radius * new float3(
                (float)-Math.Cos(2.0 * Math.PI * k / k_Parts), (float)Math.Sin(2.0 * Math.PI * k / k_Parts), 0f))];
            var velocities = new float3[k_Parts];
            m_Wake.Velocities(loop, velocities);
            double sum = 0.0;
            for (int k = 0; k < k_Parts; k++)
                sum += math.dot(0.5f * (velocities[k] + velocities[(k + 1) % k_Parts]), loop[(k + 1) % k_Parts] - loop[k]);

            Assert.That(Math.Abs(sum), Is.EqualTo(math.abs(sheet.Circulation(k_Row, ring))).Within(2).Percent);
        }

        [Test]
        public void AwayFromVortices_TheAirIsNeitherCompressedNorTurned()
        {
            var random = new Unity.Mathematics.Random(5);
            for (int k = 0; k < 50; k++)
            {
                float3 at = random.NextFloat3(new float3(-3f, 1f, -4f), new float3(3f, 3f, 1f));
                const float k_Step = 0.02f;
                float3 x = Slope(at, new float3(k_Step, 0f, 0f)), y = Slope(at, new float3(0f, k_Step, 0f)),
                    z = Slope(at, new float3(0f, 0f, k_Step));
                float size = math.length(x) + math.length(y) + math.length(z);
                Assert.That(math.abs(x.x + y.y + z.z), Is.LessThan(0.01f * size), "divergence");
                Assert.That(
                    math.length(new float3(y.z - z.y, z.x - x.z, x.y - y.x)), Is.LessThan(0.01f * size), "rotation");
            }
        }

        [Test]
        public void ALiftingWing_DrawsTheAirBehindItDown_AndTheAirBesideItUp()
        {
            Assert.That(Velocity(new float3(0f, 0f, -4f)).y, Is.LessThan(-0.05f));
            Assert.That(Velocity(new float3(0.5f * k_Span + 0.5f, 0f, -4f)).y, Is.GreaterThan(0.02f));
            Assert.That(math.length(Velocity(new float3(0f, 60f, 0f))), Is.LessThan(1e-3f), "far away");
        }

        [Test]
        public void AnyNumberOfPlaces_IsTaken_AndTheWakeGoesOnAsBefore()
        {
            float3[] many = [.. Enumerable.Range(0, 5000).Select(k => new float3(0.001f * k, 0.4f, -2f))], found = new float3[many.Length];
            m_Wake.Velocities(many, found);
            foreach (int k in new[] { 0, 7, 8, 1234, 4999 })
                Assert.That(math.distance(found[k], Velocity(many[k])), Is.LessThan(1e-6f), $"{k}");
            Assert.That(() => m_Wake.Velocities(many, new float3[4999]), Throws.ArgumentException.With.Message.Contains("5000 points"));

            using var asked = new FreeWake(Small(), new[] { new WakeWing(ThinWing.Steady(k_Span, 0.1)) });
            using var quiet = new FreeWake(Small(), new[] { new WakeWing(ThinWing.Steady(k_Span, 0.1)) });
            for (int k = 0; k < 10; k++)
            {
                asked.Step();
                asked.Velocities(many, found);
                quiet.Step();
            }

            Assert.That(asked.Sheet(0).Point(9, 2), Is.EqualTo(quiet.Sheet(0).Point(9, 2)));
            Assert.That(asked.Loads(0).Force, Is.EqualTo(quiet.Loads(0).Force));
        }

        private static WakeSettings Small() => new() { SpanPanels = 4, Stream = new float3(0f, 0f, -6f), Symmetric = true };

        private float3 Velocity(float3 at)
        {
            var found = new float3[1];
            m_Wake.Velocities([at], found);
            return found[0];
        }

        private float3 Slope(float3 at, float3 step) => (Velocity(at + step) - Velocity(at - step)) / (2f * math.length(step));
    }
}
