using System.Collections;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>A device that reads no signed bytes shows living meshes of floats.</summary>
    public sealed class PlainDeviceTests : FlockFixture
    {
        [TearDown]
        public void LeaveTheDevice() => PlainDevice.IsInUse = false;

        [UnityTest]
        public IEnumerator NormalsAndTangents_AreFloatsThatTurnWithTheWing()
        {
            PlainDevice.IsInUse = true;
            Mesh mesh = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            mesh.tangents = System.Array.ConvertAll(mesh.vertices, _ => new Vector4(1f, 0f, 0f, -1f));
            InsectWings insect = Hatch(made => Filter(made, 0).sharedMesh = mesh);
            yield return Frames(23);

            Mesh shown = Shown(insect, 0);
            Assert.That(shown.GetVertexAttributeFormat(VertexAttribute.Normal), Is.EqualTo(VertexAttributeFormat.Float32));
            Assert.That(shown.GetVertexAttributeFormat(VertexAttribute.Tangent), Is.EqualTo(VertexAttributeFormat.Float32));
            float turned = 0f;
            for (int v = 0; v < shown.vertexCount; v++)
            {
                Assert.That(shown.normals[v].magnitude, Is.EqualTo(1f).Within(1e-3f));
                Assert.That(((Vector3)shown.tangents[v]).magnitude, Is.EqualTo(1f).Within(1e-3f));
                Assert.That(Vector3.Dot(shown.normals[v], shown.tangents[v]), Is.EqualTo(0f).Within(1e-2f));
                turned = Mathf.Max(turned, Vector3.Angle(shown.normals[v], Vector3.up));
            }

            Assert.That(turned, Is.GreaterThan(3f));
        }
    }
}
