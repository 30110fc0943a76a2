using System;
using Alate.Catalogue;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class StrokeSetTests
    {
        [Test]
        public void TheNearestOfManyStrokes_IsFound_InsideAndOutsideOfTheirCells([Range(1, 8)] int seed)
        {
            var random = new Random(seed);
            var strokes = new Stroke[random.Next(1, 80)];
            var set = new StrokeSet();
            for (int k = 0; k < strokes.Length; k++)
            {
                double x = random.NextDouble(), z = random.NextDouble() - 0.5, length = k % 5 == 0 ? 0 : 0.2;
                double endX = x + length * (random.NextDouble() - 0.5), endZ = z + length * (random.NextDouble() - 0.5);
                strokes[k] = new Stroke(x, z, endX, endZ, k);
                set.Add(new[] { x, z, endX, endZ }, k);
            }

            for (int place = 0; place < 2000; place++)
            {
                double x = 3 * random.NextDouble() - 1, z = 3 * random.NextDouble() - 1.5;
                double nearest = double.MaxValue, along = 0;
                foreach (Stroke stroke in strokes)
                {
                    double distance = Math.Sqrt(stroke.DistanceSquared(x, z, out double here));
                    if (distance < nearest)
                    {
                        nearest = distance;
                        along = here;
                    }
                }

                Assert.That(set.Distance(x, z, out double found), Is.EqualTo(nearest));
                Assert.That(found, Is.EqualTo(along));
                double reach = 0.2 * random.NextDouble(), within = set.Distance(x, z, out found, reach);
                if (nearest < reach)
                    Assert.That((within, found), Is.EqualTo((nearest, along)));
                else
                    Assert.That(within, Is.EqualTo(nearest).Or.GreaterThan(1e9));
            }
        }

        [Test]
        public void ADistance_IsThatToTheNearestPointOfTheStroke()
        {
            var stroke = new Stroke(1, 0, 3, 0, 0.5);

            Assert.That(stroke.DistanceSquared(2, 2, out double along), Is.EqualTo(4));
            Assert.That(along, Is.EqualTo(1.5));
            Assert.That(stroke.DistanceSquared(0, 1, out along), Is.EqualTo(2).Within(1e-12));
            Assert.That(along, Is.EqualTo(0.5));
            Assert.That(stroke.DistanceSquared(6, 4, out along), Is.EqualTo(25));
            Assert.That(along, Is.EqualTo(2.5));
        }

        // Cells reach a tenth beyond the strokes, whichever way these run: there it is known that none is near.
        [TestCase(-1, 0, 1, 0.5)]
        [TestCase(1, 0, -1, 0.5)]
        [TestCase(-1, 0.5, 1, 0)]
        [TestCase(1, 0.5, -1, 0)]
        public void BesideStrokes_NoneIsWithinReach_AndFarFromThemAllAreAsked(double x, double z, double endX, double endZ)
        {
            var grid = new StrokeGrid(new[] { new Stroke(x, z, endX, endZ, 0) });
            double left = x < endX ? z : endZ, right = x < endX ? endZ : z;

            Assert.That(grid.Around(-1.15, left, 0.05), Is.Empty, "left");
            Assert.That(grid.Around(1.15, right, 0.05), Is.Empty, "right");
            Assert.That(grid.Around(0, -0.15, 0.05), Is.Empty, "below");
            Assert.That(grid.Around(0, 0.65, 0.05), Is.Empty, "above");
            Assert.That(grid.Around(-1.15, left, 0.2), Has.Length.EqualTo(1), "within reach");
            Assert.That(grid.Around(-1.3, left, 0.05), Has.Length.EqualTo(1), "beyond the cells");
            Assert.That(grid.Around(0, 0.8, 0.05), Has.Length.EqualTo(1), "above the cells");
        }

        [Test]
        public void NoStrokes_AreInfinitelyFar()
        {
            Assert.That(new StrokeSet().Distance(0, 0, out _), Is.EqualTo(double.MaxValue));
        }
    }
}
