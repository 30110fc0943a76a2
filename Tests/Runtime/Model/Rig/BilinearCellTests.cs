using System;
using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class BilinearCellTests
    {
        private static readonly BilinearCell s_Checked = Cell(0, 0, 0.3, 0.05, 0, -0.2, 0.25, -0.3);

        // Chains: parallel; from one root; meeting at the tip; spreading; one bone far longer; joints out of line.
        private static readonly BilinearCell[] s_Cells =
        {
            s_Checked,
            Cell(0, 0, 1, 0, 0, -1, 1, -1),
            Cell(0, 0, 1, 0, 0, 0, 0.8, -0.6),
            Cell(0, 0, 1, 0, 0, -0.5, 1, -1e-4),
            Cell(0.2, 0.3, 0.9, 0.8, 0.1, -0.2, 0.3, -0.9),
            Cell(0, 0, 5, 0.1, 0, -0.1, 0.2, -0.3),
            Cell(0, 0, 1, 0.2, -0.3, -0.2, 0.7, -1),
        };

        [Test]
        public void Coordinate_IsTheRootOfItsQuadratic()
        {
            // x: v (0.3 - 0.05 u) = 0.12; z: 0.05 v (1 - u) - u (0.2 + 0.1 v) = -0.1; without v: 0.01 u² - 0.083 u + 0.036 = 0.
            double expected = (0.083 - Math.Sqrt(0.083 * 0.083 - 4.0 * 0.01 * 0.036)) / (2.0 * 0.01);
            Assert.That(s_Checked.TryInvert(new PlanPoint(0.12, -0.1), out double u, out _), Is.True);
            Assert.That(u, Is.EqualTo(expected).Within(1e-6));
        }

        // Of a cell along the axes it is the distance itself: nothing within, straight beside, and of corners that of the corner.
        [Test]
        public void TheLeastDistance_IsThatOfTheRectangleAroundTheCell()
        {
            BilinearCell cell = Cell(0, 0, 2, 0, 0, -1, 2, -1);
            foreach ((double x, double z, double distance) in new[]
            {
                (1.0, -0.5, 0.0), (2.0, -1.0, 0.0), (-3.0, -0.5, 3.0), (5.0, -0.5, 3.0), (1.0, 4.0, 4.0), (1.0, -5.0, 4.0), (5.0, 4.0, 5.0),
                (-3.0, -5.0, 5.0),
            })
            {
                Assert.That(Math.Sqrt(cell.LeastDistanceSquared(new PlanPoint(x, z))), Is.EqualTo(distance).Within(1e-12), $"{x}, {z}");
            }

            foreach (BilinearCell other in s_Cells)
            {
                for (int k = 0; k < 60; k++)
                {
                    var place = new PlanPoint(3.0 * Math.Sin(1.7 * k), 3.0 * Math.Cos(2.9 * k));
                    Assert.That(other.LeastDistanceSquared(place), Is.LessThanOrEqualTo(other.Locate(place, out _, out _) + 1e-12));
                }
            }
        }

        [TestCaseSource(nameof(s_Cells))]
        public void EveryPointWithin_IsFoundAgain(object boxed)
        {
            var cell = (BilinearCell)boxed;
            for (int a = 0; a <= 20; a++)
            {
                for (int b = 1; b <= 20; b++)
                {
                    double u = a / 20.0, v = b / 20.0;
                    Assert.That(cell.Locate(cell.At(u, v), out double foundU, out double foundV), Is.EqualTo(0.0).Within(1e-20));
                    Assert.That(foundU, Is.EqualTo(u).Within(1e-6));
                    Assert.That(foundV, Is.EqualTo(v).Within(1e-6));
                }
            }
        }

        [TestCaseSource(nameof(s_Cells))]
        public void APointOutside_IsGivenTheClosestPointOfTheCell(object boxed)
        {
            var cell = (BilinearCell)boxed;
            var random = new Random(3);
            for (int round = 0; round < 200; round++)
            {
                var p = new PlanPoint(4.0 * random.NextDouble() - 1.5, 4.0 * random.NextDouble() - 2.5);
                double distance = cell.Locate(p, out double u, out double v);

                Assert.That(u, Is.InRange(0.0, 1.0));
                Assert.That(v, Is.InRange(0.0, 1.0));
                Assert.That((cell.At(u, v) - p).LengthSquared, Is.EqualTo(distance).Within(1e-12));
                Assert.That(distance, Is.GreaterThanOrEqualTo(cell.LeastDistanceSquared(p) - 1e-12));
                for (int k = 0; k < 50; k++)
                {
                    double other = (cell.At(random.NextDouble(), random.NextDouble()) - p).LengthSquared;
                    Assert.That(other, Is.GreaterThanOrEqualTo(distance - 1e-12));
                }
            }
        }

        [Test]
        public void ACellWithoutArea_StillAnswers()
        {
            BilinearCell line = Cell(0, 0, 1, 0, 0, 0, 1, 0), point = Cell(0, 0, 0, 0, 0, 0, 0, 0);

            Assert.That(line.Locate(new PlanPoint(0.5, 2.0), out _, out double v), Is.EqualTo(4.0).Within(1e-12));
            Assert.That(v, Is.EqualTo(0.5).Within(1e-12));
            Assert.That(point.Locate(new PlanPoint(3.0, 4.0), out double u, out v), Is.EqualTo(25.0).Within(1e-12));
            Assert.That(u, Is.InRange(0.0, 1.0));
            Assert.That(v, Is.InRange(0.0, 1.0));
        }

        private static BilinearCell Cell(double x00, double z00, double x01, double z01, double x10, double z10, double x11, double z11) =>
            new BilinearCell(new PlanPoint(x00, z00), new PlanPoint(x01, z01), new PlanPoint(x10, z10), new PlanPoint(x11, z11));
    }
}
