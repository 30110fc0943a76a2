using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Tests
{
    public sealed class InnerCurveLaws
    {
        // Of a regular polygon with its corners on a circle the curve touches the middles of the sides: it is that circle, nearly.
        [TestCase(12)]
        [TestCase(48)]
        [TestCase(200)]
        public void OfARegularPolygon_TheCurveIsTheCircleInside(int corners)
        {
            PlanPoint[] curve = InnerCurve.Of(Regular(corners));

            double inside = Math.Cos(Math.PI / corners), sagitta = 1.0 - inside;
            Assert.That(curve, Has.Length.EqualTo(corners * InnerCurve.PiecesOfACorner));
            foreach (PlanPoint point in curve)
                Assert.That(Math.Sqrt(point.LengthSquared), Is.EqualTo(inside).Within(0.05 * sagitta));
        }

        // No turn of the curve is sharper than a corner's share of it.
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        public void TheCurve_IsSmooth_AndStaysInside_WhateverThePolygon(int seed)
        {
            var random = new Random(seed);
            PlanPoint[] polygon = Enumerable.Range(0, 60).Select(k =>
            {
                double angle = 2.0 * Math.PI * k / 60, radius = 1.0 + 0.15 * Math.Sin(3.0 * angle) + 0.01 * random.NextDouble();
                return new PlanPoint(radius * Math.Cos(angle), radius * Math.Sin(angle));
            }).ToArray();
            PlanPoint[] curve = InnerCurve.Of(polygon);

            double sharpest = Turns(polygon).Max(), smoothest = Turns(curve).Max();
            Assert.That(smoothest, Is.LessThan(0.35 * sharpest));
            double outside = curve.Where(point => !Polygon.Contains(polygon, point))
                .Select(point => Polyline.Distance(polygon, point, true)).DefaultIfEmpty(0.0).Max();
            Assert.That(outside, Is.LessThan(1e-3), "it may leave the polygon by less than the polygon leaves a smooth curve");
            Assert.That(curve.Max(point => Polyline.Distance(polygon, point, true)), Is.LessThan(0.02));
        }

        // Where a polygon points inwards, the middle of the curve's piece at that corner is the corner.
        [Test]
        public void ACornerThatPointsInwards_LiesOnTheCurve()
        {
            PlanPoint[] bay = Regular(40).Select((point, k) => k == 7 ? point * 0.9 : point).ToArray();
            PlanPoint[] curve = InnerCurve.Of(bay);

            Assert.That(Polyline.Distance(curve, bay[7], true), Is.LessThan(1e-3));
            Assert.That(Polyline.Distance(curve, bay[20], true), Is.GreaterThan(2e-3), "the others are rounded off");
        }

        [Test]
        public void ARim_GoesOnceAroundAMesh_InTheSenseOfItsTriangles()
        {
            // A square of two triangles beside a triangle with another place in space, and a square with a hole.
            int[] two = { 0, 1, 2, 0, 2, 3, 4, 5, 6 };
            List<int[]> rims = MeshRim.Of(two);
            Assert.That(rims.Select(rim => rim.Length), Is.EquivalentTo(new[] { 4, 3 }));
            int[] square = rims.Single(rim => rim.Length == 4);
            for (int k = 0; k < 4; k++)
                Assert.That(square[(k + 1) % 4], Is.EqualTo((square[k] + 1) % 4));

            int[] ring = { 0, 1, 4, 1, 5, 4, 1, 2, 5, 2, 6, 5, 2, 3, 6, 3, 7, 6, 3, 0, 7, 0, 4, 7 };
            Assert.That(MeshRim.Of(ring).Select(rim => rim.OrderBy(vertex => vertex).First()), Is.EquivalentTo(new[] { 0, 4 }));
            Assert.That(MeshRim.Of(new[] { 0, 1, 2, 0, 2, 1 }), Is.Empty, "both sides of a sheet have no rim");
        }

        private static PlanPoint[] Regular(int corners) => Enumerable.Range(0, corners).Select(k =>
        {
            double angle = 2.0 * Math.PI * k / corners;
            return new PlanPoint(Math.Cos(angle), Math.Sin(angle));
        }).ToArray();

        private static IEnumerable<double> Turns(PlanPoint[] line) =>
            Enumerable.Range(0, line.Length).Select(k => Math.Acos(Math.Clamp(Polygon.TurnCosine(line, k), -1.0, 1.0)));
    }
}
