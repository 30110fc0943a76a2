using System;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class BakeErrorTests
    {
        [Test]
        public void AnUnusableSkeleton_IsRefusedWithItsFirstProblem()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.name = "Left hind";
            skeleton.Chains = new[] { skeleton.Chains[0], skeleton.Chains[1] };

            Assert.That(Refusal(skeleton, TestWings.Ellipse()), Does.Contain("Left hind").And.Contain(skeleton.Validate()[0].Message));
        }

        [Test]
        public void NothingAtAll_IsRefused()
        {
            Assert.Throws<ArgumentNullException>(() => TestWings.Bake(null, TestWings.Ellipse()));
            Assert.Throws<ArgumentNullException>(() => WingRig.Bake(TestWings.Fan(), (Mesh)null, WingRigSettings.Default));
        }

        [Test]
        public void ANegativeNumberOfPatches_IsRefused()
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => TestWings.Bake(TestWings.Fan(), TestWings.Ellipse(), -1));
        }

        [Test]
        public void MissingVertices_AreNamed([Values] bool empty)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.positions = empty ? new Vector3[0] : null;

            Assert.That(Refusal(surface), Is.EqualTo("Mesh 'Ellipse' has no vertices."));
        }

        [Test]
        public void MissingTriangles_AreNamed([Values] bool empty)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.triangles = empty ? new int[0] : null;

            Assert.That(Refusal(surface), Is.EqualTo("Mesh 'Ellipse' has no triangles."));
        }

        [Test]
        public void HalfATriangle_IsNamed()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            Array.Resize(ref surface.triangles, 8);

            Assert.That(Refusal(surface), Does.Contain("8 indices"));
        }

        [Test]
        public void AnIndexOutOfRange_IsNamed([Values(-1, 91)] int index)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.triangles[4] = index;

            Assert.That(Refusal(surface), Is.EqualTo($"Mesh 'Ellipse': triangle 1 refers to vertex {index}, but there are 91 vertices."));
        }

        [Test]
        public void AVertexThatIsNotFinite_IsNamed([Values(float.NaN, float.PositiveInfinity)] float value)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.positions[17].z = value;

            Assert.That(Refusal(surface), Does.Contain("vertex 17").And.Contain("not finite"));
        }

        [Test]
        public void AWrongNumberOfNormals_IsNamed()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.normals = new Vector3[5];

            Assert.That(Refusal(surface), Does.Contain("5 normals for 91 vertices"));
        }

        [Test]
        public void AWrongNumberOfTangents_IsNamed()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.tangents = new Vector4[5];

            Assert.That(Refusal(surface), Does.Contain("5 tangents for 91 vertices"));
        }

        [Test]
        public void AMeshWithoutArea_IsRefused()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].z = 0f;

            Assert.That(Refusal(surface), Does.Contain("no triangle with an area"));
        }

        [Test]
        public void AMeshBehindTheHinge_IsRefused()
        {
            Assert.That(Refusal(Shifted(new Vector3(-2f, 0f, 0f))), Does.Contain("behind the hinge"));
        }

        private static readonly Vector3[] s_FarAway =
        {
            new Vector3(0f, 0f, 1f), new Vector3(0f, 0f, -5f), new Vector3(0f, 0.3f, 0f), new Vector3(0f, -100f, 0f),
            new Vector3(1f, 0f, 0f), new Vector3(1000f, 0f, 0f), new Vector3(1e30f, 1e30f, 1e30f),
        };

        [TestCaseSource(nameof(s_FarAway))]
        public void AMeshFarAwayFromItsSkeleton_IsRefused(Vector3 by)
        {
            Assert.That(Refusal(Shifted(by)), Does.Contain("far away").Or.Contain("does not fit").Or.Contain("no triangle with an area"));
        }

        // Shifted across the span by half of its chord less of it lies near, and by more hardly any.
        [Test]
        public void TheShareThatLiesNear_IsNamedInPercent()
        {
            int last = 100, told = 0;
            for (float by = 0.16f; by < 0.6f; by += 0.02f)
            {
                SurfaceMesh surface = Shifted(new Vector3(0f, 0f, by));
                string message = "";
                try
                {
                    TestWings.Bake(TestWings.Fan(), surface).Release();
                }
                catch (ArgumentException exception)
                {
                    message = exception.Message;
                }

                int end = message.IndexOf(" % of its area lies near the joints.", StringComparison.Ordinal);
                if (end < 0)
                    continue;
                int share = int.Parse(message.Substring(0, end).Split(' ')[^1]);
                Assert.That(share, Is.InRange(0, 50).And.LessThanOrEqualTo(last), $"shifted by {by}");
                (last, told) = (share, told + (share > 1 ? 1 : 0));
            }

            Assert.That(told, Is.GreaterThan(3));
        }

        [Test]
        public void AMeshInOtherUnits_IsRefused([Values(0.01f, 0.1f, 10f, 1000f)] float scale)
        {
            SurfaceMesh surface = TestWings.Ellipse(12, 6, scale * TestWings.Length, scale * TestWings.Chord);

            Assert.That(Refusal(surface), Does.Contain("does not fit").Or.Contain("far away"));
        }

        [Test]
        public void ASkeletonThatCoversTheWingLoosely_IsAccepted()
        {
            WingSkeleton skeleton = TestWings.Fan(5, 5, 0.85f, 0.4f);

            Assert.DoesNotThrow(() => TestWings.Bake(skeleton, TestWings.Ellipse()).Release());
        }

        [Test]
        public void APositionTooLargeToComputeWith_IsRefused()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.positions[3] = new Vector3(3e38f, 3e38f, -3e38f);

            Assert.That(Refusal(surface), Is.Not.Empty);
        }

        private static SurfaceMesh Shifted(Vector3 by)
        {
            SurfaceMesh surface = TestWings.Ellipse();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k] += by;
            return surface;
        }

        private static string Refusal(SurfaceMesh surface) => Refusal(TestWings.Fan(), surface);

        private static string Refusal(WingSkeleton skeleton, SurfaceMesh surface)
        {
            string message = Assert.Throws<ArgumentException>(() => TestWings.Bake(skeleton, surface)).Message;
            Assert.That(message, Does.Not.Contain("\n"));
            return message;
        }
    }
}
