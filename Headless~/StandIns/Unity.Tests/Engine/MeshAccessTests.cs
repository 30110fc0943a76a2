using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

/// <summary>Faults that Unity writes into the log instead of throwing.</summary>
public sealed class MeshAccessTests
{
    private Mesh m_Mesh;

    [SetUp]
    public void MakeTriangle() => m_Mesh = new Mesh
    {
        name = "triangle",
        vertices = new[] { Vector3.zero, Vector3.right, Vector3.up },
        triangles = new[] { 0, 1, 2 },
    };

    [TearDown]
    public void DestroyMesh() => Object.DestroyImmediate(m_Mesh);

    [Test]
    public void AMeshThatIsNotReadable_GivesNothing_AndSaysSo()
    {
        m_Mesh.SetReadable(false);
        LogAssert.Expect(LogType.Error, new Regex("triangle.*Read/Write"));
        Assert.That(m_Mesh.vertices, Is.Empty);
        LogAssert.Expect(LogType.Error, new Regex("triangle.*Read/Write"));
        Assert.That(m_Mesh.triangles, Is.Empty);
    }

    [Test]
    public void WhatNeedsNoContent_IsThereWithoutIt()
    {
        m_Mesh.SetReadable(false);
        Assert.That(m_Mesh.vertexCount, Is.EqualTo(3));
        Assert.That(m_Mesh.subMeshCount, Is.EqualTo(1));
        Assert.That(m_Mesh.bounds.max, Is.EqualTo(new Vector3(1f, 1f, 0f)));
    }

    [Test]
    public void FewerVerticesThanTheTrianglesNeed_AreRefused()
    {
        LogAssert.Expect(LogType.Error, new Regex("too small"));
        m_Mesh.vertices = new Vector3[2];
        Assert.That(m_Mesh.vertexCount, Is.EqualTo(3));
    }

    [Test]
    public void AnAttributeOfAnotherLength_IsRefused()
    {
        LogAssert.Expect(LogType.Error, new Regex("out of bounds"));
        m_Mesh.normals = new Vector3[2];
        Assert.That(m_Mesh.normals, Is.Empty);
    }

    [Test]
    public void ATriangleThatRefersToNoVertex_IsRefused()
    {
        LogAssert.Expect(LogType.Error, new Regex("out of bounds"));
        m_Mesh.triangles = new[] { 0, 1, 3 };
    }

    [Test]
    public void SubmeshesShareOneBuffer_EachWithItsPart()
    {
        m_Mesh.indexFormat = IndexFormat.UInt32;
        m_Mesh.subMeshCount = 2;
        m_Mesh.SetTriangles(new[] { 2, 1, 0, 0, 1, 2 }, 1);
        Assert.That(m_Mesh.triangles, Is.EqualTo(new[] { 0, 1, 2, 2, 1, 0, 0, 1, 2 }));
        Assert.That(m_Mesh.GetSubMesh(1).indexStart, Is.EqualTo(3));
        Assert.That(m_Mesh.GetSubMesh(1).indexCount, Is.EqualTo(6));
        Assert.That(m_Mesh.GetTriangles(0), Is.EqualTo(new[] { 0, 1, 2 }));
    }
}
