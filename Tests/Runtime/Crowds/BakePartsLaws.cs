using Alate.Catalogue;
using Alate.Crowds;
using Alate.Flight;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Small parts of bakes: means of beats, and nearest places on triangles.</summary>
    public sealed class BakePartsLaws
    {
        [Test]
        public void TheMeanOfDrives_IsThatOfEachOfTheirNumbers()
        {
            WingDrive a = Drive(10f, 0.9f, 0.1f, -0.2f, 0.3f, -0.4f), b = Drive(14f, 0.5f, -0.3f, 0.6f, 0.5f, 1f);
            Assert.That(Numbers(SteadyFlight.Scaled(SteadyFlight.Sum(a, b), 0.5f)),
                Is.EqualTo(new[] { 12f, 0.7f, -0.1f, 0.2f, 0.4f, 0.3f }).Within(1e-6f));
            Assert.That(Numbers(SteadyFlight.Sum(a, default)), Is.EqualTo(Numbers(a)));
            Assert.That(Numbers(SteadyFlight.Sum(default, b)), Is.EqualTo(Numbers(b)));
            Assert.That(Numbers(SteadyFlight.Scaled(b, 2f)), Is.EqualTo(Numbers(SteadyFlight.Sum(b, b))));
        }

        // A fish turns slower than the motion says: the clip has the turn that it swims, with a course that is never far ahead.
        [TestCase(-60f)]
        [TestCase(60f)]
        public void ATurnThatIsTooFastForIt_IsTheOneThatItFlies(float degrees)
        {
            InsectDefinition fish = InsectCatalogue.Find("snailfish");
            using (FlightModel model = CatalogueFlight.CreateModel(fish))
            using (TrimTable table = CatalogueFlight.CreateTable(fish, model))
            using (var flight = new FreeFlight(model, table, new FlightCondition(0.5f * table.TopSpeed, 0f)))
            {
                var motion = new BakeMotion("turn") { Speed = 0.5f, TurnDegrees = degrees, IsFlown = true };
                var steady = SteadyFlight.Fly(model, table, motion);
                float3 told = math.rotate(steady.Attitude, steady.FlightOf(1f, 1f).angularVelocity);

                float dt = 0.02f, turned = 0f;
                while (flight.Time < 17.0)
                {
                    float before = flight.Reference.Heading, course = before + math.sign(degrees);
                    flight.Step(FlightCommand.Fly(0.5f * table.TopSpeed * new float3(math.sin(course), 0f, math.cos(course)), course), dt);
                    if (flight.Time > 10.0)
                        turned += Headings.Wrap(flight.Reference.Heading - before);
                }

                Assert.That(told.y * math.sign(degrees), Is.InRange(math.radians(4f), math.radians(40f)), "slower than it was told");
                Assert.That(told.y, Is.EqualTo(turned / 7f).Within(0.1f * math.abs(told.y)));
                Assert.That(math.length(told.xz), Is.LessThan(1e-3f));
            }
        }

        [Test]
        public void ThePlaceThatItsSharesTell_IsAsNearAsTheTriangle()
        {
            var random = new Random(11u);
            int inside = 0, onEdges = 0, onCorners = 0;
            for (int k = 0; k < 2000; k++)
            {
                float3 a = random.NextFloat3(-1f, 1f), b = random.NextFloat3(-1f, 1f), c = random.NextFloat3(-1f, 1f);
                float3 point = random.NextFloat3(-1.5f, 1.5f), shares = ReducedSurface.NearestShares(point, a, b, c);
                Assert.That(math.csum(shares), Is.EqualTo(1f).Within(1e-4f));
                Assert.That(math.cmin(shares), Is.GreaterThanOrEqualTo(0f), "it is on the triangle");
                float square = TriangleDistance.Square(point, a, b, c);
                Assert.That(math.distancesq(point, shares.x * a + shares.y * b + shares.z * c),
                    Is.EqualTo(square).Within(1e-4f + 1e-3f * square), $"{k}: {shares}");
                int zeros = math.csum(math.select(int3.zero, new int3(1), shares == 0f));
                inside += zeros == 0 ? 1 : 0;
                onEdges += zeros == 1 ? 1 : 0;
                onCorners += zeros == 2 ? 1 : 0;
            }

            Assert.That(new[] { inside, onEdges, onCorners }, Is.All.GreaterThan(100));
        }

        // A needle has no face and a point no edge: what is left of them counts.
        [Test]
        public void OfTrianglesWithoutArea_TheirEdgesCount()
        {
            float3 a = new float3(1f, 0f, 0f), b = new float3(3f, 0f, 0f), c = new float3(2f, 0f, 0f);
            foreach (float x in new[] { 0f, 1.4f, 2.7f, 5f })
            {
                float3 shares = ReducedSurface.NearestShares(new float3(x, 1f, 0f), a, b, c);
                Assert.That((shares.x * a + shares.y * b + shares.z * c).x, Is.EqualTo(math.clamp(x, 1f, 3f)).Within(1e-5f));
            }

            float3 alone = ReducedSurface.NearestShares(float3.zero, a, a, a);
            Assert.That(math.csum(alone), Is.EqualTo(1f));
        }

        private static WingDrive Drive(float frequency, float amplitude, float flap, float sweep, float feather, float tilt) =>
            new WingDrive
            {
                frequency = frequency,
                amplitude = amplitude,
                meanFlap = flap,
                meanSweep = sweep,
                meanFeather = feather,
                tilt = tilt,
            };

        private static float[] Numbers(WingDrive drive) =>
            new[] { drive.frequency, drive.amplitude, drive.meanFlap, drive.meanSweep, drive.meanFeather, drive.tilt };
    }
}
