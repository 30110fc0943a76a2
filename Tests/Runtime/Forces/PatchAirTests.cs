using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class PatchAirTests
    {
        private static readonly float3 s_Wind = new float3(3f, -2f, -10f);
        private static readonly float3 s_Normal = math.normalize(new float3(0.1f, 1f, -0.2f));

        [Test]
        public void PaperLift_HasItsMaximumWhereThePolynomialHasIt()
        {
            Coefficients.Paper(math.radians(47.2289f), true, out float4 lift, out _);
            Assert.That(lift.x, Is.EqualTo(1.79847).Within(1.79847 * Lanes.CheckTolerance));
        }

        [Test]
        public void PaperLift_IsNegativeAtSmallAngles_UnlessClamped()
        {
            Coefficients.Paper(math.radians(2f), false, out float4 printed, out _);
            Coefficients.Paper(math.radians(2f), true, out float4 clamped, out _);
            Assert.That(printed.x, Is.EqualTo(-0.164388).Within(0.164388 * Lanes.CheckTolerance));
            Assert.That(clamped.x, Is.Zero);
        }

        [Test]
        public void Drag_AtRightAngles_IsThatOfItsSource()
        {
            Coefficients.Paper(math.PI / 2f, true, out _, out float4 paper);
            Coefficients.Dickinson(math.PI / 2f, out _, out float4 dickinson);
            Assert.That(paper.x, Is.EqualTo(4.61961).Within(4.61961 * Lanes.CheckTolerance));
            Assert.That(dickinson.x, Is.EqualTo(3.46088).Within(3.46088 * Lanes.CheckTolerance));
        }

        [Test]
        public void DickinsonLift_At45Degrees()
        {
            Coefficients.Dickinson(math.PI / 4f, out float4 lift, out _);
            Assert.That(lift.x, Is.EqualTo(1.80456).Within(1.80456 * Lanes.CheckTolerance));
        }

        [Test]
        public void FlatPlateDrag_At60Degrees()
        {
            Coefficients.FlatPlate(math.sin(math.PI / 3f), math.cos(math.PI / 3f), out _, out float4 drag);
            Assert.That(drag.x, Is.EqualTo(1.475).Within(1.475 * Lanes.CheckTolerance));
        }

        [Test]
        public void DickinsonSeries_FollowsSineAndCosine_OverTheWholeQuadrant()
        {
            for (int k = 0; k <= 900; k++)
            {
                double degrees = 0.1 * k;
                Coefficients.Dickinson((float)(degrees * System.Math.PI / 180.0), out float4 lift, out float4 drag);
                double wantedLift = 0.225 + 1.58 * System.Math.Sin((2.13 * degrees - 7.20) * System.Math.PI / 180.0);
                double wantedDrag = 1.92 - 1.55 * System.Math.Cos((2.04 * degrees - 9.82) * System.Math.PI / 180.0);
                Assert.That(lift.x, Is.EqualTo(wantedLift).Within(3e-6), $"lift at {degrees}°");
                Assert.That(drag.x, Is.EqualTo(wantedDrag).Within(3e-6), $"drag at {degrees}°");
            }
        }

        [TestCase(CoefficientSet.Paper, -0.0994486, -0.994486, -5.90842)]
        [TestCase(CoefficientSet.FlatPlate, 0.106587, 1.06587, -0.778523)]
        public void ElementForce_IsTheCheckedOne(CoefficientSet set, double x, double y, double z)
        {
            float3 force = Load(set).force[0];
            double tolerance = Lanes.CheckTolerance * System.Math.Sqrt(x * x + y * y + z * z);
            Assert.That(force.x, Is.EqualTo(x).Within(tolerance));
            Assert.That(force.y, Is.EqualTo(y).Within(tolerance));
            Assert.That(force.z, Is.EqualTo(z).Within(tolerance));
        }

        [Test]
        public void DampingEstimate_IsTheCheckedOne()
        {
            Assert.That(Load(CoefficientSet.Dickinson1999).damping.x, Is.EqualTo(3.2192).Within(3.2192 * Lanes.CheckTolerance));
        }

        [Test]
        public void StillAir_MakesNoForce()
        {
            PatchLoad load = PatchAir.Load(ModelOptions.Physical, default, Lanes.All(0f, 1f, 0f), 0f, 1f);
            Assert.That(load.force[0], Is.EqualTo(float3.zero));
            Assert.That(load.damping.x, Is.Zero);
        }

        [TestCase(0f, -3f, 0f)]
        [TestCase(0f, 0f, -3f)]
        public void FlowAlongNormalOrSurface_MakesDragOnly(float x, float y, float z)
        {
            float3 force = PatchAir.Load(ModelOptions.Physical, Lanes.All(x, y, z), Lanes.All(0f, 1f, 0f), 0f, 1f).force[0];
            var wind = new float3(x, y, z);
            Assert.That(math.dot(force, wind), Is.Positive);
            if (z == 0f)
                Assert.That(math.length(math.cross(force, wind)), Is.LessThan(1e-4f * math.length(force) * 3f));
        }

        private static PatchLoad Load(CoefficientSet set)
        {
            ModelOptions options = ModelOptions.Physical;
            options.coefficients = set;
            float3 span = new float3(1f, -0.1f, 0f);
            span = math.normalize(span - s_Normal * math.dot(span, s_Normal));
            float3 wind = s_Wind - span * math.dot(s_Wind, span);
            return PatchAir.Load(options, new SoaFloat3(wind), new SoaFloat3(s_Normal), 0f, 0.5f * 11.1f * 0.02f);
        }
    }
}
