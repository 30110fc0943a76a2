using System;
using System.IO;
using System.Linq;
using System.Text;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests.Cli
{
    public sealed class ObjReaderTests
    {
        private const string k_Square = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n";

        [Test]
        public void NumbersOfAVertex_AreItsPlaceNormalColourAndTexturePoint_InTheirOrder()
        {
            ObjMesh mesh = Read(
                "v 1 2 3 0.2 0.4 0.6\nv 4 5 6 0 1 0\nv 7 8 10 1 0 0\nvn 1 0 0\nvn 0 0 1\nvt 0.25 0.75\nvt 0.5 1\nf 1/1/1 2/2/2 3/1/1\n");

            Assert.That(mesh.Positions[0] + new UnityEngine.Vector3((float)mesh.Origin.X, (float)mesh.Origin.Y, (float)mesh.Origin.Z),
                Is.EqualTo(new UnityEngine.Vector3(1f, 2f, 3f)));
            Assert.That(mesh.Uvs, Is.EqualTo(
                new[] { new UnityEngine.Vector2(0.25f, 0.75f), new UnityEngine.Vector2(0.5f, 1f), new UnityEngine.Vector2(0.25f, 0.75f) }));
            Assert.That(
                mesh.Normals, Is.EqualTo(new[] { UnityEngine.Vector3.right, UnityEngine.Vector3.forward, UnityEngine.Vector3.right }));
            Assert.That(mesh.Colours[0], Is.EqualTo(new UnityEngine.Color32(51, 102, 153, 255)));
        }

        [Test]
        public void ATriangle_IsReadAsItStands()
        {
            ObjMesh mesh = Read("v 0 0 0\nv 1.5 0 0\nv 0 -2e-1 +1\nf 1 2 3\n");

            Assert.That(mesh.Positions, Is.EqualTo(new[] { Vector3.zero, new Vector3(1.5f, 0f, 0f), new Vector3(0f, -0.2f, 1f) }));
            Assert.That(mesh.Triangles, Is.EqualTo(new[] { 0, 1, 2 }));
            Assert.That(mesh.Normals, Is.Null);
            Assert.That(mesh.Colours, Is.Null);
        }

        [Test]
        public void PointsOfATexture_AreAcrossAndUp_AsTheCornersNameThem()
        {
            ObjMesh mesh = Read("v 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0.25 0.75\nvt 0.5 0.125\nvt 1 0\nf 1/2 2/1 3/3\n");

            Assert.That(mesh.Uvs, Is.EqualTo(new[] { new Vector2(0.5f, 0.125f), new Vector2(0.25f, 0.75f), new Vector2(1f, 0f) }));
        }

        [Test]
        public void AQuad_IsAFanOfTwoTrianglesWoundAlike()
        {
            Assert.That(Read(k_Square + "f 1 2 3 4\n").Triangles, Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3 }));
        }

        [Test]
        public void APolygonOfManyCorners_KeepsItsArea()
        {
            // Unevenly along a circle: the area of a regular polygon is that of many a wrong fan, too.
            const int corners = 17;
            double[] turns = Enumerable.Range(0, corners + 1).Select(k => 2.0 * Math.PI * Math.Pow((double)k / corners, 1.7)).ToArray();
            var text = new StringBuilder();
            foreach (double turn in turns.Take(corners))
                text.AppendLine(FormattableString.Invariant($"v {Math.Cos(turn):R} 0 {Math.Sin(turn):R}"));
            text.AppendLine("f " + string.Join(" ", Enumerable.Range(1, corners)));

            ObjMesh mesh = Read(text.ToString());

            Assert.That(mesh.Triangles, Has.Length.EqualTo(3 * (corners - 2)));
            Assert.That(Area(mesh), Is.EqualTo(turns.Skip(1).Zip(turns, (next, turn) => 0.5 * Math.Sin(next - turn)).Sum()).Within(1e-5));
        }

        [Test]
        public void NegativeIndices_CountBackFromTheLastVertexSoFar()
        {
            ObjMesh mesh = Read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf -3 -2 -1\nv 8 8 8\n");

            Assert.That(mesh.Positions.Select(position => position.x + position.z), Is.EqualTo(new[] { 0f, 1f, 1f }));
        }

        [Test]
        public void SeamOfAPicture_HasVerticesOnBothSides_WhereThePictureIsWanted()
        {
            const string k_Square =
                "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nf 1/1 2/2 3/3\nf 1/5 3/3 4/4\n";

            ObjMesh plain = ObjReader.Read(new StringReader(k_Square)), textured = ObjReader.ReadTextured(new StringReader(k_Square));
            Assert.That(plain.Positions, Has.Length.EqualTo(4));
            Assert.That(textured.Positions, Has.Length.EqualTo(5));
            Assert.That(textured.Uvs, Has.Length.EqualTo(5).And.Contains(new UnityEngine.Vector2(0.5f, 0.5f)));
        }

        [Test]
        public void CornersOfOnePositionAndNormal_AreOneVertex()
        {
            ObjMesh mesh = Read(k_Square + "vn 0 1 0\nvt 0 0\nvt 1 1\nf 1/1/1 2/1/1 3/2/1\nf 1/2/1 3/1/1 4/1/1\n");

            Assert.That(mesh.Positions, Has.Length.EqualTo(4));
            Assert.That(mesh.Normals, Is.All.EqualTo(new Vector3(0f, 1f, 0f)));
        }

        [Test]
        public void CornersOfOnePositionAndTwoNormals_AreTwoVertices()
        {
            ObjMesh mesh = Read(k_Square + "vn 0 1 0\nvn 0 -1 0\nf 1//1 2//1 3//1\nf 3//2 2//2 1//2\n");

            Assert.That(mesh.Positions, Has.Length.EqualTo(6));
            Assert.That(mesh.Positions.Skip(3), Is.EqualTo(mesh.Positions.Take(3).Reverse()));
            Assert.That(mesh.Normals.Select(normal => normal.y), Is.EqualTo(new[] { 1f, 1f, 1f, -1f, -1f, -1f }));
        }

        [Test]
        public void OneCornerWithoutANormal_LeavesAllNormalsToBeComputed()
        {
            Assert.That(Read(k_Square + "vn 0 1 0\nf 1//1 2//1 3//1\nf 1 3 4\n").Normals, Is.Null);
        }

        [Test]
        public void ColoursBehindPositions_AreKept()
        {
            ObjMesh mesh = Read("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 0 1 0 0 0.5\nf 3 2 1\n");

            Assert.That(
                mesh.Colours.Select(colour => (colour.r, colour.g, colour.b)),
                Is.EqualTo(new[] { (0, 0, 128), (0, 255, 0), (255, 0, 0) }));
        }

        [Test]
        public void ColoursBeyondTheirRange_StandAtItsEnds() => Assert.That(
            Read("v 0 0 0 1.5 -1 0.5\nv 1 0 0 0 0 0\nv 0 0 1 1 1 1\nf 1 2 3\n").Colours[0], Is.EqualTo(new Color32(255, 0, 128, 255)));

        // Single precision is enough up to a hundred times the size of the mesh, whichever way that is its largest.
        [TestCase(1, 0.1, 0.2, false)]
        [TestCase(0.1, 1, 0.2, false)]
        [TestCase(0.1, 0.2, 1, false)]
        [TestCase(0.5, 0.1, 0.2, true)]
        public void AMesh_IsCountedFromItsMiddle_WhereItIsAHundredOfItsSizesAway(double x, double y, double z, bool isFar)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                double[] at = [axis == 0 ? 70 : 0, axis == 1 ? -70 : 0, axis == 2 ? 70 : 0];
                string Vertex(double a, double b, double c) =>
                    FormattableString.Invariant($"v {at[0] + a * x} {at[1] + b * y} {at[2] + c * z}\n");
                ObjMesh mesh = Read(Vertex(0.3, 0, 1) + Vertex(1, 0.2, 0.4) + Vertex(0, 1, 0) + "v 1e6 0 0\nf 1 2 3\n");

                Assert.That(mesh.Origin, Is.EqualTo(isFar ? (at[0] + 0.5 * x, at[1] + 0.5 * y, at[2] + 0.5 * z) : (0.0, 0.0, 0.0))
                    .Using<(double X, double Y, double Z)>((a,
                        b) => Math.Abs(a.X - b.X) + Math.Abs(a.Y - b.Y) + Math.Abs(a.Z - b.Z) < 1e-9));
            }
        }

        [Test]
        public void WhatIsNoSurface_IsPassedOver()
        {
            ObjMesh mesh = Read(
                "# a wing\r\nmtllib wing.mtl\r\no Wing\r\ng fore\r\ns off\r\n\r\nv\t0 0 0 # hinge\r\n  v 1  0 0\r\nv 0 0 1\r\nvp 0.5\r\n"
                + "usemtl cuticle\r\nl 1 2\r\np 3\r\nf 1 2 \\\r\n3\r\n");

            Assert.That(mesh.Triangles, Is.EqualTo(new[] { 0, 1, 2 }));
            Assert.That(mesh.Positions[1].x, Is.EqualTo(1f));
        }

        [TestCase("v 0 0\n", 1, "three")]
        [TestCase("v 0 0 0\nv 1 nan 0\n", 2, "'nan'")]
        [TestCase("v 0 0 0\n\n# far\nv 1 1e39 0\n", 4, "'1e39'")]
        [TestCase("v 0 0 Infinity\n", 1, "'Infinity'")]
        [TestCase("v 0 0 0,5\n", 1, "'0,5'")]
        [TestCase(k_Square + "vn 0 1\nf 1 2 3\n", 5, "three")]
        [TestCase(k_Square + "f 1 2\n", 5, "2 corners")]
        [TestCase(k_Square + "f 1 2 5\n", 5, "no vertex 5")]
        [TestCase(k_Square + "f 1 2 -5\n", 5, "no vertex -5")]
        [TestCase(k_Square + "f 0 1 2\n", 5, "'0'")]
        [TestCase(k_Square + "f 1 2 99999999999\n", 5, "'99999999999'")]
        [TestCase(k_Square + "f 1 2 three\n", 5, "'three'")]
        [TestCase(k_Square + "f 1//1 2//1 3//1\n", 5, "no normal 1")]
        [TestCase(k_Square + "f 1/1 2/1 3/1\n", 5, "no texture point 1")]
        [TestCase(k_Square + "f 1/2/3/4 2 3\n", 5, "'1/2/3/4'")]
        [TestCase(k_Square + "f 1 \\\n2 \\\n7\n", 7, "no vertex 7")]
        [TestCase("v 0 0 0\nf 1 2 3\nv 1 0 0\nv 0 0 1\n", 2, "no vertex 2")]
        public void BrokenText_IsRefusedInOneLineWithItsLineNumber(string text, int line, string named)
        {
            FormatException problem = Assert.Throws<FormatException>(() => Read(text));

            Assert.That(problem.Message, Does.StartWith($"line {line}: ").And.Contain(named).And.Not.Contain("\n"));
        }

        [TestCase("", "empty")]
        [TestCase("# nothing\n", "empty")]
        [TestCase(k_Square, "no triangles")]
        [TestCase(k_Square + "l 1 2 3\np 4\n", "only lines or points")]
        public void WithoutAFace_ItSaysThatThereAreNoTriangles(string text, string named)
        {
            FormatException problem = Assert.Throws<FormatException>(() => Read(text));

            Assert.That(problem.Message, Does.Contain(named).And.Not.Contain("\n"));
        }

        [Test]
        public void NumbersAreReadAlike_WhateverTheCulture()
        {
            using (new CommaCulture())
            {
                Assert.That(
                    Read("v 0 0 0\nv 1.5 0 0\nv 0 0 -1\nf 1 2 3\n").Positions,
                    Is.EqualTo(new[] { Vector3.zero, new Vector3(1.5f, 0f, 0f), new Vector3(0f, 0f, -1f) }));
            }
        }

        [Test]
        public void AnyMesh_ComesBackTriangleByTriangle()
        {
            Prop.ForAll(Gen.Choose(0, 1000000).ToArbitrary(), seed => CheckRoundTrip(new Random(seed))).Check(FixedRuns.Of());
        }

        [Test]
        public void AnyText_IsReadOrRefused()
        {
            string[] words = { "v", "vn", "f", "0", "1", "-1", "1/1/1", "1//1", "/", "\\", "#", "\n", "\n", "nan", "1e99", "", "\t", "\0" };
            var texts = Gen.ListOf(Gen.Elements(words)).Select(list => string.Join(" ", list)).ToArbitrary();
            Prop.ForAll(texts, CheckRefusal).Check(FixedRuns.Of());
        }

        private static void CheckRoundTrip(Random random)
        {
            var corners = new Vector3[3 + random.Next(30)];
            var text = new StringBuilder();
            for (int k = 0; k < corners.Length; k++)
            {
                corners[k] = new Vector3(Any(random), Any(random), Any(random));
                text.AppendLine(FormattableString.Invariant($"v {corners[k].x:R} {corners[k].y:R} {corners[k].z:R}"));
            }

            int[] indices = new int[3 * (1 + random.Next(40))];
            for (int k = 0; k < indices.Length; k++)
                indices[k] = random.Next(corners.Length);
            for (int k = 0; k < indices.Length; k += 3)
                text.AppendLine($"f {Named(indices[k])} {Named(indices[k + 1])} {Named(indices[k + 2])}");

            ObjMesh mesh = Read(text.ToString());
            // Meshes far from the origin are read about their centre.
            Vector3 shift = corners[indices[0]] - mesh.Positions[mesh.Triangles[0]];
            float largest = indices.Max(index => corners[index].magnitude);
            for (int k = 0; k < indices.Length; k++)
            {
                Assert.That((mesh.Positions[mesh.Triangles[k]] + shift - corners[indices[k]]).magnitude,
                    Is.LessThanOrEqualTo(1e-6f * largest), $"corner {k}");
            }
            Assert.That(mesh.Positions, Has.Length.EqualTo(indices.Distinct().Count()));

            int Named(int index) => random.Next(2) == 0 ? index + 1 : index - corners.Length;
        }

        private static void CheckRefusal(string text)
        {
            try
            {
                ObjMesh mesh = Read(text);
                Assert.That(mesh.Triangles, Is.Not.Empty);
                Assert.That(mesh.Triangles, Is.All.InRange(0, mesh.Positions.Length - 1));
            }
            catch (FormatException problem)
            {
                Assert.That(problem.Message, Is.Not.Empty.And.Not.Contain("\n"));
            }
        }

        private static float Any(Random random) => (float)((random.NextDouble() - 0.5) * Math.Pow(10.0, random.Next(-12, 12)));

        private static double Area(ObjMesh mesh)
        {
            double area = 0.0;
            for (int k = 0; k < mesh.Triangles.Length; k += 3)
            {
                Vector3 origin = mesh.Positions[mesh.Triangles[k]];
                Vector3 one = mesh.Positions[mesh.Triangles[k + 1]] - origin, other = mesh.Positions[mesh.Triangles[k + 2]] - origin;
                area -= 0.5 * Vector3.Cross(one, other).y;
            }

            return area;
        }

        private static ObjMesh Read(string text) => ObjReader.Read(new StringReader(text));
    }
}
