using System;
using System.IO;
using Alate.Cli.Input;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    /// <summary>OBJ files as programs write them.</summary>
    public sealed class ObjReaderTests
    {
        private const string k_Square = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n";

        [Test]
        public void Triangle_KeepsItsCornersInOrder()
        {
            ObjMesh mesh = Read(k_Square + "f 3 1 2\n");

            Assert.That(Corners(mesh), Is.EqualTo(new[] { new Vector3(1, 0, 1), new Vector3(0, 0, 0), new Vector3(1, 0, 0) }));
        }

        [Test]
        public void Polygons_BecomeFans()
        {
            ObjMesh mesh = Read(k_Square + "v -1 0 0.5\nf 1 2 3 4 5\n");

            Assert.That(mesh.Triangles, Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3, 0, 3, 4 }));
        }

        [TestCase("f -4 -3 -2")]
        [TestCase("f 1//1 2//1 3//1")]
        [TestCase("f 1/1 2/1 3/1")]
        [TestCase("f 1/1/1 2/1/1 3/1/1")]
        [TestCase("  f\t1 2 \\\n 3   # the rest is remark")]
        public void Corners_MayBeWrittenInAnyOfTheirForms(string face)
        {
            ObjMesh mesh = Read("mtllib a.mtl\no wing\n" + k_Square + "vt 0 0\nvn 0 1 0\ng side\nusemtl skin\ns off\n" + face + "\r\n");

            Assert.That(Corners(mesh), Is.EqualTo(new[] { new Vector3(0, 0, 0), new Vector3(1, 0, 0), new Vector3(1, 0, 1) }));
        }

        [Test]
        public void VertexWithTwoNormals_IsSplit()
        {
            ObjMesh mesh = Read(k_Square + "vn 0 1 0\nvn 0 -1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 2//2\n");

            Assert.That(mesh.Positions, Has.Length.EqualTo(6));
            Assert.That(mesh.Normals[mesh.Triangles[3]], Is.EqualTo(Vector3.down));
        }

        [Test]
        public void NormalsOfSomeCornersOnly_AreLeftOut() =>
            Assert.That(Read(k_Square + "vn 0 1 0\nf 1//1 2//1 3//1\nf 1 3 4\n").Normals, Is.Null);

        [Test]
        public void VertexColours_AreTaken()
        {
            ObjMesh mesh = Read("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1\nv 0 0 1 2 -1 0.2\nf 1 2 3\n");

            Assert.That(mesh.Colours[0], Is.EqualTo(new Color32(255, 128, 0, 255)));
            Assert.That(mesh.Colours[2], Is.EqualTo(new Color32(255, 0, 51, 255)), "held within their range");
        }

        [TestCase("", "no vertex")]
        [TestCase(k_Square, "no face")]
        [TestCase(k_Square + "l 1 2\n", "only lines or points")]
        [TestCase(k_Square + "f 1 2\n", "line 5: a face has 2 corners")]
        [TestCase(k_Square + "f 1 2 5\n", "line 5: there is no vertex 5")]
        [TestCase(k_Square + "f 1 2 -5\n", "line 5: there is no vertex -5")]
        [TestCase(k_Square + "f 0 1 2\n", "line 5: '0' is no index")]
        [TestCase(k_Square + "f 1 2 x\n", "line 5: 'x' is no index")]
        [TestCase(k_Square + "f 1//1 2//1 3//1\n", "line 5: there is no normal 1")]
        [TestCase(k_Square + "f 1/1/1/1 2 3\n", "line 5")]
        [TestCase("v 0 0\n", "line 1: 'v' has 2 numbers")]
        [TestCase("v 0 0 1e39\n", "line 1: '1e39' is no finite number")]
        [TestCase("v 0 NaN 0\n", "line 1: 'NaN' is no finite number")]
        [TestCase("v 0 0 0\n\n# remark\nv 1,5 0 0\n", "line 4")]
        public void Fault_IsNamedWithItsLine(string text, string said)
        {
            FormatException problem = Assert.Throws<FormatException>(() => Read(text));

            Assert.That(problem.Message, Does.Contain(said));
            Assert.That(problem.Message, Does.Not.Contain("\n"));
        }

        private static ObjMesh Read(string text) => ObjReader.Read(new StringReader(text));

        private static Vector3[] Corners(ObjMesh mesh) => Array.ConvertAll(mesh.Triangles, vertex => mesh.Positions[vertex]);
    }
}
