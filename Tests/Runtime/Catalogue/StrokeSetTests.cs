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

        [Test]
        public void NoStrokes_AreInfinitelyFar()
        {
            Assert.That(new StrokeSet().Distance(0, 0, out _), Is.EqualTo(double.MaxValue));
        }
    }
}
