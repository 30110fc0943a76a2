using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Unity.Tests.Engine;

public sealed class MeshTests : FreshSceneFixture
{
    private Mesh m_Mesh;

    [SetUp]
    public void MakeMesh() => m_Mesh = Meshes.Square();

    [TearDown]
    public void DestroyMesh() => Object.DestroyImmediate(m_Mesh);

    [Test]
    public void Arrays_AreCopies()
    {
        m_Mesh.vertices[0] = Vector3.one;
        Assert.That(m_Mesh.vertices[0], Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void Triangles_MeasureTheBounds()
    {
        Assert.That(m_Mesh.bounds.center, Is.EqualTo(new Vector3(0.5f, 0.5f, 0f)));
        Assert.That(m_Mesh.bounds.size, Is.EqualTo(new Vector3(1f, 1f, 0f)));
    }

    [Test]
    public void RecalculatedNormals_FaceTheViewerOfClockwiseTriangles()
    {
        m_Mesh.RecalculateNormals();
        Assert.That(m_Mesh.normals, Is.All.EqualTo(Vector3.back));
    }

    [Test]
    public void AnArrayOfAnotherLength_IsRefused()
    {
        LogAssert.Expect(LogType.Error, new Regex("same size"));
        m_Mesh.normals = new Vector3[3];
        Assert.That(m_Mesh.normals, Is.Empty);
    }

    [Test]
    public void TooFewVertices_ForTheTriangles_AreRefused()
    {
        LogAssert.Expect(LogType.Error, new Regex("too small"));
        m_Mesh.vertices = new Vector3[3];
        Assert.That(m_Mesh.vertexCount, Is.EqualTo(4));
    }

    [Test]
    public void TrianglesOfVerticesThatAreNot_AreRefused()
    {
        LogAssert.Expect(LogType.Error, new Regex("out of bounds"));
        m_Mesh.triangles = new[] { 0, 1, 4 };
        LogAssert.Expect(LogType.Error, new Regex("multiple of 3"));
        m_Mesh.triangles = new[] { 0, 1 };
    }

    [Test]
    public void AMeshThatIsNotReadable_SaysSo_AndGivesNothing()
    {
        m_Mesh.UploadMeshData(true);
        LogAssert.Expect(LogType.Error, new Regex("isReadable is false"));
        Assert.That(m_Mesh.vertices, Is.Empty);
        using var data = new NativeArray<float3>(4, Allocator.Temp);
        Assert.That(() => m_Mesh.SetVertexBufferData(data, 0, 0, 4), Throws.InvalidOperationException);
    }

    [Test]
    public void Submeshes_KeepTheirOwnTriangles()
    {
        m_Mesh.subMeshCount = 2;
        m_Mesh.SetTriangles(new[] { 0, 1, 2 }, 0);
        m_Mesh.SetTriangles(new[] { 0, 2, 3 }, 1);
        m_Mesh.SetTriangles(new[] { 3, 2, 1, 3, 2, 0 }, 0);

        Assert.That(m_Mesh.GetTriangles(1), Is.EqualTo(new[] { 0, 2, 3 }));
        Assert.That(m_Mesh.GetSubMesh(1).indexStart, Is.EqualTo(6));
        Assert.That(m_Mesh.triangles, Has.Length.EqualTo(9));
    }

    [Test]
    public void Streams_AreInterleavedAsDescribed()
    {
        m_Mesh.Clear();
        m_Mesh.SetVertexBufferParams(
            2,
            new VertexAttributeDescriptor(VertexAttribute.Position),
            new VertexAttributeDescriptor(VertexAttribute.Normal),
            new VertexAttributeDescriptor(VertexAttribute.Color, VertexAttributeFormat.UNorm8, 4, 1),
            new VertexAttributeDescriptor(VertexAttribute.TexCoord0, VertexAttributeFormat.Float16, 2, 1));
        Assert.That(m_Mesh.GetVertexBufferStride(0), Is.EqualTo(24));
        Assert.That(m_Mesh.GetVertexBufferStride(1), Is.EqualTo(8));
        Assert.That(m_Mesh.GetVertexAttributeOffset(VertexAttribute.TexCoord0), Is.EqualTo(4));

        using var data = new NativeArray<Vertex>(2, Allocator.Temp)
        {
            [0] = new Vertex { position = new float3(1f, 2f, 3f), normal = new float3(0f, 1f, 0f) },
            [1] = new Vertex { position = new float3(4f, 5f, 6f), normal = new float3(0f, 0f, 1f) },
        };
        m_Mesh.SetVertexBufferData(data, 0, 0, 2, 0, MeshUpdateFlags.DontRecalculateBounds);
        m_Mesh.uv = new[] { new Vector2(0.5f, 0.25f), Vector2.one };

        Assert.That(m_Mesh.vertices, Is.EqualTo(new[] { new Vector3(1f, 2f, 3f), new Vector3(4f, 5f, 6f) }));
        Assert.That(m_Mesh.normals, Is.EqualTo(new[] { Vector3.up, Vector3.forward }));
        Assert.That(m_Mesh.uv[0], Is.EqualTo(new Vector2(0.5f, 0.25f)));
    }

    [Test]
    public void PartOfAStream_CanBeWritten_AndNothingBeyondIt()
    {
        using var two = new NativeArray<float3>(2, Allocator.Temp) { [0] = new float3(7f), [1] = new float3(8f) };
        m_Mesh.SetVertexBufferData(two, 1, 3, 1);

        Assert.That(m_Mesh.vertices[3], Is.EqualTo(new Vector3(8f, 8f, 8f)));
        Assert.That(m_Mesh.vertices[2], Is.EqualTo(new Vector3(1f, 1f, 0f)));
        Assert.That(() => m_Mesh.SetVertexBufferData(two, 0, 3, 2), Throws.InstanceOf<System.ArgumentException>());
        Assert.That(() => m_Mesh.SetVertexBufferData(two, 1, 0, 2), Throws.InstanceOf<System.ArgumentException>());
        Assert.That(() => m_Mesh.SetVertexBufferData(two, 0, 0, 2, 1), Throws.InstanceOf<System.ArgumentException>());
    }

    [Test]
    public void WritingAStream_AllocatesNothing()
    {
        using var data = new NativeArray<float3>(4, Allocator.Persistent);
        m_Mesh.SetVertexBufferData(data, 0, 0, 4);

        long before = System.GC.GetAllocatedBytesForCurrentThread();
        m_Mesh.SetVertexBufferData(data, 0, 0, 4);

        Assert.That(System.GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    [Test]
    public void ALayoutThatUnityRefuses_IsRefused()
    {
        var sixBytes = new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float16, 3);
        Assert.That(() => m_Mesh.SetVertexBufferParams(1, sixBytes), Throws.ArgumentException);
        Assert.That(() => m_Mesh.SetVertexBufferParams(1, new VertexAttributeDescriptor(), new VertexAttributeDescriptor()),
            Throws.ArgumentException);
    }

    [Test]
    public void ADestroyedMesh_IsNotToBeTouched()
    {
        Object.DestroyImmediate(m_Mesh);
        Assert.That(m_Mesh == null, Is.True);
        Assert.That(() => m_Mesh.vertices, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => m_Mesh.bounds, Throws.TypeOf<MissingReferenceException>());
    }

    [Test]
    public void AFiltersOwnMesh_IsACopy_AndTheSharedOneStays()
    {
        MeshFilter filter = new GameObject("a").AddComponent<MeshFilter>();
        filter.sharedMesh = m_Mesh;
        Mesh own = filter.mesh;

        Assert.That(own, Is.Not.SameAs(m_Mesh).And.SameAs(filter.mesh).And.SameAs(filter.sharedMesh));
        Assert.That(own.name, Is.EqualTo("Square Instance"));
        Object.DestroyImmediate(own);
    }

    private struct Vertex
    {
        public float3 position;
        public float3 normal;
    }
}
