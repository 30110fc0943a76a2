using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>
/// Vertices and indices with the checks of Unity's: copies in, copies out, nothing out of a mesh that is not readable.
/// What Unity logs as an error and leaves undone is so here.
/// </summary>
public sealed partial class Mesh : Object, ICopyable
{
    private VertexBuffers _vertices = new();
    private bool _readable = true;
    private Bounds _bounds;

    public bool isReadable
    {
        get
        {
            CheckAlive();
            return _readable;
        }
    }

    public Bounds bounds
    {
        get
        {
            CheckAlive();
            return _bounds;
        }
        set
        {
            CheckAlive();
            _bounds = value;
        }
    }

    public int vertexCount
    {
        get
        {
            CheckAlive();
            return _vertices.Count;
        }
    }

    public Vector3[] vertices
    {
        get => Get<Vector3>(VertexAttribute.Position);
        set => SetVertices(value);
    }

    public Vector3[] normals
    {
        get => Get<Vector3>(VertexAttribute.Normal);
        set => SetNormals(value);
    }

    public Vector4[] tangents
    {
        get => Get<Vector4>(VertexAttribute.Tangent);
        set => SetTangents(value);
    }

    public Vector2[] uv
    {
        get => Get<Vector2>(VertexAttribute.TexCoord0);
        set => Set<Vector2>(VertexAttribute.TexCoord0, value);
    }

    public Vector2[] uv2
    {
        get => Get<Vector2>(VertexAttribute.TexCoord1);
        set => Set<Vector2>(VertexAttribute.TexCoord1, value);
    }

    public Color[] colors
    {
        get => Get<Color>(VertexAttribute.Color);
        set => Set<Color>(VertexAttribute.Color, value);
    }

    public Color32[] colors32
    {
        get => Array.ConvertAll(colors, c => (Color32)c);
        set => Set<Color>(VertexAttribute.Color, Array.ConvertAll(value ?? [], c => (Color)c), VertexAttributeFormat.UNorm8);
    }

    public void SetVertices(Vector3[] inVertices) => SetVertices(new List<Vector3>(inVertices ?? []));

    public void SetVertices(List<Vector3> inVertices)
    {
        if (!CanWrite("vertices"))
            return;
        if (inVertices.Count < HighestIndex() + 1)
        {
            Debug.LogError("Mesh.vertices is too small. "
                + "The supplied vertex array has less vertices than are referenced by the triangles array.", this);
            return;
        }

        Resize(inVertices.Count);
        Set<Vector3>(VertexAttribute.Position, [.. inVertices]);
    }

    public void SetNormals(Vector3[] inNormals) => Set<Vector3>(VertexAttribute.Normal, inNormals);
    public void SetNormals(List<Vector3> inNormals) => SetNormals(inNormals.ToArray());
    public void SetTangents(Vector4[] inTangents) => Set<Vector4>(VertexAttribute.Tangent, inTangents);
    public void SetTangents(List<Vector4> inTangents) => SetTangents(inTangents.ToArray());
    public void SetUVs(int channel, Vector2[] uvs) => Set<Vector2>(Channel(channel), uvs);
    public void SetUVs(int channel, List<Vector2> uvs) => SetUVs(channel, uvs.ToArray());

    public void GetVertices(List<Vector3> vertices) => Fill(vertices, this.vertices);
    public void GetNormals(List<Vector3> normals) => Fill(normals, this.normals);
    public void GetTangents(List<Vector4> tangents) => Fill(tangents, this.tangents);
    public void GetUVs(int channel, List<Vector2> uvs) => Fill(uvs, Get<Vector2>(Channel(channel)));

    public void Clear() => Clear(true);

    public void Clear(bool keepVertexLayout)
    {
        if (!CanWrite("data"))
            return;
        IReadOnlyList<VertexAttributeDescriptor> layout = _vertices.Attributes;
        _vertices = new VertexBuffers();
        if (keepVertexLayout)
            _vertices.Layout(0, layout);
        ClearIndices();
        ClearSkin();
        _bounds = default;
    }

    public void RecalculateBounds() => RecalculateBounds(MeshUpdateFlags.Default);

    public void RecalculateBounds(MeshUpdateFlags flags)
    {
        CheckAlive();
        if (_vertices.Count > 0)
            _bounds = BoundsOf(0, _vertices.Count);
    }

    /// <summary>No buffers are uploaded; the mesh may lose what can be read.</summary>
    public void UploadMeshData(bool markNoLongerReadable)
    {
        CheckAlive();
        _readable &= !markNoLongerReadable;
    }

    public void MarkDynamic() => CheckAlive();
    public void MarkModified() => CheckAlive();

    /// <summary>Sets Read/Write as an importer does; the content stays.</summary>
    [Unity.StandIns.StandInExtension]
    public void SetReadable(bool readable) => Alive()._readable = readable;

    Object ICopyable.Copy() => new Mesh
    {
        name = name + "(Clone)",
        _vertices = _vertices.Copy(),
        _readable = _readable,
        _bounds = _bounds,
        _indices = (int[])_indices.Clone(),
        _parts = [.. _parts],
        _indexFormat = _indexFormat,
        _bindposes = (Matrix4x4[])_bindposes.Clone(),
        _boneWeights = (BoneWeight[])_boneWeights.Clone(),
        _shapes = CopyShapes(),
    };

    private protected override void Released()
    {
        _vertices = new VertexBuffers();
        ClearIndices();
        ClearSkin();
    }

    private static VertexAttribute Channel(int channel) => channel is >= 0 and < 8
        ? VertexAttribute.TexCoord0 + channel
        : throw new ArgumentOutOfRangeException(nameof(channel), channel, "UV channels go from 0 to 7.");

    private static void Fill<T>(List<T> list, T[] values)
    {
        list.Clear();
        list.AddRange(values);
    }

    private Bounds BoundsOf(int first, int count)
    {
        if (count == 0 || !_vertices.Has(VertexAttribute.Position))
            return default;
        float[] positions = _vertices.Read(VertexAttribute.Position, 3);
        Vector3 At(int v) => new(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
        var box = new Bounds(At(first), Vector3.zero);
        for (int v = first + 1; v < first + count; v++)
            box.Encapsulate(At(v));
        return box;
    }

    private bool CanRead(string what) => Readable("access", what);

    private bool CanWrite(string what) => Readable("access", what);

    private bool Readable(string act, string what)
    {
        CheckAlive();
        if (!_readable)
        {
            Debug.LogError($"Not allowed to {act} {what} on mesh '{name}' "
                + "(isReadable is false; Read/Write must be enabled in import settings)", this);
        }

        return _readable;
    }
}
