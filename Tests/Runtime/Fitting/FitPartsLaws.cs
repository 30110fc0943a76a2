using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of the parts of a fit: views, soft maxima, ends, sides, and the open edges of meshes.</summary>
    public sealed class FitPartsLaws
    {
        [TestCase(0.3)]
        [TestCase(0.62)]
        public void TheSoftMaximum_OfAParabola_IsItsTop_AndItsSpreadThatOfTheBellCurve(double top)
        {
            const double bend = 8.0, sharpness = 100.0;
            double found = SoftMaximum.Find(-1.0, 2.0, 3000, sharpness, x => 5.0 - bend * (x - top) * (x - top), out double spread);

            // exp(-800 x²) is cut where it has fallen to exp(-5): 0.9915 of the standard deviation of the whole curve is left.
            Assert.That(found, Is.EqualTo(top).Within(1e-3));
            Assert.That(
                spread, Is.EqualTo(0.9915 / Math.Sqrt(2.0 * bend * sharpness)).Within(1e-3 / Math.Sqrt(2.0 * bend * sharpness) * 3.0));
        }

        // Touching ends have nothing in common.
        [Test]
        public void Stretches_OverlapWhereTheyHaveAPlaceInCommon()
        {
            var random = Random.CreateFromIndex(5);
            for (int k = 0; k < 300; k++)
            {
                var ends = new int4(random.NextInt(0, 7), random.NextInt(0, 7), random.NextInt(0, 7), random.NextInt(0, 7));
                var one = new OutlineStretch(math.min(ends.x, ends.y), math.max(ends.x, ends.y));
                var other = new OutlineStretch(math.min(ends.z, ends.w), math.max(ends.z, ends.w));
                bool isShared = false;
                for (double place = 0.25; place < 6.0; place += 0.5)
                    isShared |= one.Contains(place) && other.Contains(place);
                if (one.Length > 0.0 && other.Length > 0.0)
                    Assert.That((one.Overlaps(other), other.Overlaps(one)), Is.EqualTo((isShared, isShared)), $"{ends}");
                Assert.That(one.Length, Is.EqualTo(math.abs(ends.x - ends.y)));
            }
        }

        [Test]
        public void ATopAtEitherEnd_IsFound_AndTheWeightsFallAsTheExponential()
        {
            // Two places, of which the second is one less over the sharpness: weights 1 and 1/e.
            double mean = SoftMaximum.Find(10.0, 12.0, 1, 2.0, place => place == 10.0 ? 1.0 : 0.5, out double spread);
            double share = Math.Exp(-1.0) / (1.0 + Math.Exp(-1.0));
            Assert.That(mean, Is.EqualTo(10.0 + 2.0 * share).Within(1e-9));
            Assert.That(spread, Is.EqualTo(2.0 * Math.Sqrt(share * (1.0 - share))).Within(1e-9));
            for (int side = -1; side <= 1; side += 2)
            {
                double end = SoftMaximum.Find(-1.0, 1.0, 10, 1000.0, place => side * place, out spread);
                Assert.That((end, spread), Is.EqualTo(((double)side, 0.0)).Using<(double, double)>(
                    (one, other) => Math.Abs(one.Item1 - other.Item1) + Math.Abs(one.Item2 - other.Item2) < 1e-6 ? 0 : 1));
            }
        }

        [Test]
        public void TheMargin_GoesFromTipToLastChain_AndItsSharesLeadBackToTheirPlaces()
        {
            var wing = new PolarWing { aspect = 0.6 };
            PlanPoint[] rim = Array.ConvertAll(wing.Outline(600), place => new PlanPoint(place.x, place.z));
            Array.Reverse(rim);
            var outline = new ClosedCurve(rim, 1200);
            var marks = new WingLandmarks(outline, new FitNotes());
            var margin = new WingMargin(marks);
            double length = Polyline.LengthOf(margin.Points), walked = 0.0, before = -1.0;

            Assert.That((margin.Shares[0], margin.Shares[margin.Shares.Count - 1]), Is.EqualTo((0.0, 1.0)));
            for (int k = 1; k + 1 < margin.Points.Count; k++)
            {
                walked += Math.Sqrt((margin.Points[k] - margin.Points[k - 1]).LengthSquared);
                PlanPoint from = margin.Points[0] - marks.Base, to = margin.Points[k] - marks.Base,
                    last = margin.Points[margin.Points.Count - 1] - marks.Base;
                double turned = Angle(from, to) / Angle(from, last);
                Assert.That(margin.Shares[k], Is.EqualTo(0.9 * walked / length + 0.1 * turned).Within(2e-3), "mostly by length");
            }

            for (int k = 0; k <= 40; k++)
            {
                double s = marks.Tip + (marks.Last - marks.Tip) * k / 40.0, share = margin.ShareAt(s);
                PlanPoint there = marks.Trimmed.At(s), back = margin.At(share);
                Assert.That((back - there).LengthSquared, Is.LessThan(1e-12), $"{k} of 40");
                Assert.That(share, Is.GreaterThan(before));
                before = share;
            }

            Assert.That((margin.ShareAt(marks.Tip - 0.1), margin.ShareAt(marks.Last + 0.1)), Is.EqualTo((0.0, 1.0)));
        }

        [Test]
        public void AFlatTop_CountsByItsMiddle_AndNeitherATopBeyondAValleyNorAnExcludedPlace()
        {
            double flat = SoftMaximum.Find(0.0, 10.0, 1000, 50.0, x => x > 2.0 && x < 5.0 ? 1.0 : 0.0, out double width);
            double first = SoftMaximum.Find(
                0.0, 10.0, 1000, 50.0, x => Math.Abs(x - 3.0) < 0.5 ? 1.0 : Math.Abs(x - 8.0) < 0.5 ? 0.99 : 0.0, out _);
            double open = SoftMaximum.Find(0.0, 10.0, 20000, 50.0, x => x > 6.0 ? double.NegativeInfinity : x, out _);

            Assert.That(flat, Is.EqualTo(3.5).Within(0.01));
            Assert.That(width, Is.EqualTo(3.0 / Math.Sqrt(12.0)).Within(0.01), "of an even spread");
            Assert.That(first, Is.EqualTo(3.0).Within(0.01));
            Assert.That(open, Is.EqualTo(6.0 - 1.0 / 50.0).Within(0.001), "the mean of a falling exponential");
        }

        [Test]
        public void AUnitSurface_IsOneLong_AboutTheOrigin_AndGoesBackToTheMesh()
        {
            var surface = new SurfaceMesh
            {
                positions = new[] { new Vector3(10f, 5f, -3f), new Vector3(14f, 5f, -3f), new Vector3(10f, 6f, -1f),
                    new Vector3(900f, 0f, 0f) },
                triangles = new[] { 0, 1, 2 },
            };
            var unit = new UnitSurface(surface);

            Assert.That(math.distance(unit.points[0], new float3(-0.5f, -0.125f, -0.25f)), Is.LessThan(1e-6f),
                "a vertex of no triangle has no say");
            Assert.That(math.distance(unit.points[1], new float3(0.5f, -0.125f, -0.25f)), Is.LessThan(1e-6f));
            Assert.That(math.distance(unit.points[2], new float3(-0.5f, 0.125f, 0.25f)), Is.LessThan(1e-6f));
            for (int k = 0; k < 4; k++)
                Assert.That(Vector3.Distance(unit.ToMesh(unit.points[k]), surface.positions[k]), Is.LessThan(1e-3f));
        }

        [Test]
        public void APlane_IsRightAngled_FacesItsNormal_AndTakesItsVectorsBack()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float3 normal = random.NextFloat3Direction();
                var plane = WingPlane.Facing(normal);
                var v = new PlanPoint(random.NextFloat(-2f, 2f), random.NextFloat(-2f, 2f));

                Assert.That(math.distance(plane.up, normal), Is.LessThan(1e-6f));
                Assert.That(
                    math.distance(math.cross(plane.right, plane.up), plane.ahead), Is.LessThan(1e-5f), $"seed {seed}: seen from above");
                Assert.That(math.length(plane.right), Is.EqualTo(1f).Within(1e-5f));
                PlanPoint again = plane.ToPlan(plane.Direction(v) + 3f * normal);
                Assert.That(Math.Abs(again.x - v.x) + Math.Abs(again.z - v.z), Is.LessThan(1e-5), $"seed {seed}");
            }
        }

        [Test]
        public void AView_TurnsAnOutlineClockwise_FromItsAnchor_InReaches([Values] bool mirrored)
        {
            PlanPoint[] corners = { new PlanPoint(2, 1), new PlanPoint(6, 1), new PlanPoint(6, 3), new PlanPoint(2, 3) };
            var outline = new ClosedCurve(corners, 400);
            PlanPoint anchor = new PlanPoint(2, 2), span = new PlanPoint(0.8, 0.6),
                forward = mirrored ? new PlanPoint(0.6, -0.8) : new PlanPoint(-0.6, 0.8);
            var view = new WingView(anchor, span, forward, 4.0);
            PlanPoint tip = view.ToWing(anchor + span * 4.0), lead = view.ToWing(anchor + forward * 2.0),
                again = view.FromWing(view.ToWing(new PlanPoint(3.5, -7.0)));

            Assert.That(Near((tip.x, tip.z), (1.0, 0.0)));
            Assert.That(Near((lead.x, lead.z), (0.0, 0.5)));
            Assert.That(Near((again.x, again.z), (3.5, -7.0)));
            ClosedCurve turned = view.Turn(outline, outline.Nearest(anchor));
            Assert.That(Near((turned.Samples[0].x, turned.Samples[0].z), (0.0, 0.0)));
            Assert.That(Polygon.Area(turned.Samples), Is.EqualTo(-8.0 / 16.0).Within(1e-3), "clockwise, and in reaches");
        }

        [Test]
        public void TheAcross_StandsUpright_TowardsTheOther()
        {
            PlanPoint v = new PlanPoint(3, 4), towards = WingView.Across(v, new PlanPoint(1, 0)),
                away = WingView.Across(v, new PlanPoint(-1, 0));

            Assert.That((towards.x, towards.z), Is.EqualTo((4.0, -3.0)));
            Assert.That((away.x, away.z), Is.EqualTo((-4.0, 3.0)));
        }

        [TestCase(0.18f, 1f, 1f, 1f)]
        [TestCase(-0.18f, 1f, -1f, 1f)]
        [TestCase(0.16f, 1f, 1f, 0.8f)]
        [TestCase(0.16f, 0.39f, -1f, 0.8f)]
        [TestCase(0.16f, 0.41f, -1f, 0.5f)]
        [TestCase(-0.16f, 0.59f, 1f, 0.5f)]
        [TestCase(-0.16f, 0.61f, 1f, 0.8f)]
        public void UpIsTheGivenSide_OrWhereThatDoesNotTell_TheFrontOfMostTriangles(
            float cosine, float frontShare, float side, float confidence)
        {
            // One triangle shows its front to the normal, with a share of the area, the other its back.
            float3[] points = { 0f, new float3(0f, 0f, 1f), new float3(2f * frontShare, 0f, 0f), new float3(2f - 2f * frontShare, 0f, 0f) };
            var triangles = new List<int3> { new int3(0, 1, 2), new int3(0, 3, 1) };
            var given = new Vector3(math.sqrt(1f - cosine * cosine), cosine, 0f);
            float3 chosen = UpperSide.Choose(3f * given, new float3(0f, 1f, 0f), points, triangles, out float told);

            Assert.That(chosen, Is.EqualTo(new float3(0f, side, 0f)));
            Assert.That(told, Is.EqualTo(confidence));
        }

        [TestCase(1.0, 1.0, 0.6)]
        [TestCase(0.001, 1.0, 0.98)]
        [TestCase(1.0, 0.001, 0.98)]
        [TestCase(0.7, 1.0, 0.79)]
        public void TheNarrowEnd_IsTheMoreCertain_TheMoreTheEndsDiffer(double near, double far, double confidence)
        {
            // A trapezium of length 8 whose widths, a share of 0.15 from its ends, are as near and far as said; 0.7 and 1 differ by half of
            // what makes a point.
            double slope = (far - near) / 0.7, first = Math.Max(near - 0.15 * slope, 0.0), last = Math.Max(far + 0.15 * slope, 0.0);
            PlanPoint[] corners = { new PlanPoint(1, -0.5 * first), new PlanPoint(9, -0.5 * last), new PlanPoint(9, 0.5 * last),
                new PlanPoint(1, 0.5 * first) };
            var outline = new ClosedCurve(corners, 2000);
            var end = new NarrowEnd(outline, Polygon.Centroid(corners));

            Assert.That(end.Confidence, Is.EqualTo(confidence).Within(0.004));
            PlanPoint[] large = Array.ConvertAll(corners, corner => corner * 50.0);
            Assert.That(new NarrowEnd(new ClosedCurve(large, 2000), Polygon.Centroid(large)).Confidence,
                Is.EqualTo(end.Confidence).Within(1e-6), "of any size");
            if (near != far)
                Assert.That(outline.At(end.Place).x, Is.EqualTo(near < far ? 1.0 : 9.0).Within(0.02));
        }

        [Test]
        public void Pieces_HangTogetherByCornersAndJunctions_TheLargestFirst()
        {
            float3[] points = Enumerable.Range(0, 9).Select(
                k => new float3(k % 3 == 1 ? 1f : 0f, k < 3 ? 0f : k < 6 ? 5f : 10f, k % 3 == 2 ? (k < 3 ? 1f : k < 6 ? 3f : 2f) : 0f))
                .ToArray();
            int3[] triangles = { new int3(0, 1, 2), new int3(3, 4, 5), new int3(6, 7, 8) };
            List<List<int3>> apart = SheetPieces.Of(points, triangles, new List<(int, int)>()),
                tied = SheetPieces.Of(points, triangles, new List<(int, int)> { (2, 8) });

            Assert.That(apart.Select(piece => piece[0].x), Is.EqualTo(new[] { 3, 6, 0 }));
            Assert.That(apart.Select(piece => SheetPieces.Area(points, piece)), Is.EqualTo(new[] { 1.5, 1.0, 0.5 }));
            Assert.That(tied.Select(piece => piece.Count), Is.EquivalentTo(new[] { 2, 1 }));
        }

        [TestCase(0f, true)]
        [TestCase(0.009f, true)]
        [TestCase(0.011f, false)]
        public void AVertexOnAnOpenEdge_CutsIt_WithinTheTolerance(float off, bool isCut)
        {
            // A coarse triangle above, two fine ones below, whose middle vertex lies beside the coarse edge.
            float3[] points = { new float3(0f, 0f, 0f), new float3(2f, 0f, 0f), new float3(1f, 0f, 1f), new float3(1f, off, 0f),
                new float3(1f, 0f, -1f) };
            int3[] triangles = { new int3(0, 2, 1), new int3(0, 3, 4), new int3(3, 1, 4) };
            var boundary = new SheetBoundary(points, triangles, 0.01f);

            Assert.That(boundary.edges, Has.Count.EqualTo(isCut ? 4 : 7));
            Assert.That(boundary.junctions, Is.EqualTo(isCut ? new[] { (0, 3) } : new (int, int)[0]));
        }

        // One large triangle below two small ones that share half of its side each, from either end and along each axis.
        [Test]
        public void AVertexOnALongSide_CutsIt_WhicheverWayTheSideRuns([Values(0, 1, 2)] int axis, [Values(-1f, 1f)] float way)
        {
            float3 Place(float along, float across)
            {
                float3 place = 0f;
                place[axis] = way * along;
                place[(axis + 1) % 3] = across;
                return place;
            }

            float3[] points = { Place(0f, 0f), Place(2f, 0f), Place(0.9f, -0.5f), Place(1f, 0f), Place(0.5f, 0.4f), Place(1.5f, 0.4f) };
            var boundary = new SheetBoundary(points, new[] { new int3(0, 1, 2), new int3(0, 3, 4), new int3(3, 1, 5) }, 0.01f);

            Assert.That(boundary.edges.Select(edge => (math.min(edge.A, edge.B), math.max(edge.A, edge.B))),
                Is.EquivalentTo(new[] { (0, 2), (1, 2), (0, 4), (3, 4), (3, 5), (1, 5) }), "the halves of the long side are closed");
            Assert.That(boundary.junctions.Select(junction => junction.B), Is.EqualTo(new[] { 3 }));
        }

        // The mesh is longest along X, the long side runs across: its ends are the first or the last places that are looked at.
        [Test]
        public void AVertexBesideALongSide_CutsIt_OnEitherHand([Values(-1f, 1f)] float hand, [Values(-1f, 1f)] float way)
        {
            const float tolerance = 0.01f;
            float3[] points = { new float3(-3f, 0f, 0.5f), new float3(0f, 0f, 0f), new float3(0f, 0f, 1f), new float3(1f, 0f, 0f),
                new float3(1f, 0f, 1f), new float3(0.8f * hand * tolerance, 0f, 0.4f) };
            for (int k = 0; k < points.Length; k++)
                points[k].x *= way;
            var boundary = new SheetBoundary(points, new[] { new int3(0, 1, 2), new int3(1, 3, 5), new int3(2, 5, 4) }, tolerance);

            Assert.That(boundary.junctions.Select(junction => junction.B), Is.EqualTo(new[] { 5 }));
            Assert.That(boundary.edges, Has.Count.EqualTo(6), "without both halves of the long side");
        }

        [Test]
        public void AWalk_GoesCounterclockwiseRoundTheOutside_AndNamesHoles()
        {
            PlanPoint[] plan =
            {
                new PlanPoint(0, 0), new PlanPoint(4, 0), new PlanPoint(4, 4), new PlanPoint(0, 4), new PlanPoint(1, 1),
                new PlanPoint(3, 1), new PlanPoint(2, 3),
            };
            var edges = new List<(int, int)> { (2, 1), (4, 5), (0, 3), (2, 3), (6, 5), (0, 1), (4, 6) };
            var walk = new OutlineWalk(plan, edges);

            Assert.That(walk.outline, Is.EqualTo(new[] { 0, 1, 2, 3 }));
            Assert.That(walk.holes.Select(hole => hole.OrderBy(place => place)), Is.EqualTo(new[] { new[] { 4, 5, 6 } }));
            Assert.That(new OutlineWalk(plan, new List<(int, int)>()).outline, Is.Empty);

            // Two triangles that touch in one corner: round both, through the corner twice.
            PlanPoint[] bow = { new PlanPoint(0, 0), new PlanPoint(2, 1), new PlanPoint(0, 2), new PlanPoint(4, 0), new PlanPoint(4, 2) };
            var round = new OutlineWalk(bow, new List<(int, int)> { (0, 1), (1, 2), (2, 0), (1, 3), (3, 4), (4, 1) });
            Assert.That(round.outline, Is.EqualTo(new[] { 0, 1, 3, 4, 1, 2 }));
            Assert.That(round.holes, Is.Empty);
        }

        // Lobes all around one corner: walked one after another, counterclockwise, through the corner each time.
        [TestCase(2, 0.4)]
        [TestCase(5, 0.9)]
        [TestCase(8, 0.3)]
        [TestCase(11, 0.5)]
        public void LobesAroundACorner_AreOneOutline(int lobes, double width)
        {
            var plan = new List<PlanPoint> { new PlanPoint(0, 0) };
            var edges = new List<(int, int)>();
            for (int lobe = 0; lobe < lobes; lobe++)
            {
                double from = 2.0 * Math.PI * lobe / lobes + 0.1;
                plan.Add(new PlanPoint(Math.Cos(from), Math.Sin(from)));
                plan.Add(new PlanPoint(Math.Cos(from + width), Math.Sin(from + width)));
                edges.AddRange(new[] { (0, 2 * lobe + 1), (2 * lobe + 2, 2 * lobe + 1), (2 * lobe + 2, 0) });
            }

            var walk = new OutlineWalk(plan.ToArray(), edges);
            Assert.That(walk.outline, Has.Count.EqualTo(3 * lobes));
            double area = Polygon.Area(walk.outline.ConvertAll(place => plan[place]));
            Assert.That(area, Is.EqualTo(0.5 * lobes * Math.Sin(width)).Within(1e-9));
            Assert.That(walk.holes, Is.Empty);
        }

        private static bool Near((double, double) a, (double, double) b) =>
            Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-9;

        // Clockwise.
        private static double Angle(PlanPoint from, PlanPoint to) => Math.Atan2(PlanPoint.Cross(to, from), PlanPoint.Dot(from, to));
    }
}
