using System;
using System.Runtime.InteropServices;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

public sealed class MeshStreamTests
{
    private Mesh m_Mesh;

    [StructLayout(LayoutKind.Sequential)]
    private struct Vertex
    {
        public float3 position;
        public float3 normal;
    }

    [SetUp]
    public void MakeMesh() => m_Mesh = new Mesh { name = "streams" };

    [TearDown]
    public void DestroyMesh() => Object.DestroyImmediate(m_Mesh);

    [Test]
    public void WhatIsWrittenToAStream_IsReadBackAsAttributes()
    {
        LayOut(3);
        using var vertices = new NativeArray<Vertex>(3, Allocator.Temp);
        using var tangents = new NativeArray<float4>(3, Allocator.Temp);
        NativeArray<Vertex> v = vertices;
        NativeArray<float4> t = tangents;
        for (int i = 0; i < 3; i++)
        {
            v[i] = new Vertex { position = new float3(i, 10 + i, 20 + i), normal = new float3(30 + i, 40 + i, 50 + i) };
            t[i] = new float4(i, 0f, 1f, -1f);
        }

        m_Mesh.SetVertexBufferData(vertices, 0, 0, 3);
        m_Mesh.SetVertexBufferData(tangents, 0, 0, 3, 1);

        Assert.That(m_Mesh.vertices[2], Is.EqualTo(new Vector3(2f, 12f, 22f)));
        Assert.That(m_Mesh.normals[1], Is.EqualTo(new Vector3(31f, 41f, 51f)));
        Assert.That(m_Mesh.tangents[2], Is.EqualTo(new Vector4(2f, 0f, 1f, -1f)));
    }

    [Test]
    public void APartOfAStream_LeavesTheRestAlone()
    {
        LayOut(4);
        m_Mesh.SetVertexBufferData(new[] { new Vertex { position = 7f } }, 0, 2, 1);
        Assert.That(m_Mesh.vertices, Is.EqualTo(new[] { Vector3.zero, Vector3.zero, new Vector3(7f, 7f, 7f), Vector3.zero }));
    }

    [Test]
    public void TheLayout_IsToldAsItWasAsked()
    {
        LayOut(1);
        Assert.That(m_Mesh.vertexBufferCount, Is.EqualTo(2));
        Assert.That(m_Mesh.GetVertexBufferStride(0), Is.EqualTo(24));
        Assert.That(m_Mesh.GetVertexAttributeOffset(VertexAttribute.Normal), Is.EqualTo(12));
        Assert.That(m_Mesh.GetVertexAttributeStream(VertexAttribute.Tangent), Is.EqualTo(1));
        Assert.That(m_Mesh.HasVertexAttribute(VertexAttribute.Color), Is.False);
    }

    [Test]
    public void ANewLayout_KeepsTheValuesThatStay()
    {
        m_Mesh.vertices = new[] { Vector3.one, Vector3.up };
        m_Mesh.uv = new[] { new Vector2(1f, 2f), new Vector2(3f, 4f) };
        LayOut(2);
        Assert.That(m_Mesh.vertices, Is.EqualTo(new[] { Vector3.one, Vector3.up }));
        Assert.That(m_Mesh.uv, Is.Empty);
    }

    [Test]
    public void MoreThanTheStreamHolds_IsRefused()
    {
        LayOut(2);
        Assert.That(() => m_Mesh.SetVertexBufferData(new Vertex[3], 0, 0, 3), Throws.InstanceOf<ArgumentException>());
        Assert.That(() => m_Mesh.SetVertexBufferData(new Vertex[2], 0, 1, 2), Throws.InstanceOf<ArgumentException>());
        Assert.That(() => m_Mesh.SetVertexBufferData(new Vertex[2], 1, 0, 2), Throws.InstanceOf<ArgumentException>());
        Assert.That(() => m_Mesh.SetVertexBufferData(new Vertex[1], 0, 0, 1, 2), Throws.InstanceOf<ArgumentException>());
    }

    [Test]
    public void AMeshThatIsNotReadable_TakesNoStream_UntilItIsReadableAgain()
    {
        LayOut(1);
        m_Mesh.UploadMeshData(true);
        Assert.That(m_Mesh.isReadable, Is.False);
        Assert.That(() => m_Mesh.SetVertexBufferData(new Vertex[1], 0, 0, 1), Throws.InvalidOperationException);

        m_Mesh.SetReadable(true);

        Assert.That(() => m_Mesh.SetVertexBufferData(new Vertex[1], 0, 0, 1), Throws.Nothing);
    }

    [Test]
    public void WritingAStream_AllocatesNothing()
    {
        LayOut(100);
        var data = new NativeArray<Vertex>(100, Allocator.Persistent);
        m_Mesh.SetVertexBufferData(data, 0, 0, 100);
        long before = GC.GetAllocatedBytesForCurrentThread();
        m_Mesh.SetVertexBufferData(data, 0, 0, 100);
        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        data.Dispose();
    }

    [Test]
    public void NativeArraysOfTheRightSize_AreTakenAsAttributes()
    {
        using var points = new NativeArray<float3>(new[] { new float3(1f, 2f, 3f), new float3(4f, 5f, 6f) }, Allocator.Temp);
        m_Mesh.SetVertices(points);
        Assert.That(m_Mesh.vertices[1], Is.EqualTo(new Vector3(4f, 5f, 6f)));
        Assert.That(() => m_Mesh.SetTangents(points), Throws.ArgumentException);
    }

    [Test]
    public void Tangents_RunAlongTheTexture()
    {
        m_Mesh.vertices = new[] { Vector3.zero, new Vector3(0f, 0f, 2f), new Vector3(3f, 0f, 0f) };
        m_Mesh.uv = new[] { new Vector2(0f, 0f), new Vector2(0f, 1f), new Vector2(1f, 0f) };
        m_Mesh.triangles = new[] { 0, 1, 2 };
        m_Mesh.RecalculateNormals();
        m_Mesh.RecalculateTangents();
        Assert.That(m_Mesh.normals[0], Is.EqualTo(Vector3.up));
        Assert.That(m_Mesh.tangents, Is.All.EqualTo(new Vector4(1f, 0f, 0f, -1f)));
    }

    [Test]
    public void ACopy_SharesNothing()
    {
        m_Mesh.vertices = new[] { Vector3.zero, Vector3.right, Vector3.up };
        m_Mesh.triangles = new[] { 0, 1, 2 };
        Mesh copy = Object.Instantiate(m_Mesh);
        m_Mesh.vertices = new Vector3[3];
        Assert.That(copy.vertices[1], Is.EqualTo(Vector3.right));
        Assert.That(copy.triangles, Is.EqualTo(new[] { 0, 1, 2 }));
        Object.DestroyImmediate(copy);
    }

    private void LayOut(int count) => m_Mesh.SetVertexBufferParams(
        count,
        new VertexAttributeDescriptor(VertexAttribute.Position),
        new VertexAttributeDescriptor(VertexAttribute.Normal),
        new VertexAttributeDescriptor(VertexAttribute.Tangent, VertexAttributeFormat.Float32, 4, 1));
}
