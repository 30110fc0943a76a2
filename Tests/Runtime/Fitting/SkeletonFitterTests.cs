using System;
using System.Text;
using Alate.Fitting;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Places of the chains of a fitted skeleton, on wings of many shapes.</summary>
    public sealed class SkeletonFitterTests
    {
        private static readonly PolarWing[] s_Wings =
        {
            new PolarWing { aspect = 0.35 },
            new PolarWing { aspect = 1.0 },
            new PolarWing { aspect = 0.06 },
            new PolarWing { aspect = 0.5, sweep = -0.4 },
            new PolarWing { aspect = 0.5, tail = 0.5 },
            new PolarWing { aspect = 0.7, tail = 0.6, tailAngle = -1.6, tailWidth = 0.06 },
            new PolarWing { aspect = 0.6, tail = -0.35 },
            new PolarWing { aspect = 0.8, scallop = 0.03 },
            new PolarWing { aspect = 0.15, sweep = 0.3, scallop = 0.02 },
        };

        [Test]
        public void AWing_GetsAValidSkeleton_InsideIt_AlongItsLeadingEdge_OutToItsMargin([ValueSource(nameof(s_Wings))] PolarWing wing)
        {
            SkeletonFit fit = SkeletonFitter.Fit(wing.Mesh(), Hints());
            var measure = new FitMeasure(fit.Skeleton, wing.Outline());

            Assert.That(fit.Skeleton.Validate(), Is.Empty);
            Assert.That(measure.Outside(), Is.LessThan(0.01));
            Assert.That(measure.OffLeadingEdge(), Is.LessThan(0.03));
            Assert.That(measure.TipsOffMargin(), Is.LessThan(0.005));
        }

        [TestCase(3, 3)]
        [TestCase(4, 9)]
        [TestCase(16, 5)]
        [TestCase(16, 16)]
        public void ChainsAndJoints_AreAsManyAsWanted(int chains, int joints)
        {
            SkeletonFitSettings hints = Hints();
            hints.chains = chains;
            hints.jointsPerChain = joints;

            WingSkeleton skeleton = SkeletonFitter.Fit(new PolarWing().Mesh(), hints).Skeleton;

            Assert.That(skeleton.Validate(), Is.Empty);
            Assert.That(skeleton.ChainCount, Is.EqualTo(chains));
            Assert.That(skeleton.JointsPerChain, Is.EqualTo(joints));
        }

        [Test]
        public void Axes_RunAcrossForwardAndUp_AndTheHingeIsTheFirstJoint()
        {
            WingSkeleton skeleton = SkeletonFitter.Fit(new PolarWing { sweep = -0.3 }.Mesh(), Hints()).Skeleton;

            Assert.That(Vector3.Distance(skeleton.SpanAxis, Vector3.right), Is.LessThan(1e-4f));
            Assert.That(Vector3.Distance(skeleton.UpAxis, Vector3.up), Is.LessThan(1e-4f));
            Assert.That(skeleton.Hinge, Is.EqualTo(skeleton.GetJoint(0, 0)));
        }

        [Test]
        public void StraightChains_HaveEvenJoints_AndTipsFanEvenly()
        {
            WingSkeleton skeleton = SkeletonFitter.Fit(TestWings.Rectangle(), Hints()).Skeleton;

            Vector3[] last = skeleton.Chains[4].joints;
            float bone = Vector3.Distance(last[0], last[1]);
            for (int j = 1; j + 1 < last.Length; j++)
                Assert.That(Vector3.Distance(last[j], last[j + 1]), Is.EqualTo(bone).Within(0.01f));
            Vector3 middle = 0.5f * (skeleton.GetJoint(0, 0) + skeleton.GetJoint(4, 0));
            float fan = Angle(skeleton.GetJoint(0, 4) - middle, skeleton.GetJoint(4, 4) - middle);
            for (int i = 0; i < 4; i++)
            {
                float step = Angle(skeleton.GetJoint(i, 4) - middle, skeleton.GetJoint(i + 1, 4) - middle);
                Assert.That(step, Is.EqualTo(fan / 4f).Within(fan / 8f), $"chain {i}");
            }
        }

        [Test]
        public void ATail_GetsAChainToItsEnd()
        {
            var wing = new PolarWing { aspect = 0.7, tail = 0.6, tailAngle = -1.1, tailWidth = 0.06 };
            WingSkeleton skeleton = SkeletonFitter.Fit(wing.Mesh(), Hints()).Skeleton;

            Vector3 end = wing.At(wing.tailAngle);
            float nearest = float.MaxValue;
            for (int i = 1; i < skeleton.ChainCount; i++)
                nearest = Mathf.Min(nearest, Vector3.Distance(end, skeleton.GetJoint(i, 4)));

            Assert.That(nearest, Is.LessThan(0.03f));
            Assert.That(Vector3.Distance(end, skeleton.GetJoint(0, 4)), Is.GreaterThan(0.3f), "the principal chain keeps out of it");
        }

        [Test]
        public void JointsOfACurvedWing_LieOnItsSurface()
        {
            var wing = new PolarWing { aspect = 0.6, bend = -0.3, camber = -0.5 };
            WingSkeleton skeleton = SkeletonFitter.Fit(wing.Mesh(5), Hints()).Skeleton;

            Assert.That(skeleton.Validate(), Is.Empty);
            foreach (JointChain chain in skeleton.Chains)
            {
                foreach (Vector3 joint in chain.joints)
                {
                    double height = wing.bend * joint.x * joint.x + wing.camber * joint.z * joint.z;
                    Assert.That(joint.y, Is.EqualTo(height).Within(0.01));
                }
            }
        }

        [Test]
        public void AnyUnit_GivesTheSameSkeleton([Values(1e-15f, 1e-3f, 1e6f, 1e15f)] float unit)
        {
            SurfaceMesh wing = new PolarWing().Mesh();
            var scaled = new SurfaceMesh { positions = Array.ConvertAll(wing.positions, p => unit * p), triangles = wing.triangles };
            WingSkeleton one = SkeletonFitter.Fit(wing, Hints()).Skeleton, other = SkeletonFitter.Fit(scaled, Hints()).Skeleton;

            for (int i = 0; i < one.ChainCount; i++)
            {
                for (int j = 0; j < one.JointsPerChain; j++)
                    Assert.That(Vector3.Distance(one.GetJoint(i, j), other.GetJoint(i, j) / unit), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void TheSameMesh_GivesTheSameSkeletonToTheBit_AndTheMeshOverloadToo()
        {
            SurfaceMesh wing = new PolarWing { scallop = 0.02 }.Mesh();
            string first = Text(SkeletonFitter.Fit(wing, Hints()).Skeleton);
            string again = Text(SkeletonFitter.Fit(wing, Hints()).Skeleton);
            string mesh = Text(SkeletonFitter.Fit(TestWings.ToMesh(wing), Hints()).Skeleton);

            Assert.That(again, Is.EqualTo(first));
            Assert.That(mesh, Is.EqualTo(first));
        }

        private static SkeletonFitSettings Hints()
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.bodySide = Vector3.left;
            return hints;
        }

        private static string Text(WingSkeleton skeleton)
        {
            var text = new StringBuilder();
            void Add(Vector3 v) => text.Append(FormattableString.Invariant($"{v.x:R} {v.y:R} {v.z:R}\n"));
            Add(skeleton.Hinge);
            Add(skeleton.SpanAxis);
            Add(skeleton.UpAxis);
            foreach (JointChain chain in skeleton.Chains)
            {
                foreach (Vector3 joint in chain.joints)
                    Add(joint);
            }

            return text.ToString();
        }

        private static float Angle(Vector3 a, Vector3 b) => Vector3.Angle(a, b);
    }
}
