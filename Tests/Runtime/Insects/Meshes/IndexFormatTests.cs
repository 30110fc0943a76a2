using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Tests
{
    /// <summary>Bits of the indices of meshes: 16 up to 65,535 vertices, 32 beyond.</summary>
    public sealed class IndexFormatTests
    {
        [TestCase(65535, IndexFormat.UInt16)]
        [TestCase(65536, IndexFormat.UInt32)]
        [TestCase(70000, IndexFormat.UInt32)]
        public void AMesh_CountsToItsLastVertex(int vertices, IndexFormat format)
        {
            var surface = new SurfaceMesh
            {
                positions = Enumerable.Range(0, vertices).Select(k => new Vector3(k, k % 7, k % 5)).ToArray(),
                normals = Enumerable.Repeat(Vector3.up, vertices).ToArray(),
                triangles = new[] { 0, 1, 2, 3, vertices - 2, vertices - 1 },
            };
            Mesh mesh = surface.ToMesh("large"),
                living = DeformableMesh.Build(mesh, Enumerable.Range(0, vertices).Reverse().ToArray(), false, moves: false);
            Mesh rest = WingMeshCut.Without(mesh, (_, triangle) => triangle == 0);

            Assert.That((mesh.indexFormat, living.indexFormat, rest.indexFormat), Is.EqualTo((format, format, format)));
            Assert.That(mesh.triangles, Is.EqualTo(surface.triangles));
            Assert.That(living.triangles, Is.EqualTo(surface.triangles.Select(corner => vertices - 1 - corner)));
            Assert.That(rest.triangles, Is.EqualTo(new[] { 3, vertices - 2, vertices - 1 }));
            foreach (Mesh made in new[] { mesh, living, rest })
                Object.DestroyImmediate(made);
        }
    }
}
