using System;
using Alate.Geometry;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Meshes of random wings: slender to round, with tails, notches and scallops.</summary>
    public sealed class OutlineMesherProperties
    {
        private static Arbitrary<(int Seed, int Triangles)> Wings { get; } = Arb.From(
            from seed in Gen.Choose(0, int.MaxValue - 1)
            from triangles in Gen.Frequency((3, Gen.Choose(200, 1500)), (1, Gen.Choose(1500, 6000)))
            select (seed, triangles));

        [Test]
        public void AnyOutline_IsMeshedExactly_WithoutSlivers_AndWithoutOverlap() => AssertMeshed(40);

        [Test]
        [Explicit]
        [Category("Long")]
        public void AHundredOutlines_AreMeshedExactly_WithoutSlivers_AndWithoutOverlap() => AssertMeshed(100);

        private static void AssertMeshed(int cases)
        {
            Prop.ForAll(Wings, wing =>
            {
                PlanPoint[] outline = Outline(wing.Seed);
                TriangleLinks mesh = OutlineMesher.Mesh(outline, wing.Triangles, out int rim);

                Assert.That(mesh.SideCount, Is.EqualTo(3 * wing.Triangles));
                Assert.That(2 * (mesh.points.Length - rim) + rim - 2, Is.EqualTo(wing.Triangles));
                double sum = 0.0, worst = 1.0;
                for (int side = 0; side < mesh.SideCount; side += 3)
                {
                    int a = mesh.corners[side], b = mesh.corners[side + 1], c = mesh.corners[side + 2];
                    sum += 0.5 * mesh.Area(a, b, c);
                    worst = Math.Min(worst, TriangleSmoothing.Quality(mesh.points[a], mesh.points[b], mesh.points[c]));
                }

                Assert.That(worst, Is.GreaterThan(0.4), "1 is equilateral; a right-angled triangle with an angle of 15° has 0.43");
                Assert.That(sum, Is.EqualTo(Polygon.Area(mesh.points[..rim])).Within(1e-9 * sum));
            }).Check(FixedRuns.Of(cases));
        }

        private static PlanPoint[] Outline(int seed)
        {
            PlanPoint[] outline = Array.ConvertAll(
                RandomWings.Make(seed).Outline(900), corner => new PlanPoint(1000.0 * corner.x, 1000.0 * corner.z));
            if (Polygon.Area(outline) < 0.0)
                Array.Reverse(outline);
            return Polygon.Simplified(outline, 0.4);
        }
    }
}
