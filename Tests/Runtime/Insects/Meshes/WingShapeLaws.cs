using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Measures of parts that may be wings, against the shapes that they are taken of.</summary>
    public sealed class WingShapeLaws
    {
        [TestCase(-3f, 0f)]
        [TestCase(-1f, 0f)]
        [TestCase(-0.5f, 0.25f)]
        [TestCase(0f, 0.5f)]
        [TestCase(0.8f, 0.9f)]
        [TestCase(1f, 1f)]
        [TestCase(4f, 1f)]
        public void OfABox_TheShareOnTheRight_IsThatOfItsWidth(float middle, float share)
        {
            // Turned by a quarter about Y: the box's Z runs along the insect's X.
            var toInsect = Matrix4x4.TRS(new Vector3(middle, 5f, 6f), Quaternion.Euler(0f, 90f, 0f), Vector3.one);
            var shape = WingShape.Of(new Bounds(Vector3.zero, new Vector3(8f, 0.5f, 2f)), toInsect);

            Assert.That(shape.rightShare, Is.EqualTo(share).Within(1e-5f));
            Assert.That(shape.Side, Is.EqualTo(share >= 0.8f ? WingSide.Right : share <= 0.2f ? WingSide.Left : (WingSide?)null));
            Assert.That(shape.area, Is.EqualTo(16f).Within(1e-4f), "its two longest sides");
            Assert.That((shape.centroid - new Vector3(middle, 5f, 6f)).magnitude, Is.LessThan(1e-5f));
            Assert.That((shape.bounds.size - new Vector3(2f, 0.5f, 8f)).magnitude, Is.LessThan(1e-5f));
        }

        [TestCase(0.35f, true)]
        [TestCase(0.45f, false)]
        public void ABox_IsASheet_WhereItsThinSideIsAFifthOfTheNext(float thin, bool isSheet)
        {
            foreach (Vector3 size in new[] { new Vector3(5f, thin, 2f), new Vector3(thin, 2f, 5f), new Vector3(2f, 5f, thin) })
                Assert.That(WingShape.Of(new Bounds(Vector3.zero, size), Matrix4x4.identity).isSheet, Is.EqualTo(isSheet));
        }

        [TestCase(-1f, 0f)]
        [TestCase(2f, 1f)]
        public void AFlatBox_IsOnTheSideOnWhichItLies(float at, float share) => Assert.That(
            WingShape.Of(new Bounds(new Vector3(at, 0f, 0f), new Vector3(0f, 2f, 3f)), Matrix4x4.identity).rightShare, Is.EqualTo(share));

        [Test]
        public void OfTriangles_AreaMiddleAndSide_AreTheirOwn()
        {
            // Right triangles with legs 2 and 3 at x = 1 to 3, and legs 1 and 1 at x = -2 to -1.
            Vector3[] positions =
            {
                new Vector3(1f, 0f, 0f), new Vector3(3f, 0f, 0f), new Vector3(1f, 0f, 3f),
                new Vector3(-1f, 0f, 0f), new Vector3(-2f, 0f, 0f), new Vector3(-1f, 0f, 1f),
            };
            var shape = WingShape.Of(positions, Part(0, 1, 2, 3, 4, 5), Matrix4x4.identity);

            Assert.That(shape.area, Is.EqualTo(3.5f).Within(1e-5f));
            Assert.That(shape.rightShare, Is.EqualTo(3f / 3.5f).Within(1e-5f));
            Vector3 centroid = (3f * new Vector3(5f / 3f, 0f, 1f) + 0.5f * new Vector3(-4f / 3f, 0f, 1f / 3f)) / 3.5f;
            Assert.That((shape.centroid - centroid).magnitude, Is.LessThan(1e-5f));
            Assert.That((shape.bounds.min, shape.bounds.max), Is.EqualTo((new Vector3(-2f, 0f, 0f), new Vector3(3f, 0f, 3f))));
            Assert.That(shape.isSheet, Is.True);
            var scaled = WingShape.Of(positions, Part(0, 1, 2), Matrix4x4.Scale(new Vector3(-2f, 2f, 2f)));
            Assert.That((scaled.area, scaled.rightShare), Is.EqualTo((12f, 0f)));
        }

        [TestCase(0.5f, true)]
        [TestCase(1f, true)]
        [TestCase(1.2f, false)]
        public void ABentSheet_IsOne_WhileItFacesItsMiddle(float bend, bool isSheet)
        {
            // An arc of a tube, from −bend to bend: it faces its middle by sin(bend) / bend.
            const int pieces = 64;
            var positions = new Vector3[2 * pieces + 2];
            int[] triangles = new int[6 * pieces];
            for (int k = 0; k <= pieces; k++)
            {
                float angle = bend * (2f * k / pieces - 1f);
                positions[2 * k] = new Vector3(Mathf.Sin(angle), Mathf.Cos(angle), 0f);
                positions[2 * k + 1] = positions[2 * k] + new Vector3(0f, 0f, 5f);
                if (k == pieces)
                    continue;
                int[] corners = { 2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 2, 2 * k + 1, 2 * k + 3 };
                corners.CopyTo(triangles, 6 * k);
            }

            foreach (Quaternion turn in new[] { Quaternion.identity, Quaternion.Euler(90f, 0f, 0f), Quaternion.Euler(0f, 0f, 90f) })
                Assert.That(WingShape.Of(positions, Part(triangles), Matrix4x4.Rotate(turn)).isSheet, Is.EqualTo(isSheet));
            Assert.That(Math.Sin(bend) / bend > 0.8 || !isSheet, "the rule");
        }

        private static MeshSelection Part(params int[] corners)
        {
            int[] vertices = new int[corners.Max() + 1];
            for (int k = 0; k < vertices.Length; k++)
                vertices[k] = k;
            return new MeshSelection(vertices, corners);
        }
    }
}
