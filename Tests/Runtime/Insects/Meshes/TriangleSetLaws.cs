using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>Sets of triangles: what is asked of each, what they have, how they are divided; and points that tell pieces.</summary>
    public sealed class TriangleSetLaws
    {
        private Mesh m_Mesh;

        // Three submeshes: a sheet, lines, and two sheets of which one hangs together with the first.
        [SetUp]
        public void MakeAMesh()
        {
            m_Mesh = new MeshSketch().Sheet(Vector3.zero, Vector3.right, Vector3.forward, 2, 1).NextSubmesh()
                .NextSubmesh().Sheet(Vector3.right, Vector3.right, Vector3.forward, 1, 1)
                .Sheet(9f * Vector3.up, Vector3.right, Vector3.forward, 1, 1).ToMesh();
            m_Mesh.SetIndices(new[] { 0, 1 }, MeshTopology.Lines, 1);
        }

        [TearDown]
        public void EndIt() => Object.DestroyImmediate(m_Mesh);

        [Test]
        public void EachTriangle_IsAskedOnce_WithItsSubmeshAndItsCornersInOrder()
        {
            var asked = new List<(int, int, int, int)>();
            var set = new TriangleSet(m_Mesh);
            set.Add((submesh, a, b, c) =>
            {
                asked.Add((submesh, a, b, c));
                return false;
            });
            var all = new List<(int, int, int, int)>();
            foreach (int submesh in new[] { 0, 2 })
            {
                int[] corners = m_Mesh.GetTriangles(submesh);
                for (int first = 0; first < corners.Length; first += 3)
                    all.Add((submesh, corners[first], corners[first + 1], corners[first + 2]));
            }

            Assert.That(asked, Is.EqualTo(all));
            Assert.That((set.IsEmpty, set.IsAll), Is.EqualTo((true, false)));
            asked.Clear();
            set.Add((submesh, a, b, c) => true);
            Assert.That((set.IsEmpty, set.IsAll), Is.EqualTo((false, true)));
            set.Divide((a, b, c) =>
            {
                asked.Add((-1, a, b, c));
                return 0;
            });
            Assert.That(asked, Is.EqualTo(all.Select(one => (-1, one.Item2, one.Item3, one.Item4))));
        }

        [Test]
        public void WhatWasAdded_Stays_AndOneTriangleIsNeitherNoneNorAll()
        {
            var set = new TriangleSet(m_Mesh);
            int[] last = m_Mesh.GetTriangles(2).Skip(9).ToArray();
            set.Add((submesh, a, b, c) => (a, b, c) == (last[0], last[1], last[2]));
            Assert.That((set.IsEmpty, set.IsAll, set.Has(2, 3), set.Has(2, 2)), Is.EqualTo((false, false, true, false)));
            Assert.That(set.Corners(), Is.EqualTo(last));
            set.Add((submesh, a, b, c) => submesh == 0);
            Assert.That(set.Corners(), Is.EqualTo(m_Mesh.GetTriangles(0).Concat(last)));
            Assert.That(set.Has(2, 3) && !set.IsAll);
        }

        [Test]
        public void APart_IsAddedAsItIsSelected()
        {
            var submesh = new TriangleSet(m_Mesh);
            submesh.Add(WingPart.Submesh, 2, default);
            Assert.That(submesh.Corners(), Is.EqualTo(m_Mesh.GetTriangles(2)));
            var connected = new TriangleSet(m_Mesh);
            connected.Add(WingPart.ConnectedPart, 0, default);
            Assert.That(connected.Corners(), Is.EqualTo(m_Mesh.GetTriangles(0).Concat(m_Mesh.GetTriangles(2).Take(6))));
            var whole = new TriangleSet(m_Mesh);
            whole.Add(WingPart.WholeMesh, 0, default);
            Assert.That(whole.IsAll);
        }

        // Groups keep the submeshes, in which each triangle is where it was.
        [Test]
        public void Groups_HaveTheirTriangles_BySubmesh()
        {
            var set = new TriangleSet(m_Mesh);
            set.Add((submesh, a, b, c) => true);
            Dictionary<bool, int[][]> groups = set.Divide((a, b, c) => m_Mesh.vertices[a].y > 1f);
            Assert.That(groups, Has.Count.EqualTo(2));
            Assert.That(groups[false], Is.EqualTo(new[] { m_Mesh.GetTriangles(0), new int[0], m_Mesh.GetTriangles(2).Take(6).ToArray() }));
            Assert.That(groups[true], Is.EqualTo(new[] { new int[0], new int[0], m_Mesh.GetTriangles(2).Skip(6).ToArray() }));
        }

        // The middle of the largest triangle: of a sliver beside it other parts may be nearer.
        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void APiece_IsToldByTheMiddleOfItsLargestTriangle(int largest)
        {
            var positions = new List<Vector3> { Vector3.zero };
            var corners = new List<int>();
            for (int triangle = 0; triangle < 3; triangle++)
            {
                float size = triangle == largest ? 2f : 1f;
                positions.Add(size * new Vector3(Mathf.Cos(2f * triangle), 0f, Mathf.Sin(2f * triangle)));
                positions.Add(size * new Vector3(Mathf.Cos(2f * triangle + 1f), 0f, Mathf.Sin(2f * triangle + 1f)));
                corners.AddRange(new[] { 0, 2 * triangle + 1, 2 * triangle + 2 });
            }

            var mesh = new Mesh { vertices = positions.ToArray(), triangles = corners.ToArray() };
            Vector3 point = MeshParts.Parts(mesh).Single().point;
            Object.DestroyImmediate(mesh);
            Assert.That((point - (positions[2 * largest + 1] + positions[2 * largest + 2]) / 3f).magnitude, Is.LessThan(1e-6f));
        }

        [Test]
        public void APieceWithoutArea_IsToldByAPointOfIt()
        {
            var mesh = new Mesh { vertices = new[] { Vector3.up, Vector3.up, 4f * Vector3.up }, triangles = new[] { 0, 1, 2 } };
            Vector3 point = MeshParts.Parts(mesh).Single().point;
            Object.DestroyImmediate(mesh);
            Assert.That((point - 2f * Vector3.up).magnitude, Is.LessThan(1e-6f));
        }

        [Test]
        public void TwoParts_Overlap_WhereTheyShareAVertex()
        {
            var random = new System.Random(4);
            for (int round = 0; round < 300; round++)
            {
                int[] a = Some(), b = Some();
                RiggedPart one = Part(a), other = Part(b);
                Assert.That(one.Overlaps(other), Is.EqualTo(a.Intersect(b).Any()), $"{string.Join(" ", a)}, {string.Join(" ", b)}");
                Assert.That(other.Overlaps(one), Is.EqualTo(one.Overlaps(other)));
            }

            RiggedPart Part(int[] vertices) => new RiggedPart(new MeshSelection(vertices, new int[0]), null, null);
            int[] Some() => Enumerable.Range(0, random.Next(1, 6)).Select(_ => random.Next(16)).Distinct().OrderBy(v => v).ToArray();
        }

        // As .NET and as Mono write them; without a name of a parameter, a text is the author's own.
        [Test]
        public void ARefusal_IsToldInOneLine_WithoutTheNameOfTheParameter()
        {
            Assert.That(RiggedParts.OneLine(new ArgumentException("Not\r\nso.", "x")), Is.EqualTo("Not so."));
            Assert.That(RiggedParts.OneLine(new WrittenException("Not so.\r\nParameter name: x", "x")), Is.EqualTo("Not so."));
            Assert.That(RiggedParts.OneLine(new WrittenException("Not (Parameter 'so').", null)), Is.EqualTo("Not (Parameter 'so')."));
            Assert.That(RiggedParts.OneLine(new WrittenException("Not so.\nParameter name: x", null)),
                Is.EqualTo("Not so. Parameter name: x"));
        }

        private sealed class WrittenException : ArgumentException
        {
            public WrittenException(string message, string parameter) : base(message, parameter) => Message = message;

            public override string Message { get; }
        }
    }
}
