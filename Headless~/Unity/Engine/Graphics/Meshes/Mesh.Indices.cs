using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public IndexFormat indexFormat
    {
        get => _indices.Format;
        set
        {
            CheckAlive();
            if (value != _indices.Format)
                _indices.Format = value;
        }
    }

    public int subMeshCount
    {
        get
        {
            CheckAlive();
            return _indices.PartCount;
        }
        set
        {
            CheckAlive();
            _indices.SetPartCount(value);
        }
    }

    public MeshTopology GetTopology(int submesh) => GetSubMesh(submesh).topology;

    public uint GetIndexStart(int submesh) => (uint)GetSubMesh(submesh).indexStart;

    public uint GetIndexCount(int submesh) => (uint)GetSubMesh(submesh).indexCount;

    public uint GetBaseVertex(int submesh) => (uint)GetSubMesh(submesh).baseVertex;

    public SubMeshDescriptor GetSubMesh(int index)
    {
        CheckAlive();
        if ((uint)index >= (uint)_indices.PartCount)
            throw new IndexOutOfRangeException($"Specified sub mesh index {index} is out of range: the mesh has {_indices.PartCount}.");
        return _indices.Part(index);
    }

    public void SetSubMesh(int index, SubMeshDescriptor desc, MeshUpdateFlags flags = MeshUpdateFlags.Default)
    {
        CheckAlive();
        _indices.SetPart(index, desc);
        if ((flags & MeshUpdateFlags.DontValidateIndices) == 0 && _indices.LargestVertex >= vertexCount)
            throw new ArgumentException($"Submesh {index} refers to vertex {_indices.LargestVertex}; the mesh has {vertexCount}.");
        if ((flags & MeshUpdateFlags.DontRecalculateBounds) == 0)
            RecalculateBounds();
    }

    public int[] GetIndices(int submesh) => GetIndices(submesh, true);
    public int[] GetIndices(int submesh, bool applyBaseVertex) =>
        CanAccessPart("indices", submesh) ? Absolute(submesh, applyBaseVertex) : [];
    public void GetIndices(List<int> indices, int submesh) => Fill(indices, GetIndices(submesh));
    public void GetIndices(List<int> indices, int submesh, bool applyBaseVertex) => Fill(indices, GetIndices(submesh, applyBaseVertex));

    public void SetIndices(int[] indices, MeshTopology topology, int submesh) => SetIndices(indices, topology, submesh, true, 0);
    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds) =>
        SetIndices(indices, topology, submesh, calculateBounds, 0);
    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds, int baseVertex) =>
        SetPart("indices", indices, topology, submesh, calculateBounds, baseVertex);
    public void SetIndices(List<int> indices, MeshTopology topology, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        SetPart("indices", CollectionsMarshal.AsSpan(indices), topology, submesh, calculateBounds, baseVertex);

    public void SetIndexBufferParams(int indexCount, IndexFormat format)
    {
        CheckReadable("index data");
        _indices.Resize(indexCount, format);
    }

    public void SetIndexBufferData<T>(
        NativeArray<T> data,
        int dataStart,
        int meshBufferStart,
        int count,
        MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckReadable("index data");
        CheckRange(dataStart, meshBufferStart, count, data.Length);
        CopyIndices<T>(data.AsReadOnlySpan().Slice(dataStart, count), meshBufferStart);
    }

    public void SetIndexBufferData<T>(
        T[] data,
        int dataStart,
        int meshBufferStart,
        int count,
        MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckReadable("index data");
        CheckRange(dataStart, meshBufferStart, count, data.Length);
        CopyIndices<T>(data.AsSpan(dataStart, count), meshBufferStart);
    }

    private void CopyIndices<T>(ReadOnlySpan<T> data, int start) where T : struct
    {
        int size = _indices.Format == IndexFormat.UInt16 ? 2 : 4;
        if (Unsafe.SizeOf<T>() != size)
            throw new ArgumentException($"The indices of this mesh have {size} bytes, those of the data {Unsafe.SizeOf<T>()}.");
        if (start + data.Length > _indices.Length)
            throw new ArgumentException($"The indices reach beyond the buffer of {_indices.Length}: {data.Length} from {start}.");
        Span<int> target = _indices.Write(start, data.Length);
        ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(data);
        for (int i = 0; i < target.Length; i++)
            target[i] = size == 2 ? MemoryMarshal.Read<ushort>(bytes[(2 * i)..]) : MemoryMarshal.Read<int>(bytes[(4 * i)..]);
        _indices.Measure();
    }
}
