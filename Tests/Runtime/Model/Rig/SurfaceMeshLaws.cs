using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Meshes made of surfaces, and their mirror images.</summary>
    public sealed class SurfaceMeshLaws
    {
        private static SurfaceMesh Made() => new SurfaceMesh
        {
            name = "triangle",
            positions = new[] { new Vector3(1f, 2f, 3f), new Vector3(4f, 5f, 6f), new Vector3(-1f, 0f, 2f) },
            normals = new[] { new Vector3(0.6f, 0.8f, 0f), Vector3.up, Vector3.right },
            tangents = new[] { new Vector4(0.1f, 0.2f, 0.3f, 1f), new Vector4(0.4f, 0.5f, 0.6f, -1f), new Vector4(0.7f, 0.8f, 0.9f, 1f) },
            uvs = new[] { new Vector2(0.1f, 0.2f), new Vector2(0.3f, 0.4f), new Vector2(0.5f, 0.6f) },
            colours = new[] { new Color32(1, 2, 3, 4), new Color32(5, 6, 7, 8), new Color32(9, 10, 11, 12) },
            triangles = new[] { 0, 1, 2 },
        };

        [Test]
        public void AMesh_HasAllThatItsSurfaceHas()
        {
            SurfaceMesh surface = Made();
            var mesh = surface.ToMesh("made");

            Assert.That((mesh.name, mesh.vertexCount, mesh.isReadable), Is.EqualTo(("made", 3, true)));
            Assert.That(mesh.vertices, Is.EqualTo(surface.positions));
            Assert.That(mesh.normals, Is.EqualTo(surface.normals));
            Assert.That(mesh.tangents, Is.EqualTo(surface.tangents));
            Assert.That(mesh.uv, Is.EqualTo(surface.uvs));
            Assert.That(mesh.colors32, Is.EqualTo(surface.colours));
            Assert.That(mesh.triangles, Is.EqualTo(surface.triangles));
            Assert.That((mesh.bounds.min, mesh.bounds.max), Is.EqualTo((new Vector3(-1f, 0f, 2f), new Vector3(4f, 5f, 6f))));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void AMirrorImage_IsReflectedInThePlaneOfYAndZ_AndItsOwnIsTheFirst()
        {
            SurfaceMesh surface = Made(), mirrored = surface.Mirrored(), back = mirrored.Mirrored();

            Assert.That(mirrored.positions[1], Is.EqualTo(new Vector3(-4f, 5f, 6f)));
            Assert.That(mirrored.normals[0], Is.EqualTo(new Vector3(-0.6f, 0.8f, 0f)));
            Assert.That(mirrored.tangents[1], Is.EqualTo(new Vector4(-0.4f, 0.5f, 0.6f, 1f)), "the hand turns too");
            Assert.That(mirrored.triangles, Is.EqualTo(new[] { 0, 2, 1 }));
            Assert.That((mirrored.uvs[2], mirrored.colours[2]), Is.EqualTo((surface.uvs[2], surface.colours[2])));
            Assert.That(mirrored.uvs, Is.Not.SameAs(surface.uvs));
            Assert.That(back.positions, Is.EqualTo(surface.positions));
            Assert.That(back.tangents, Is.EqualTo(surface.tangents));
            Assert.That(back.triangles, Is.EqualTo(surface.triangles));
        }
    }
}
