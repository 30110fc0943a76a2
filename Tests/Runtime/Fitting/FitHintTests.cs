using Alate.Fitting;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Effect of the hints of a user, and the guesses without them.</summary>
    public sealed class FitHintTests
    {
        // A straight leading edge over a rounded rear, tip at x = 1, a little away from the origin.
        private static readonly Vector3 s_Place = new Vector3(0.02f, 0f, 0f);

        [Test]
        public void Everything_Said_LeavesNoDoubt()
        {
            SkeletonFitSettings hints = Hints();
            hints.hinge = s_Place;
            SkeletonFit fit = SkeletonFitter.Fit(Wing(), hints);

            Assert.That(fit.Confidence, Is.EqualTo(1f));
            Assert.That(fit.Warnings, Is.Empty);
            Assert.That(fit.Skeleton.Hinge, Is.EqualTo(s_Place));
        }

        [Test]
        public void HingeBodyPointAndBodySide_FindTheSameBase()
        {
            SkeletonFitSettings hinge = Hints(), point = Hints(), side = Hints();
            hinge.hinge = s_Place;
            point.bodyPoint = new Vector3(-0.3f, 0.1f, 0.02f);
            side.bodySide = new Vector3(-3f, 0.5f, 0f);

            AssertAlike(Fit(hinge).Skeleton, Fit(point).Skeleton);
            AssertAlike(Fit(hinge).Skeleton, Fit(side).Skeleton);
        }

        [Test]
        public void TheBodyOnTheOtherSide_TurnsTheSkeletonRound()
        {
            SkeletonFitSettings hints = Hints();
            hints.bodySide = Vector3.right;
            WingSkeleton skeleton = Fit(hints).Skeleton;

            Assert.That(skeleton.GetJoint(0, 0).x, Is.GreaterThan(0.9f));
            Assert.That(skeleton.SpanAxis.x, Is.LessThan(-0.99f));
            Assert.That(skeleton.GetJoint(0, 2).z, Is.GreaterThan(skeleton.GetJoint(4, 2).z), "forward stays forward");
        }

        [Test]
        public void TheOtherForward_MakesTheOtherEdgeLead()
        {
            SkeletonFitSettings hints = Hints();
            hints.bodySide = Vector3.left;
            hints.forward = Vector3.back;
            WingSkeleton skeleton = Fit(hints).Skeleton;

            Assert.That(skeleton.Validate(), Is.Empty);
            Assert.That(skeleton.GetJoint(0, 2).z, Is.LessThan(skeleton.GetJoint(4, 2).z));
        }

        [Test]
        public void TheOtherUp_OnlyTurnsTheUpAxis()
        {
            SkeletonFitSettings hints = Hints(), down = Hints();
            hints.bodySide = down.bodySide = Vector3.left;
            down.up = new Vector3(0.1f, -1f, 0f);
            SkeletonFit fit = Fit(down);

            AssertAlike(Fit(hints).Skeleton, fit.Skeleton);
            Assert.That(fit.Skeleton.UpAxis.y, Is.LessThan(-0.99f));
        }

        [Test]
        public void WithoutHints_TheOriginNextToTheWingIsTheHinge_ThenTheBody_ThenTheNarrowEnd()
        {
            float near = Guess(Vector3.zero), beside = Guess(new Vector3(0.5f, 0f, 0f)), far = Guess(new Vector3(40f, 0f, 9f));

            Assert.That(near, Is.InRange(0.7f, 0.95f));
            Assert.That(beside, Is.InRange(0.5f, near - 0.01f));
            Assert.That(far, Is.InRange(0.1f, beside - 0.01f));
        }

        [Test]
        public void WithoutForward_TheStraighterEdgeLeads_WithLessConfidence([Values(1f, -1f)] float side)
        {
            SurfaceMesh wing = Wing();
            for (int k = 0; k < wing.positions.Length; k++)
                wing.positions[k].z *= side;
            SkeletonFitSettings hints = Hints();
            hints.bodySide = Vector3.left;
            hints.forward = null;
            SkeletonFit fit = SkeletonFitter.Fit(wing, hints);

            Assert.That(fit.Warns(SkeletonFitWarningKind.LeadingEdgeGuessed), Is.True);
            Assert.That(fit.Confidence, Is.InRange(0.5f, 0.9f));
            Assert.That(side * (fit.Skeleton.GetJoint(0, 2).z - fit.Skeleton.GetJoint(4, 2).z), Is.GreaterThan(0f));
            Vector3 first = (fit.Skeleton.GetJoint(0, 4) - fit.Skeleton.GetJoint(0, 0)).normalized;
            Assert.That(Vector3.Distance(fit.Skeleton.SpanAxis.normalized, first), Is.LessThan(0.01f), "along the first chain");
        }

        [TestCase(0f, 1f, 0f, "stands on the wing")]
        [TestCase(1f, 0f, 0.05f, "along the wing")]
        public void AForwardThatTellsNothing_IsNamed(float x, float y, float z, string said)
        {
            SkeletonFitSettings hints = Hints();
            hints.bodySide = Vector3.left;
            hints.forward = new Vector3(x, y, z);

            AssertWarns(Fit(hints), SkeletonFitWarningKind.LeadingEdgeGuessed, said);
        }

        [Test]
        public void AnUprightWing_TakesTheFrontOfItsTriangles()
        {
            SurfaceMesh wing = Wing();
            for (int k = 0; k < wing.positions.Length; k++)
                wing.positions[k] = new Vector3(wing.positions[k].y, wing.positions[k].x, wing.positions[k].z);
            SkeletonFitSettings hints = Hints();
            hints.bodySide = Vector3.down;
            SkeletonFit fit = SkeletonFitter.Fit(wing, hints);
            float front = Vector3.Dot(FrontOf(wing), fit.Skeleton.UpAxis);

            AssertWarns(fit, SkeletonFitWarningKind.UpperSideGuessed, "front");
            Assert.That(front, Is.GreaterThan(0.99f));
            Assert.That(fit.Skeleton.Validate(), Is.Empty);
        }

        [Test]
        public void AHingeFarOff_FindsTheBaseOnly_AndIsNamed([Values(-0.5f, 0.5f)] float off)
        {
            SkeletonFitSettings hints = Hints();
            hints.hinge = new Vector3(-0.1f, off, 0f);
            SkeletonFit fit = Fit(hints);

            AssertWarns(fit, SkeletonFitWarningKind.HingeOffWing, "hinge");
            Assert.That(fit.Skeleton.Hinge, Is.EqualTo(fit.Skeleton.GetJoint(0, 0)));
            Assert.That(fit.Skeleton.Hinge.x, Is.LessThan(0.1f));
        }

        [Test]
        public void ABodySideThatStandsOnTheWing_IsNamed()
        {
            SkeletonFitSettings hints = Hints();
            hints.bodySide = Vector3.down;

            AssertWarns(Fit(hints), SkeletonFitWarningKind.HingeGuessed, "stands on the wing");
        }

        [Test]
        public void AFanWithoutACorner_SaysThatItsTipIsUnclear()
        {
            const int k_Corners = 200;
            var positions = new Vector3[k_Corners + 1];
            int[] triangles = new int[3 * (k_Corners - 1)];
            for (int k = 0; k < k_Corners; k++)
            {
                float angle = Mathf.PI * (0.5f - (float)k / (k_Corners - 1)), radius = Mathf.Exp(-0.36f * angle);
                positions[k + 1] = radius * new Vector3(Mathf.Cos(angle), 0f, Mathf.Sin(angle));
                for (int corner = 0; corner < 3 && k > 0; corner++)
                    triangles[3 * (k - 1) + corner] = corner == 0 ? 0 : k + corner - 1;
            }

            SkeletonFitSettings hints = Hints();
            hints.hinge = Vector3.zero;
            SkeletonFit fit = SkeletonFitter.Fit(new SurfaceMesh { positions = positions, triangles = triangles }, hints);

            AssertWarns(fit, SkeletonFitWarningKind.TipUnclear, "%");
            Assert.That(fit.Confidence, Is.LessThan(0.9f));
        }

        private static SkeletonFit Fit(in SkeletonFitSettings hints) => SkeletonFitter.Fit(Wing(), hints);

        private static float Guess(Vector3 place)
        {
            SurfaceMesh wing = Wing();
            for (int k = 0; k < wing.positions.Length; k++)
                wing.positions[k] += place;
            SkeletonFit fit = SkeletonFitter.Fit(wing, Hints());

            AssertWarns(fit, SkeletonFitWarningKind.HingeGuessed, "guess");
            Assert.That(fit.Skeleton.GetJoint(0, 0).x, Is.LessThan(place.x + 0.1f));
            return fit.Confidence;
        }

        private static SurfaceMesh Wing()
        {
            SurfaceMesh wing = TestWings.Ellipse(24, 12, 1f, 0.4f);
            for (int k = 0; k < wing.positions.Length; k++)
            {
                Vector3 p = wing.positions[k];
                float narrow = 0.2f + 0.8f * Mathf.SmoothStep(0f, 0.4f, p.x);
                wing.positions[k] = new Vector3(p.x, 0f, narrow * p.z) + s_Place;
            }

            return wing;
        }

        private static SkeletonFitSettings Hints() => SkeletonFitSettings.Default;

        private static Vector3 FrontOf(SurfaceMesh wing)
        {
            Vector3 sum = Vector3.zero;
            for (int k = 0; k < wing.triangles.Length; k += 3)
            {
                Vector3 a = wing.positions[wing.triangles[k]];
                sum += Vector3.Cross(wing.positions[wing.triangles[k + 1]] - a, wing.positions[wing.triangles[k + 2]] - a);
            }

            return sum.normalized;
        }

        private static void AssertWarns(SkeletonFit fit, SkeletonFitWarningKind kind, string said)
        {
            foreach (SkeletonFitWarning warning in fit.Warnings)
            {
                if (warning.Kind == kind)
                {
                    Assert.That(warning.ToString(), Does.Contain(said));
                    return;
                }
            }

            Assert.Fail($"no warning of {kind}");
        }

        private static void AssertAlike(WingSkeleton one, WingSkeleton other)
        {
            for (int i = 0; i < one.ChainCount; i++)
            {
                for (int j = 0; j < one.JointsPerChain; j++)
                    Assert.That(Vector3.Distance(one.GetJoint(i, j), other.GetJoint(i, j)), Is.LessThan(0.01f), $"chain {i}, joint {j}");
            }
        }
    }
}
