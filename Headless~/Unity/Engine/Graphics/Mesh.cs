using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Vertex and index arrays with the checks of Unity's: copies in, copies out, nothing out of a mesh that is not readable.</summary>
public sealed class Mesh : Object
{
    private readonly List<int[]> _submeshes = [[]];
    private Vector3[] _vertices = [];
    private Vector3[] _normals = [];
    private Vector4[] _tangents = [];
    private Vector2[] _uv = [];
    private Color32[] _colors = [];

    public bool isReadable { get; private set; } = true;

    public IndexFormat indexFormat { get; set; }

    public Bounds bounds { get; set; }

    public int vertexCount => _vertices.Length;

    public Vector3[] vertices
    {
        get => Copy(_vertices);
        set => _vertices = Copy(value);
    }

    public Vector3[] normals
    {
        get => Copy(_normals);
        set => _normals = PerVertex(value);
    }

    public Vector4[] tangents
    {
        get => Copy(_tangents);
        set => _tangents = PerVertex(value);
    }

    public Vector2[] uv
    {
        get => Copy(_uv);
        set => _uv = PerVertex(value);
    }

    public Color32[] colors32
    {
        get => Copy(_colors);
        set => _colors = PerVertex(value);
    }

    public int subMeshCount
    {
        get => _submeshes.Count;
        set
        {
            while (_submeshes.Count < value)
                _submeshes.Add([]);
            _submeshes.RemoveRange(value, _submeshes.Count - value);
        }
    }

    public int[] triangles
    {
        get
        {
            var all = new List<int>();
            foreach (int[] part in _submeshes)
                all.AddRange(part);
            return Copy(all.ToArray());
        }
        set
        {
            subMeshCount = 1;
            SetTriangles(value, 0);
        }
    }

    public MeshTopology GetTopology(int submesh)
    {
        _ = _submeshes[submesh];
        return MeshTopology.Triangles;
    }

    public int[] GetTriangles(int submesh) => Copy(_submeshes[submesh]);

    public void SetTriangles(int[] triangles, int submesh)
    {
        CheckReadable();
        if (triangles.Length % 3 != 0)
            throw new ArgumentException("The number of supplied triangle indices must be a multiple of 3.");
        foreach (int index in triangles)
        {
            if ((uint)index >= (uint)_vertices.Length)
                throw new ArgumentException($"Triangle index {index} is out of bounds: {_vertices.Length} vertices.");
        }

        _submeshes[submesh] = (int[])triangles.Clone();
    }

    public void RecalculateBounds()
    {
        if (_vertices.Length == 0)
            return;
        var box = new Bounds(_vertices[0], Vector3.zero);
        foreach (Vector3 vertex in _vertices)
            box.Encapsulate(vertex);
        bounds = box;
    }

    public void UploadMeshData(bool markNoLongerReadable) => isReadable &= !markNoLongerReadable;

    private T[] Copy<T>(T[] array)
    {
        CheckReadable();
        return (T[])array.Clone();
    }

    private T[] PerVertex<T>(T[] array)
    {
        if (array == null)
            return [];
        if (array.Length != 0 && array.Length != _vertices.Length)
            throw new ArgumentException($"The array has {array.Length} entries, the mesh {_vertices.Length} vertices.");
        return Copy(array);
    }

    private void CheckReadable()
    {
        CheckAlive();
        if (!isReadable)
            throw new InvalidOperationException($"Not allowed to access vertices or indices of mesh '{name}': it is not readable.");
    }
}
