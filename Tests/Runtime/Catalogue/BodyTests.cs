using System;
using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class BodyTests
    {
        private const float k_Millimetres = 1000f;

        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        private static SurfaceMesh BodyOf(InsectDefinition species) => species.Body.CreateSurface(k_Millimetres);

        [TestCaseSource(nameof(All))]
        public void EveryEdge_IsSharedByTwoTriangles_ThatRunItBothWays(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);
            var edges = new HashSet<(int From, int To)>();
            for (int corner = 0; corner < body.triangles.Length; corner += 3)
            {
                for (int k = 0; k < 3; k++)
                {
                    (int, int) edge = (body.triangles[corner + k], body.triangles[corner + (k + 1) % 3]);
                    Assert.That(edge.Item1, Is.Not.EqualTo(edge.Item2));
                    Assert.That(edges.Add(edge), Is.True, "each edge is run once each way");
                }
            }

            foreach ((int from, int to) in edges)
            {
                Assert.That(edges.Contains((to, from)), Is.True);
            }
        }

        [TestCaseSource(nameof(All))]
        public void TrunkAndAbdomen_AreTheWholeBody(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);
            var hinge = new Vector3(0f, -1e-3f, -2e-3f);
            SurfaceMesh trunk = species.Body.CreateParts(k_Millimetres, hinge, out SurfaceMesh abdomen);
            Assert.That(abdomen == null, Is.EqualTo(species.Name == "snailfish"), "a fish has no abdomen of its own");
            if (abdomen == null)
            {
                Assert.That(trunk.positions, Is.EqualTo(body.positions));
                return;
            }

            Vector3[] back = Array.ConvertAll(abdomen.positions, position => position + k_Millimetres * hinge);
            for (int vertex = 0; vertex < body.VertexCount; vertex++)
            {
                Vector3 place = vertex < trunk.VertexCount ? trunk.positions[vertex] : back[vertex - trunk.VertexCount];
                Assert.That(Vector3.Distance(place, body.positions[vertex]), Is.LessThan(1e-5f));
            }

            Assert.That(trunk.triangles.Length + abdomen.triangles.Length, Is.EqualTo(body.triangles.Length));
            foreach (SurfaceMesh part in new[] { trunk, abdomen })
            {
                Assert.That(part.triangles, Is.All.GreaterThanOrEqualTo(0).And.All.LessThan(part.VertexCount));
                Assert.That((part.normals.Length, part.uvs.Length, part.colours.Length),
                    Is.EqualTo((part.VertexCount, part.VertexCount, part.VertexCount)));
            }
        }

        [TestCaseSource(nameof(All))]
        public void EveryPart_FacesOutwards(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);
            foreach (List<int> part in BodyPieces.Of(body))
            {
                Assert.That(BodyPieces.Volume(body, part), Is.GreaterThan(0), $"a part at {body.positions[body.triangles[part[0]]]}");
            }
        }

        [TestCaseSource(nameof(All))]
        public void Normals_AreUnitVectors_AndPointOutOfTheTrianglesAround(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);
            var around = new Vector3[body.VertexCount];
            for (int corner = 0; corner < body.triangles.Length; corner += 3)
            {
                Vector3 face = BodyPieces.AreaVector(body, corner);
                for (int k = 0; k < 3; k++)
                {
                    around[body.triangles[corner + k]] += face;
                }
            }

            Assert.That(body.normals, Has.Length.EqualTo(body.VertexCount));
            for (int vertex = 0; vertex < around.Length; vertex++)
            {
                Assert.That(body.normals[vertex].magnitude, Is.EqualTo(1f).Within(1e-4f));
                Assert.That(Vector3.Dot(body.normals[vertex], around[vertex]), Is.GreaterThan(0f), $"at {body.positions[vertex]}");
            }
        }

        [TestCaseSource(nameof(All))]
        public void EveryVertex_HasAFinitePlace_AColour_AndAPlaceInTheTexture(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);

            Assert.That(body.colours, Has.Length.EqualTo(body.VertexCount));
            Assert.That(body.uvs, Has.Length.EqualTo(body.VertexCount));
            for (int vertex = 0; vertex < body.VertexCount; vertex++)
            {
                Assert.That(body.positions[vertex].magnitude, Is.LessThan(200f));
                Assert.That(body.uvs[vertex].x, Is.InRange(0f, 1f));
                Assert.That(body.uvs[vertex].y, Is.InRange(0f, 1f));
            }
        }

        // Dots of the monarch, claspers of the dragonfly: nothing but the abdomen reaches so far back.
        [TestCase("monarch")]
        [TestCase("dragonfly")]
        public void WhatIsOnAnAbdomen_SwingsWithIt(string species)
        {
            InsectDefinition insect = InsectCatalogue.Find(species);
            SurfaceMesh body = BodyOf(insect);
            int behind = 0;
            for (int vertex = 0; vertex < body.VertexCount; vertex++)
            {
                if (body.positions[vertex].z > -10f)
                    continue;
                behind++;
                Assert.That(vertex, Is.GreaterThanOrEqualTo(insect.Body.AbdomenStart), body.positions[vertex].ToString());
            }

            Assert.That(behind, Is.GreaterThan(100));
        }

        [TestCaseSource(nameof(All))]
        public void TheLeftSide_IsTheMirrorImageOfTheRight(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);
            var vertices = new Dictionary<(int X, int Y, int Z), List<int>>();
            for (int vertex = 0; vertex < body.VertexCount; vertex++)
            {
                (int X, int Y, int Z) cell = Cell(body.positions[vertex]);
                if (!vertices.TryGetValue(cell, out List<int> here))
                {
                    vertices.Add(cell, here = new List<int>());
                }

                here.Add(vertex);
            }

            for (int vertex = 0; vertex < body.VertexCount; vertex++)
            {
                List<int> twins = vertices.TryGetValue(Cell(Mirrored(body.positions[vertex])), out List<int> found)
                    ? found
                    : new List<int>();
                Assert.That(twins.Exists(twin => AreTwins(body, vertex, twin)), Is.True, $"{body.positions[vertex]} has no twin");
            }
        }

        [TestCase("monarch", 25f, 32f)]
        [TestCase("swallowtail", 22f, 30f)]
        [TestCase("firefly", 9f, 15f)]
        [TestCase("fishfly", 25f, 40f)]
        [TestCase("painted-lichen-moth", 8f, 12f)]
        [TestCase("snailfish", 60f, 150f)]
        public void ABody_IsAsLongAsTheAnimal_FromHeadToTail(string name, float shortest, float longest)
        {
            float front = float.MinValue, rear = float.MaxValue;
            foreach (Vector3 place in BodyOf(InsectCatalogue.Find(name)).positions)
            {
                if (Math.Abs(place.x) < 1e-4f)
                {
                    front = Math.Max(front, place.z);
                    rear = Math.Min(rear, place.z);
                }
            }

            Assert.That(front - rear, Is.InRange(shortest, longest), "millimetres along the middle line");
            Assert.That(-rear, Is.GreaterThan(front), "the abdomen, or the tail, trails behind the thorax");
        }

        [TestCaseSource(nameof(All))]
        public void ABody_HasAFewThousandTriangles_AndGrowsWithItsUnit(InsectDefinition species)
        {
            SurfaceMesh body = BodyOf(species);
            SurfaceMesh large = species.Body.CreateSurface(10f * k_Millimetres);

            Assert.That(body.TriangleCount, Is.InRange(2000, 6000));
            Assert.That(large.triangles, Is.EqualTo(body.triangles));
            for (int vertex = 0; vertex < body.VertexCount; vertex += 97)
            {
                Assert.That((large.positions[vertex] - 10f * body.positions[vertex]).magnitude, Is.LessThan(1e-3f));
            }
        }

        [Test]
        public void TheMeshes_OfTwoCalls_ShareNoArray()
        {
            SurfaceMesh first = BodyOf(InsectCatalogue.Find("monarch"));
            first.colours[0] = new Color32(1, 2, 3, 4);
            first.uvs[0] = new Vector2(-1f, -1f);
            first.triangles[0] = -1;
            first.normals[0] = default;
            SurfaceMesh second = BodyOf(InsectCatalogue.Find("monarch"));

            Assert.That(second.colours[0].a, Is.EqualTo(255));
            Assert.That(second.uvs[0].x, Is.Not.Negative);
            Assert.That(second.triangles[0], Is.Not.Negative);
            Assert.That(second.normals[0].magnitude, Is.EqualTo(1f).Within(1e-4f));
        }

        private static bool AreTwins(SurfaceMesh body, int vertex, int twin)
        {
            return (Mirrored(body.positions[vertex]) - body.positions[twin]).magnitude < 1e-4f
                && (Mirrored(body.normals[vertex]) - body.normals[twin]).magnitude < 1e-2f
                && (body.uvs[vertex] - body.uvs[twin]).magnitude < 1e-4f
                && body.colours[vertex].Equals(body.colours[twin]);
        }

        private static Vector3 Mirrored(Vector3 vector) => new Vector3(-vector.x, vector.y, vector.z);

        private static (int X, int Y, int Z) Cell(Vector3 place)
        {
            return ((int)Math.Round(1e4 * place.x), (int)Math.Round(1e4 * place.y), (int)Math.Round(1e4 * place.z));
        }
    }
}
