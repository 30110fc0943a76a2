using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Walks along a square of side 2 and along three of its sides.</summary>
    public sealed class PolylineTests
    {
        private static readonly PlanPoint[] s_Square = { new PlanPoint(0, 0), new PlanPoint(2, 0), new PlanPoint(2, 2),
            new PlanPoint(0, 2) };

        [TestCase(false, 6.0)]
        [TestCase(true, 8.0)]
        public void Length_CountsTheLastSide_WhereTheLineIsClosed(bool isClosed, double length) =>
            Assert.That(new Polyline(s_Square, isClosed).Length, Is.EqualTo(length));

        [TestCase(0.0, 0.0, 0.0)]
        [TestCase(3.0, 2.0, 1.0)]
        [TestCase(6.0, 0.0, 2.0)]
        [TestCase(7.5, 0.0, 0.5)]
        public void At_IsThePlaceAtTheDistance_FromWhichTheDistanceIsFoundAgain(double distance, double x, double z)
        {
            var square = new Polyline(s_Square, true);

            Assert.That(square.At(distance).x, Is.EqualTo(x).Within(1e-12));
            Assert.That(square.At(distance).z, Is.EqualTo(z).Within(1e-12));
            Assert.That(square.Nearest(new PlanPoint(x, z)), Is.EqualTo(distance).Within(1e-12));
        }

        [Test]
        public void Until_EndsAtTheDistance_AndJoinGoesOnFromThere()
        {
            var line = new Polyline(s_Square);

            Polyline begun = line.Until(3.0),
                whole = Polyline.Join(begun, new Polyline(new[] { new PlanPoint(2, 1), new PlanPoint(2, 2) }));

            Assert.That(begun.Length, Is.EqualTo(3.0));
            Assert.That(begun.Points, Has.Count.EqualTo(3));
            Assert.That(whole.Length, Is.EqualTo(4.0));
            Assert.That(whole.Points, Has.Count.EqualTo(4), "the point where both meet counts once");
        }

        [TestCase(false, 7, 1.0)]
        [TestCase(true, 8, 1.0)]
        public void Even_TakesEqualSteps(bool isClosed, int count, double step)
        {
            PlanPoint[] points = Polyline.Even(s_Square, count, isClosed);

            Assert.That(points, Has.Length.EqualTo(count));
            for (int k = 0; k + 1 < count; k++)
                Assert.That((points[k + 1] - points[k]).LengthSquared, Is.EqualTo(step * step).Within(1e-12), $"step {k}");
        }

        [Test]
        public void Grid_TellsInsideAndClearance_AsThePolygonDoes()
        {
            var star = new PlanPoint[40];
            for (int k = 0; k < star.Length; k++)
            {
                star[k] = new PlanPoint(System.Math.Cos(0.05 * System.Math.PI * k), System.Math.Sin(0.05 * System.Math.PI * k))
                    * (k % 2 == 0 ? 1.0 : 0.6);
            }
            var grid = new PolygonGrid(star, 0.1);
            var random = new System.Random(3);
            for (int k = 0; k < 500; k++)
            {
                var point = new PlanPoint(2.4 * random.NextDouble() - 1.2, 2.4 * random.NextDouble() - 1.2);
                bool isInside = Polygon.Contains(star, point);

                Assert.That(grid.Contains(point), Is.EqualTo(isInside), $"point {k}");
                double clearance = isInside ? System.Math.Min(0.3, Polyline.Distance(star, point, true)) : -1.0;
                Assert.That(grid.Clearance(point, 0.3), Is.EqualTo(clearance).Within(1e-12), $"point {k}");
            }
        }
    }
}
