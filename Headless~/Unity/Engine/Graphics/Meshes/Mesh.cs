using System;
using System.Collections.Generic;
using Unity.StandIns;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Vertex streams and indices with Unity's rules: copies in, copies out, nothing in or out of a mesh that is not readable.</summary>
public sealed partial class Mesh : Object
{
    private VertexBuffer _buffer = new();
    private MeshIndices _indices = new();
    private Bounds _bounds;
    private bool _readable = true;

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
            return _buffer.Count;
        }
    }

    public void Clear() => Clear(true);

    public void Clear(bool keepVertexLayout)
    {
        CheckAlive();
        _buffer.Rebuild(keepVertexLayout ? _buffer.Layout : VertexLayout.Empty, 0);
        _indices.Clear();
        _bounds = default;
        _readable = true;
    }

    public void MarkDynamic() => CheckAlive();

    public void MarkModified() => CheckAlive();

    public void UploadMeshData(bool markNoLongerReadable)
    {
        CheckAlive();
        _readable &= !markNoLongerReadable;
    }

    /// <summary>Sets Read/Write as an importer does: the data stay, and only the access to them changes.</summary>
    [StandInExtension]
    public static void SetReadable(Mesh mesh, bool readable)
    {
        mesh.CheckAlive();
        mesh._readable = readable;
    }

    internal Mesh CloneData()
    {
        CheckAlive();
        return new Mesh
        {
            _buffer = _buffer.Clone(),
            _indices = _indices.Clone(),
            _bounds = _bounds,
            _readable = _readable,
        };
    }

    /// <summary>Whether the content may be used; says so in the log if it may not.</summary>
    private bool CanAccess(string what)
    {
        CheckAlive();
        if (!_readable)
            Debug.LogError(NotReadable(what), this);
        return _readable;
    }

    private void CheckReadable(string what)
    {
        CheckAlive();
        if (!_readable)
            throw new InvalidOperationException(NotReadable(what));
    }

    private string NotReadable(string what) =>
        $"Not allowed to access {what} on mesh '{name}' (isReadable is false; Read/Write must be enabled in import settings)";

    private static void Fill<T>(List<T> list, T[] values)
    {
        ArgumentNullException.ThrowIfNull(list);
        list.Clear();
        list.AddRange(values);
    }
}
