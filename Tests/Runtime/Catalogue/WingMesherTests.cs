using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class WingMesherTests
    {
        private static WingDefinition Monarch => InsectCatalogue.Find("monarch").Wings[0];

        [Test]
        public void Grid_SpreadsItsVerticesEvenly_FromLeadingToTrailingEdge()
        {
            WingOutline outline = Monarch.Outline;
            SurfaceMesh grid = WingMesher.Grid(outline, 48, 22);

            Assert.That(grid.VertexCount, Is.EqualTo(49 * 23));
            Assert.That(grid.TriangleCount, Is.EqualTo(2 * 48 * 22));
            Vector3 vertex = grid.positions[12 * 23 + 11];
            Assert.That(vertex.x, Is.EqualTo(0.25f).Within(1e-6f));
            Assert.That(vertex.y, Is.EqualTo(0f));
            Assert.That(vertex.z, Is.EqualTo(0.5 * (outline.LeadingAt(0.25) + outline.TrailingAt(0.25))).Within(1e-6));
        }

        [Test]
        public void Grid_OfAMonarch_HasTheAreaOfItsColumns()
        {
            Assert.That(Area(WingMesher.Grid(Monarch.Outline, 48, 22)), Is.EqualTo(MonarchLandmarks.GridArea(48)).Within(1e-3).Percent);
        }

        [TestCase(50)]
        [TestCase(51)]
        [TestCase(303)]
        [TestCase(605)]
        [TestCase(824)]
        [TestCase(2096)]
        [TestCase(6284)]
        public void Strips_GiveTheExactCount_FillTheOutline_AndFaceUp(int count)
        {
            WingOutline contour = Monarch.Contour;
            SurfaceMesh surface = WingMesher.Strips(contour, count);

            Assert.That(surface.TriangleCount, Is.EqualTo(count));
            Assert.That(SmallestTriangle(surface), Is.GreaterThan(0));
            Assert.That(Area(surface), Is.EqualTo(contour.Area).Within(count < 300 ? 2 : 0.5).Percent);
        }

        [TestCase(303)]
        [TestCase(2096)]
        [TestCase(6284)]
        public void Strips_AreWellShaped(int count)
        {
            List<double> angles = SmallestAngles(WingMesher.Strips(Monarch.Contour, count));

            Assert.That(angles[0], Is.GreaterThan(15), "the worst");
            Assert.That(angles[angles.Count / 20], Is.GreaterThan(38), "19 of 20");
            Assert.That(angles[angles.Count / 2], Is.GreaterThan(44), "the median");
        }

        [TestCase(600)]
        [TestCase(2001)]
        public void AFilledWing_HasTheExactCountOfGoodTriangles_AndTheCornersOfItsBase(int count)
        {
            foreach (InsectDefinition species in InsectCatalogue.All)
            {
                foreach (WingDefinition wing in species.Wings)
                {
                    SurfaceMesh surface = WingMesher.Fill(wing.Contour, wing.Scallops, count, 1f);

                    Assert.That(surface.TriangleCount, Is.EqualTo(count), wing.Name);
                    Assert.That(SmallestTriangle(surface), Is.GreaterThan(0), wing.Name);
                    Assert.That(SmallestAngles(surface)[0], Is.GreaterThan(20), wing.Name);
                    foreach (double edge in new[] { wing.Contour.LeadingAt(0), wing.Contour.TrailingAt(0) })
                    {
                        Assert.That(
                            Array.Exists(surface.positions, p => (p - new Vector3(0f, 0f, (float)edge)).magnitude < 1e-5f), wing.Name);
                    }
                    if (wing.Scallops == null)
                        Assert.That(Area(surface), Is.EqualTo(wing.Contour.Area).Within(2).Percent, wing.Name);
                }
            }
        }

        [TestCase(64)]
        [TestCase(2096)]
        public void Strips_AreOneSheet_WithoutSeamsOrHoles(int count)
        {
            SurfaceMesh surface = WingMesher.Strips(Monarch.Contour, count);

            var edges = new MeshEdges(surface.triangles);
            int border = 0;
            for (int edge = 0; edge < edges.Count; edge++)
            {
                Assert.That(edges.Uses(edge), Is.InRange(1, 2));
                border += edges.Uses(edge) == 1 ? 1 : 0;
            }

            Assert.That(surface.VertexCount - edges.Count + surface.TriangleCount, Is.EqualTo(1), "Euler's number of a disc");
            Assert.That(border, Is.EqualTo(2 * edges.Count - 3 * surface.TriangleCount));
            Assert.That(new HashSet<Vector3>(surface.positions), Has.Count.EqualTo(surface.VertexCount), "no vertex lies on another");
        }

        [Test]
        public void TextureCoordinates_CoverTheWing_SpanwiseAndForward()
        {
            SurfaceMesh surface = WingMesher.Strips(Monarch.Contour, 2096, 3f);

            for (int vertex = 0; vertex < surface.VertexCount; vertex++)
            {
                Assert.That(surface.uvs[vertex].x, Is.EqualTo(surface.positions[vertex].x / 3f).Within(1e-6f));
                Assert.That(surface.uvs[vertex].y, Is.InRange(-1e-6f, 1f + 1e-6f));
                Assert.That(surface.normals[vertex], Is.EqualTo(new Vector3(0f, 1f, 0f)));
            }
        }

        [Test]
        public void ALeftWing_MirrorsTheRight_AndFacesUpToo()
        {
            SurfaceMesh right = Monarch.CreateSurface(WingSide.Right);
            SurfaceMesh left = Monarch.CreateSurface(WingSide.Left);

            Assert.That(SmallestTriangle(left), Is.GreaterThan(0));
            for (int vertex = 0; vertex < right.VertexCount; vertex++)
            {
                var mirrored = new Vector3(-right.positions[vertex].x, right.positions[vertex].y, right.positions[vertex].z);
                Assert.That(left.positions[vertex], Is.EqualTo(mirrored));
            }
        }

        [Test]
        public void TheSameWing_IsMeshedTheSameWay_Twice()
        {
            SurfaceMesh first = Monarch.CreateSurface(WingSide.Right);
            SurfaceMesh second = Monarch.CreateSurface(WingSide.Right);

            Assert.That(second.positions, Is.EqualTo(first.positions));
            Assert.That(second.triangles, Is.EqualTo(first.triangles));
            Assert.That(second.colours, Is.EqualTo(first.colours));
        }

        [Test]
        public void AMesh_CarriesAllOfTheSurface()
        {
            SurfaceMesh surface = Monarch.CreateSurface(WingSide.Right);

            var mesh = surface.ToMesh("Monarch Wing");

            Assert.That(mesh.name, Is.EqualTo("Monarch Wing"));
            Assert.That(mesh.vertexCount, Is.EqualTo(surface.VertexCount));
            Assert.That(mesh.triangles, Is.EqualTo(surface.triangles));
            Assert.That(mesh.colors32, Is.EqualTo(surface.colours));
            Assert.That(mesh.bounds.max.x, Is.EqualTo(0.61f).Within(1e-4f));
            Assert.That(mesh.bounds.min.x, Is.EqualTo(0f).Within(1e-4f));
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        [TestCase(49)]
        [TestCase(-1)]
        [TestCase(1000001)]
        public void AnImpossibleCount_IsRefused(int count)
        {
            Assert.That(() => WingMesher.Strips(Monarch.Contour, count), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        private static double Area(SurfaceMesh surface)
        {
            double area = 0.0;
            for (int t = 0; t < surface.TriangleCount; t++)
            {
                area += SignedArea(surface, t);
            }

            return area;
        }

        private static double SmallestTriangle(SurfaceMesh surface)
        {
            double smallest = double.MaxValue;
            for (int t = 0; t < surface.TriangleCount; t++)
            {
                smallest = Math.Min(smallest, SignedArea(surface, t));
            }

            return smallest;
        }

        private static double SignedArea(SurfaceMesh surface, int triangle)
        {
            Vector3 origin = Corner(surface, triangle, 0);
            return 0.5 * Vector3.Cross(Corner(surface, triangle, 1) - origin, Corner(surface, triangle, 2) - origin).y;
        }

        private static List<double> SmallestAngles(SurfaceMesh surface)
        {
            var angles = new List<double>();
            for (int t = 0; t < surface.TriangleCount; t++)
            {
                double smallest = 180.0;
                for (int c = 0; c < 3; c++)
                {
                    Vector3 origin = Corner(surface, t, c);
                    smallest = Math.Min(
                        smallest, Vector3.Angle(Corner(surface, t, (c + 1) % 3) - origin, Corner(surface, t, (c + 2) % 3) - origin));
                }

                angles.Add(smallest);
            }

            angles.Sort();
            return angles;
        }

        private static Vector3 Corner(SurfaceMesh surface, int triangle, int corner) =>
            surface.positions[surface.triangles[3 * triangle + corner]];
    }
}
