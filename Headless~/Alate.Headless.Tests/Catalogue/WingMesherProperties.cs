using System.Linq;
using Alate.Catalogue;
using Alate.Geometry;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingMesherProperties
    {
        private static Arbitrary<(WingOutline Outline, int Count)> Wings { get; } = Arb.From(
            from landmarks in Gen.Choose(2, 12)
            from seed in Gen.Choose(0, int.MaxValue - 1)
            from count in Gen.Frequency((3, Gen.Choose(WingMesher.MinTriangles, 400)), (1, Gen.Choose(400, 13000)))
            select (RandomOutline(landmarks, new System.Random(seed)), count));

        [Test]
        public void AnyOutline_MeshedWithAnyCount_IsExact_Upward_AndOneSheet()
        {
            Prop.ForAll(Wings, wing =>
            {
                SurfaceMesh surface = WingMesher.Strips(wing.Outline, wing.Count);
                double[] areas = Enumerable.Range(0, surface.TriangleCount).Select(t => SignedArea(surface, t)).ToArray();
                var edges = new MeshEdges(surface.triangles);

                Assert.That(surface.TriangleCount, Is.EqualTo(wing.Count));
                Assert.That(areas.Min(), Is.GreaterThan(0));
                Assert.That(Enumerable.Range(0, edges.Count).Max(edge => edges.Uses(edge)), Is.LessThanOrEqualTo(2));
                Assert.That(surface.VertexCount - edges.Count + surface.TriangleCount, Is.EqualTo(1));
            }).Check(FixedRuns.Of());
        }

        [Test]
        public void TheTriangles_AddUpToTheAreaUnderTheirOwnStations()
        {
            Prop.ForAll(Wings, wing =>
            {
                SurfaceMesh surface = WingMesher.Strips(wing.Outline, wing.Count);
                double[] spans = surface.positions.Select(p => (double)p.x).Distinct().OrderBy(x => x).ToArray();
                double expected = spans.Zip(spans.Skip(1), (from, to) =>
                    0.5 * (to - from) * (wing.Outline.ChordAt(from) + wing.Outline.ChordAt(to))).Sum();

                double area = Enumerable.Range(0, surface.TriangleCount).Sum(t => SignedArea(surface, t));
                Assert.That(area, Is.EqualTo(expected).Within(0.02).Percent);
            }).Check(FixedRuns.Of());
        }

        [Test]
        public void TheMonarch_IsMeshedExactly_WithEveryCount([NUnit.Framework.Range(50, 3000, 59)] int count)
        {
            WingDefinition wing = InsectCatalogue.Find("monarch").Wings[0];

            Assert.That(WingMesher.Strips(wing.Contour, count).TriangleCount, Is.EqualTo(count));
            Assert.That(WingMesher.Strips(wing.Outline, count).TriangleCount, Is.EqualTo(count));
        }

        private static WingOutline RandomOutline(int landmarks, System.Random random)
        {
            double[] span = new double[landmarks];
            double[] leading = new double[landmarks];
            double[] trailing = new double[landmarks];
            for (int i = 0; i < landmarks; i++)
            {
                span[i] = i == 0 ? 0 : span[i - 1] + 1 + 9 * random.NextDouble();
                leading[i] = 6 * random.NextDouble();
                trailing[i] = leading[i] - 0.5 - 25 * random.NextDouble();
            }

            var outline = WingOutline.FromMillimetres(span, leading, trailing);
            return random.Next(2) == 0 ? outline : outline.Smoothed();
        }

        private static double SignedArea(SurfaceMesh surface, int triangle)
        {
            (Vector3 a, Vector3 b, Vector3 c) = (Corner(0), Corner(1), Corner(2));
            return 0.5 * (((double)b.z - a.z) * ((double)c.x - a.x) - ((double)b.x - a.x) * ((double)c.z - a.z));

            Vector3 Corner(int corner) => surface.positions[surface.triangles[3 * triangle + corner]];
        }
    }
}
