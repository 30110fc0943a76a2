using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class InsectBodyTests
    {
        static SurfaceMesh Monarch => Species.Find("monarch").Body.CreateSurface(1000f);

        [Test]
        public void ABody_IsClosed_AndFacesOutwards()
        {
            var body = Monarch;
            var edges = new HashSet<(int From, int To)>();
            var volume = 0.0;
            for (var corner = 0; corner < body.triangles.Length; corner += 3)
            {
                var a = body.triangles[corner];
                var b = body.triangles[corner + 1];
                var c = body.triangles[corner + 2];
                Assert.That(edges.Add((a, b)) && edges.Add((b, c)) && edges.Add((c, a)), Is.True, "each edge is run once each way");
                volume += Vector3.Dot(body.positions[a], Vector3.Cross(body.positions[b], body.positions[c])) / 6;
            }

            foreach (var (from, to) in edges)
            {
                Assert.That(edges.Contains((to, from)), Is.True);
            }

            Assert.That(volume, Is.InRange(100, 500), "cubic millimetres");
        }

        [Test]
        public void ABody_IsAsLongAsAMonarch_AndTheSameOnBothSides()
        {
            var body = Monarch;
            var trunk = new Bounds(Vector3.zero, Vector3.zero);
            var sideways = 0.0;
            foreach (var position in body.positions)
            {
                sideways += position.x;
                if (Math.Abs(position.y) < 2.6f && position.z < 6.5f)
                {
                    trunk.Encapsulate(position);
                }
            }

            Assert.That(trunk.size.z, Is.InRange(27f, 31f));
            Assert.That(sideways / body.VertexCount, Is.EqualTo(0).Within(1e-3));
            Assert.That(body.TriangleCount, Is.InRange(500, 1500));
            Assert.That(body.colours, Has.Length.EqualTo(body.VertexCount));
            foreach (var normal in body.normals)
            {
                Assert.That(normal.magnitude, Is.EqualTo(1f).Within(1e-4f));
            }
        }
    }
}
