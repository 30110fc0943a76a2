using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class PatchAirTests
    {
        private static readonly float3 s_Wind = new float3(3f, -2f, -10f);
        private static readonly float3 s_Normal = math.normalize(new float3(0.1f, 1f, -0.2f));

        // A set that Evaluate does not know would be silent otherwise: the air of a value that is none is no number.
        [Test]
        public unsafe void EverySet_HasCoefficientsOfItsOwn()
        {
            var seen = new HashSet<(float, float)>();
            foreach (CoefficientSet set in (CoefficientSet[])Enum.GetValues(typeof(CoefficientSet)))
            {
                (float lift, float drag) = Of(set);
                Assert.That(math.isfinite(lift) && math.isfinite(drag), set.ToString());
                Assert.That(seen.Add((lift, drag)), $"{set} is another one");
            }

            Assert.That(Of((CoefficientSet)99), Is.EqualTo((float.NaN, float.NaN)));

            (float, float) Of(CoefficientSet set)
            {
                var stream = new PatchStream { across = 0.6f, tangential = 0.8f };
                Coefficients.Evaluate(new ModelOptions { coefficients = set }, &stream, 1);
                return (stream.lift.x, stream.drag.x);
            }
        }

        [Test]
        public void PaperLift_HasItsMaximumWhereThePolynomialHasIt()
        {
            const double a = -0.00095953, b = 0.090635, c = -0.34182, top = -b / (2.0 * a);
            Coefficients.Paper((float)(top * Math.PI / 180.0), true, out float4 lift, out _);
            const double expected = c - b * b / (4.0 * a);
            Assert.That(lift.x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        [Test]
        public void PaperLift_IsNegativeAtSmallAngles_UnlessClamped()
        {
            Coefficients.Paper(math.radians(2f), false, out float4 printed, out _);
            Coefficients.Paper(math.radians(2f), true, out float4 clamped, out _);
            Assert.That(printed.x, Is.EqualTo(PaperLift(2.0)).Within(-PaperLift(2.0) * Lanes.CheckTolerance));
            Assert.That(clamped.x, Is.Zero);
        }

        [Test]
        public void Drag_AtRightAngles_IsThatOfItsSource()
        {
            Coefficients.Paper(math.PI / 2f, true, out _, out float4 paper);
            Coefficients.Dickinson(math.PI / 2f, out _, out float4 dickinson);
            Assert.That(paper.x, Is.EqualTo(PaperDrag(90.0)).Within(PaperDrag(90.0) * Lanes.CheckTolerance));
            Assert.That(dickinson.x, Is.EqualTo(DickinsonDrag(90.0)).Within(DickinsonDrag(90.0) * Lanes.CheckTolerance));
        }

        [Test]
        public void DickinsonLift_At45Degrees()
        {
            Coefficients.Dickinson(math.PI / 4f, out float4 lift, out _);
            Assert.That(lift.x, Is.EqualTo(DickinsonLift(45.0)).Within(DickinsonLift(45.0) * Lanes.CheckTolerance));
        }

        [Test]
        public void FlatPlateDrag_At60Degrees()
        {
            Coefficients.FlatPlate(math.sin(math.PI / 3f), math.cos(math.PI / 3f), out _, out float4 drag);
            const double expected = 0.05 + 1.9 * 3.0 / 4.0;
            Assert.That(drag.x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        [Test]
        public void DickinsonSeries_FollowsSineAndCosine_OverTheWholeQuadrant()
        {
            for (int k = 0; k <= 900; k++)
            {
                double degrees = 0.1 * k;
                Coefficients.Dickinson((float)(degrees * Math.PI / 180.0), out float4 lift, out float4 drag);
                Assert.That(lift.x, Is.EqualTo(DickinsonLift(degrees)).Within(3e-6), $"lift at {degrees}°");
                Assert.That(drag.x, Is.EqualTo(DickinsonDrag(degrees)).Within(3e-6), $"drag at {degrees}°");
            }
        }

        // As digitised: mean of the stream from above and from below.
        [TestCase(0, 0.094)]
        [TestCase(10, 0.145)]
        [TestCase(20, 0.293)]
        [TestCase(45, 1.104)]
        [TestCase(70, 1.922)]
        [TestCase(90, 2.000)]
        public void ADragonflysDrag_IsTheMeasuredOne(double degrees, double drag)
        {
            double angle = degrees * Math.PI / 180.0;
            Assert.That(Coefficients.DragonflyDrag((float)Math.Sin(angle), (float)Math.Cos(angle)).x, Is.EqualTo(drag).Within(0.015));
        }

        [TestCase(CoefficientSet.Paper)]
        [TestCase(CoefficientSet.FlatPlate)]
        [TestCase(CoefficientSet.Dickinson1999)]
        [TestCase(CoefficientSet.Dragonfly)]
        public void ElementForce_IsThatOfEquation9(CoefficientSet set)
        {
            ElementInDouble expected = Element(set);
            float3 force = Load(set).force[0];
            double tolerance = Lanes.CheckTolerance * Math.Sqrt(Dot(expected.force, expected.force));
            for (int axis = 0; axis < 3; axis++)
                Assert.That(force[axis], Is.EqualTo(expected.force[axis]).Within(tolerance), $"axis {axis}");
        }

        [Test]
        public void DampingEstimate_IsThatOfItsFormula()
        {
            double expected = Element(CoefficientSet.Dickinson1999).damping;
            Assert.That(Load(CoefficientSet.Dickinson1999).damping.x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        [Test]
        public void StillAir_MakesNoForce()
        {
            PatchLoad load = PatchLoads.Of(ModelOptions.Physical, default, Lanes.All(0f, 1f, 0f), 0f, 1f);
            Assert.That(load.force[0], Is.EqualTo(float3.zero));
            Assert.That(load.damping.x, Is.Zero);
        }

        [TestCase(0f, -3f, 0f)]
        [TestCase(0f, 0f, -3f)]
        public void FlowAlongNormalOrSurface_MakesDragOnly(float x, float y, float z)
        {
            float3 force = PatchLoads.Of(ModelOptions.Physical, Lanes.All(x, y, z), Lanes.All(0f, 1f, 0f), 0f, 1f).force[0];
            var wind = new float3(x, y, z);
            Assert.That(math.dot(force, wind), Is.Positive);
            if (z == 0f)
                Assert.That(math.length(math.cross(force, wind)), Is.LessThan(1e-4f * math.length(force) * 3f));
        }

        private static PatchLoad Load(CoefficientSet set)
        {
            ModelOptions options = ModelOptions.Physical;
            options.coefficients = set;
            var span = new float3(1f, -0.1f, 0f);
            span = math.normalize(span - s_Normal * math.dot(span, s_Normal));
            float3 wind = s_Wind - span * math.dot(s_Wind, span);
            return PatchLoads.Of(options, new SoaFloat3(wind), new SoaFloat3(s_Normal), 0f, 0.5f * 11.1f * 0.02f);
        }

        // The polynomials of Fig. 6, the angle in degrees.
        private static double PaperLift(double angle) => -0.34182 + 0.090635 * angle - 0.00095953 * angle * angle;

        private static double PaperDrag(double angle) =>
            0.51127 + 0.0063148 * angle + 0.0011527 * angle * angle - 0.0000079518 * angle * angle * angle;

        // Dickinson, Lehmann and Sane (1999).
        private static double DickinsonLift(double angle) => 0.225 + 1.58 * Math.Sin((2.13 * angle - 7.20) * Math.PI / 180.0);

        private static double DickinsonDrag(double angle) => 1.92 - 1.55 * Math.Cos((2.04 * angle - 9.82) * Math.PI / 180.0);

        // Fit to Azuma and Watanabe (1988).
        private static double DragonflyDrag(double s) => 0.094 + 1.906 * s + s * (1.0 - s) * (-0.388 + 0.168 * s + 2.14 * s * s);

        // Eq. 9 and 10 for the element of Load in double precision: V without its part along the span, drag along V, lift (not below 0)
        // across it on the side of the normal that the air blows to. Damping is (1 + s²) ½ρA|V| max(0, C_L cos α + C_D s) / s, s = sin α,
        // at least 0.05.
        private static ElementInDouble Element(CoefficientSet set)
        {
            double[] normal = Unit(0.1, 1.0, -0.2), wind = { 3.0, -2.0, -10.0 };
            double[] flat = Without(new[] { 1.0, -0.1, 0.0 }, normal), span = Unit(flat[0], flat[1], flat[2]);
            wind = Without(wind, span);
            double speed = Math.Sqrt(Dot(wind, wind)), sine = Math.Abs(Dot(wind, normal)) / speed,
                angle = Math.Asin(sine) * 180.0 / Math.PI;
            (double lift, double drag) = set == CoefficientSet.Paper ? (Math.Max(0.0, PaperLift(angle)), PaperDrag(angle))
                : set == CoefficientSet.FlatPlate ? (1.8 * Math.Sin(angle * Math.PI / 90.0), 0.05 + 1.9 * sine * sine)
                : (DickinsonLift(angle), set == CoefficientSet.Dragonfly ? DragonflyDrag(sine * sine) : DickinsonDrag(angle));
            double[] along = Unit(wind[0], wind[1], wind[2]), across = Without(normal, along);
            across = Unit(across[0], across[1], across[2]);
            double half = 0.5 * 11.1 * 0.02, pressure = half * speed * speed;
            var element = new ElementInDouble { force = new double[3] };
            for (int axis = 0; axis < 3; axis++)
                element.force[axis] = pressure * (drag * along[axis] + lift * Math.Sign(Dot(wind, normal)) * across[axis]);
            double cosine = Math.Sqrt(1.0 - sine * sine), s = Math.Max(sine, 0.05);
            element.damping = (1.0 + s * s) * half * speed * Math.Max(0.0, lift * cosine + drag * s) / s;
            return element;
        }

        private static double Dot(double[] a, double[] b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

        private static double[] Unit(double x, double y, double z)
        {
            double length = Math.Sqrt(x * x + y * y + z * z);
            return new[] { x / length, y / length, z / length };
        }

        private static double[] Without(double[] v, double[] direction)
        {
            double part = Dot(v, direction);
            return new[] { v[0] - part * direction[0], v[1] - part * direction[1], v[2] - part * direction[2] };
        }

        private struct ElementInDouble
        {
            public double[] force;
            public double damping;
        }
    }
}
