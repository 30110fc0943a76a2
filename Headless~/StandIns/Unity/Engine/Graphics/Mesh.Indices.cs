using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>One index buffer, and the submeshes that are ranges of it.</summary>
public sealed partial class Mesh
{
    private int[] _indices = [];
    private List<SubMeshDescriptor> _parts = [new(0, 0)];
    private IndexFormat _indexFormat;

    public IndexFormat indexFormat
    {
        get
        {
            CheckAlive();
            return _indexFormat;
        }
        set
        {
            CheckAlive();
            _indexFormat = value;
        }
    }

    public int subMeshCount
    {
        get
        {
            CheckAlive();
            return _parts.Count;
        }
        set
        {
            CheckAlive();
            while (_parts.Count < value)
                _parts.Add(new SubMeshDescriptor(_indices.Length, 0));
            _parts.RemoveRange(value, _parts.Count - value);
        }
    }

    public int[] triangles
    {
        get
        {
            if (!CanRead("triangles/indices"))
                return [];
            var all = new List<int>();
            for (int part = 0; part < _parts.Count; part++)
                all.AddRange(Indices(part, true));
            return [.. all];
        }
        set
        {
            subMeshCount = 1;
            SetTriangles(value, 0);
        }
    }

    public MeshTopology GetTopology(int submesh) => Part(submesh).topology;
    public SubMeshDescriptor GetSubMesh(int index) => Part(index);
    public uint GetIndexStart(int submesh) => (uint)Part(submesh).indexStart;
    public uint GetIndexCount(int submesh) => (uint)Part(submesh).indexCount;
    public uint GetBaseVertex(int submesh) => (uint)Part(submesh).baseVertex;

    public int[] GetTriangles(int submesh) => GetTriangles(submesh, true);
    public int[] GetTriangles(int submesh, bool applyBaseVertex) => GetIndices(submesh, applyBaseVertex);
    public void GetTriangles(List<int> triangles, int submesh) => Fill(triangles, GetTriangles(submesh));
    public int[] GetIndices(int submesh) => GetIndices(submesh, true);
    public void GetIndices(List<int> indices, int submesh) => Fill(indices, GetIndices(submesh));

    public int[] GetIndices(int submesh, bool applyBaseVertex)
    {
        _ = Part(submesh);
        return CanRead("triangles/indices") ? Indices(submesh, applyBaseVertex) : [];
    }

    public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles.ToArray(), submesh);
    public void SetTriangles(int[] triangles, int submesh) => SetTriangles(triangles, submesh, true);
    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds) =>
        SetIndices(triangles, MeshTopology.Triangles, submesh, calculateBounds);

    public void SetIndices(int[] indices, MeshTopology topology, int submesh) => SetIndices(indices, topology, submesh, true);

    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds)
    {
        if (!CanWrite("triangles/indices"))
            return;
        _ = Part(submesh);
        indices ??= [];
        if (topology == MeshTopology.Triangles && indices.Length % 3 != 0)
        {
            Debug.LogError("Failed setting triangles. The number of supplied triangle indices must be a multiple of 3; "
                + $"it is {indices.Length}.", this);
            return;
        }

        foreach (int index in indices)
        {
            if ((uint)index >= (uint)_vertices.Count)
            {
                Debug.LogError("Failed setting triangles. Some indices are referencing out of bounds vertices. "
                    + $"IndexCount: {indices.Length}, VertexCount: {_vertices.Count}", this);
                return;
            }

            if (index > ushort.MaxValue && _indexFormat == IndexFormat.UInt16)
            {
                Debug.LogError($"Failed setting triangles. Index {index} does not fit into 16 bits; set Mesh.indexFormat to UInt32.", this);
                return;
            }
        }

        Replace(submesh, indices, topology);
        if (calculateBounds)
            RecalculateBounds();
    }

    public void SetIndexBufferParams(int indexCount, IndexFormat format)
    {
        CheckAlive();
        _indices = new int[indexCount];
        _indexFormat = format;
    }

    public void SetIndexBufferData<T>(
        NativeArray<T> data, int dataStart, int meshBufferStart, int count, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckPart(data.Length, dataStart, count);
        SetIndexBufferData(data.ToArray(), dataStart, meshBufferStart, count, flags);
    }

    public void SetIndexBufferData<T>(
        T[] data, int dataStart, int meshBufferStart, int count, MeshUpdateFlags flags = MeshUpdateFlags.Default) where T : struct
    {
        if (!Alive()._readable)
            throw new InvalidOperationException($"Not allowed to access triangles/indices on mesh '{name}' (isReadable is false)");
        CheckPart(data.Length, dataStart, count);
        CheckPart(_indices.Length, meshBufferStart, count);
        if (System.Runtime.CompilerServices.Unsafe.SizeOf<T>() != (_indexFormat == IndexFormat.UInt16 ? 2 : 4))
            throw new ArgumentException($"Indices of type {typeof(T).Name} do not fit the format {_indexFormat}.");
        for (int i = 0; i < count; i++)
            _indices[meshBufferStart + i] = Convert.ToInt32(data[dataStart + i], System.Globalization.CultureInfo.InvariantCulture);
    }

    public void SetSubMesh(int index, SubMeshDescriptor desc, MeshUpdateFlags flags = MeshUpdateFlags.Default)
    {
        _ = Part(index);
        CheckPart(_indices.Length, desc.indexStart, desc.indexCount);
        _parts[index] = Measured(desc, flags);
        if ((flags & MeshUpdateFlags.DontRecalculateBounds) == 0)
            RecalculateBounds();
    }

    private SubMeshDescriptor Part(int submesh) => (uint)submesh < (uint)Alive()._parts.Count
        ? _parts[submesh]
        : throw new IndexOutOfRangeException($"Failed getting submesh {submesh}: the mesh has {_parts.Count}.");

    private int[] Indices(int submesh, bool applyBaseVertex)
    {
        SubMeshDescriptor part = _parts[submesh];
        int[] indices = _indices[part.indexStart..(part.indexStart + part.indexCount)];
        for (int i = 0; i < indices.Length && applyBaseVertex; i++)
            indices[i] += part.baseVertex;
        return indices;
    }

    private void Replace(int submesh, int[] indices, MeshTopology topology)
    {
        var buffer = new List<int>();
        for (int i = 0; i < _parts.Count; i++)
        {
            int[] own = i == submesh ? indices : Indices(i, false);
            SubMeshDescriptor part = _parts[i];
            part.indexStart = buffer.Count;
            part.indexCount = own.Length;
            if (i == submesh)
                (part.topology, part.baseVertex) = (topology, 0);
            buffer.AddRange(own);
            _parts[i] = part;
        }

        _indices = [.. buffer];
        _parts[submesh] = Measured(_parts[submesh], MeshUpdateFlags.Default);
    }

    private SubMeshDescriptor Measured(SubMeshDescriptor part, MeshUpdateFlags flags)
    {
        if (part.indexCount == 0 || (flags & MeshUpdateFlags.DontRecalculateBounds) != 0)
            return part;
        int first = int.MaxValue, last = 0;
        foreach (int index in _indices.AsSpan(part.indexStart, part.indexCount))
            (first, last) = (Math.Min(first, index), Math.Max(last, index));
        part.firstVertex = first + part.baseVertex;
        part.vertexCount = last - first + 1;
        part.bounds = BoundsOf(part.firstVertex, part.vertexCount);
        return part;
    }

    private int HighestIndex()
    {
        int highest = -1;
        foreach (int index in _indices)
            highest = Math.Max(highest, index);
        return highest;
    }

    private void ClearIndices()
    {
        _indices = [];
        _parts = [new(0, 0)];
    }
}
