using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Laws of the parts of a mesh that take the place of whole wings where they look small.</summary>
    public sealed class SmallerPartLaws
    {
        private readonly List<Object> m_Made = new List<Object>();

        [TearDown]
        public void DestroyMeshes()
        {
            m_Made.ForEach(Object.DestroyImmediate);
            m_Made.Clear();
        }

        [Test]
        public void ASixthOfTheTrianglesRemains_OfTheFirstVertices()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse(24, 12)));
            MeshSelection whole = MeshParts.Select(mesh, WingPart.WholeMesh, 0, Vector3.zero);
            var part = SmallerPart.Of(mesh, whole);

            Assert.That(part.triangles.Single().Length / 3, Is.EqualTo(96), "of 576");
            Assert.That(part.selection.vertices.Take(part.vertexCount), Is.EqualTo(part.triangles[0].Distinct().OrderBy(v => v)));
            Assert.That(part.selection.vertices.Skip(part.vertexCount), Is.Ordered);
            Assert.That(part.selection.vertices.OrderBy(v => v), Is.EqualTo(whole.vertices), "each once");
            Assert.That(
                part.selection.triangles.Select(place => part.selection.vertices[place]),
                Is.EqualTo(whole.triangles.Select(place => whole.vertices[place])), "all of the triangles, as they were");
        }

        // A plane wing loses nothing but what its outline bends away from straight lines.
        [Test]
        public void ItCoversTheWing([Values(6, 12, 24)] int rows)
        {
            Mesh straight = Keep(TestWings.ToMesh(TestWings.Rectangle(2 * rows, rows)));
            Mesh round = Keep(TestWings.ToMesh(TestWings.Ellipse(2 * rows, rows)));
            Assert.That(Area(straight, Part(straight).triangles), Is.EqualTo(0.5f).Within(1e-6f));
            float whole = Area(round, new[] { round.triangles });
            Assert.That(Area(round, Part(round).triangles), Is.EqualTo(whole).Within(0.01f * whole));
        }

        // Of 576 squares' halves 96 remain: triangles that are as wide as long have sides of a ninth.
        [Test]
        public void NoTriangleIsLong()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Rectangle(24, 12)));
            Vector3[] places = mesh.vertices;
            int[] corners = Part(mesh).triangles[0];
            float longest = 0f;
            for (int k = 0; k < corners.Length; k++)
                longest = math.max(longest, (places[corners[k]] - places[corners[k % 3 == 2 ? k - 2 : k + 1]]).magnitude);
            Assert.That(longest, Is.LessThan(0.25f));
        }

        [Test]
        public void ThereIsNone_OfFewTriangles()
        {
            Mesh few = Keep(TestWings.ToMesh(TestWings.Rectangle(8, 4))), more = Keep(TestWings.ToMesh(TestWings.Rectangle(11, 3)));
            Assert.That(few.triangles.Length / 3, Is.EqualTo(64));
            Assert.That(Part(few), Is.Null);
            Assert.That(Part(more).triangles[0].Length / 3, Is.EqualTo(64), "of 66");
        }

        // It would take too long to make.
        [Test]
        public void ThereIsNone_OfVeryManyTriangles()
        {
            Assert.That(Part(Keep(TestWings.ToMesh(TestWings.Rectangle(80, 50)))), Is.Not.Null, "8,000");
            Assert.That(Part(Keep(TestWings.ToMesh(TestWings.Rectangle(81, 50)))), Is.Null);
        }

        [Test]
        public void ThereIsNone_WhereSomethingElseHangsOnToTheVertices([Values] bool line)
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Rectangle()));
            Vector3[] positions = mesh.vertices;
            int own = positions.Length;
            mesh.vertices = positions.Append(new Vector3(-1f, 0f, 0f)).Append(new Vector3(-1f, 0f, 1f)).ToArray();
            mesh.subMeshCount = 2;
            mesh.SetIndices(line ? new[] { own, own + 1 } : new[] { own, own + 1, own },
                line ? MeshTopology.Lines : MeshTopology.Triangles, 1);
            Assert.That(Part(mesh, WingPart.Submesh), Is.Not.Null, "beside the wing");
            mesh.SetIndices(line ? new[] { 0, own } : new[] { own, own + 1, 0 },
                line ? MeshTopology.Lines : MeshTopology.Triangles, 1);
            Assert.That(Part(mesh, WingPart.Submesh), Is.Null);
        }

        // The parts of submeshes stay apart, each with its material.
        [Test]
        public void TrianglesStayInTheirSubmesh()
        {
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Rectangle(24, 12)));
            int[] all = mesh.triangles;
            mesh.subMeshCount = 2;
            mesh.SetTriangles(all.Take(900).ToArray(), 0);
            mesh.SetTriangles(all.Skip(900).ToArray(), 1);
            SmallerPart part = Part(mesh);
            Assert.That(part.triangles.Sum(own => own.Length), Is.InRange(all.Length / 6 - 3, all.Length / 6));
            for (int submesh = 0; submesh < 2; submesh++)
            {
                float whole = Area(mesh, new[] { mesh.GetTriangles(submesh) });
                Assert.That(Area(mesh, new[] { part.triangles[submesh] }), Is.EqualTo(whole).Within(0.1f * whole));
            }
        }

        private T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        private static SmallerPart Part(Mesh mesh, WingPart part = WingPart.WholeMesh) =>
            SmallerPart.Of(mesh, MeshParts.Select(mesh, part, 0, Vector3.zero));

        private static float Area(Mesh mesh, int[][] parts)
        {
            Vector3[] places = mesh.vertices;
            float area = 0f;
            foreach (int[] part in parts)
            {
                for (int k = 0; k < part.Length; k += 3)
                    area += 0.5f * math.cross(places[part[k + 1]] - places[part[k]], places[part[k + 2]] - places[part[k]]).y;
            }

            return area;
        }
    }
}
