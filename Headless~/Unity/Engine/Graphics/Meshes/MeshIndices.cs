using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>One index buffer and the parts of it that are submeshes.</summary>
internal sealed class MeshIndices
{
    private readonly List<SubMeshDescriptor> _parts = [];
    private int[] _values = [];

    public MeshIndices()
    {
        _parts.Add(default);
    }

    public IndexFormat Format { get; set; }

    public int PartCount => _parts.Count;

    public int Length => _values.Length;

    /// <summary>The largest vertex that a submesh refers to; -1 if none does.</summary>
    public int LargestVertex { get; private set; } = -1;

    public SubMeshDescriptor Part(int index) => _parts[index];

    public ReadOnlySpan<int> Values(int part) => _values.AsSpan(_parts[part].indexStart, _parts[part].indexCount);

    public MeshIndices Clone()
    {
        var clone = new MeshIndices { Format = Format, LargestVertex = LargestVertex, _values = (int[])_values.Clone() };
        clone._parts.Clear();
        clone._parts.AddRange(_parts);
        return clone;
    }

    public void Clear()
    {
        _parts.Clear();
        _parts.Add(default);
        _values = [];
        LargestVertex = -1;
    }

    public void SetPartCount(int count)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        if (count < _parts.Count)
            _parts.RemoveRange(count, _parts.Count - count);
        while (_parts.Count < count)
            _parts.Add(new SubMeshDescriptor(_values.Length, 0));
        Measure();
    }

    /// <summary>Gives one submesh new indices and moves those after it in the buffer.</summary>
    public void Replace(int part, ReadOnlySpan<int> indices, MeshTopology topology, int baseVertex)
    {
        var all = new List<int>(_values.Length + indices.Length);
        var parts = new List<SubMeshDescriptor>(_parts.Count);
        for (int i = 0; i < _parts.Count; i++)
        {
            SubMeshDescriptor descriptor = _parts[i];
            if (i == part)
                descriptor = new SubMeshDescriptor(0, indices.Length, topology) { baseVertex = baseVertex };
            descriptor.indexStart = all.Count;
            parts.Add(descriptor);
            all.AddRange(i == part ? indices : Values(i));
        }

        _values = [.. all];
        _parts.Clear();
        _parts.AddRange(parts);
        Measure();
    }

    public void Resize(int count, IndexFormat format)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        Array.Resize(ref _values, count);
        Format = format;
    }

    public Span<int> Write(int start, int count) => _values.AsSpan(start, count);

    public void SetPart(int index, SubMeshDescriptor descriptor)
    {
        if ((uint)index >= (uint)_parts.Count)
            throw new IndexOutOfRangeException($"Index {index} is out of range: the mesh has {_parts.Count} submeshes (subMeshCount).");
        if (descriptor.indexStart < 0 || descriptor.indexCount < 0 || descriptor.indexStart + descriptor.indexCount > _values.Length)
            throw new ArgumentException($"The submesh {descriptor} reaches beyond the {_values.Length} indices of the mesh.");
        _parts[index] = descriptor;
        Measure();
    }

    public void SetPartBounds(int index, Bounds bounds)
    {
        SubMeshDescriptor descriptor = _parts[index];
        descriptor.bounds = bounds;
        _parts[index] = descriptor;
    }

    /// <summary>Finds the first vertex and the number of vertices of each submesh.</summary>
    public void Measure()
    {
        LargestVertex = -1;
        for (int i = 0; i < _parts.Count; i++)
        {
            SubMeshDescriptor part = _parts[i];
            int least = int.MaxValue;
            int largest = -1;
            foreach (int value in Values(i))
            {
                least = Math.Min(least, value + part.baseVertex);
                largest = Math.Max(largest, value + part.baseVertex);
            }

            part.firstVertex = largest < 0 ? 0 : least;
            part.vertexCount = largest < 0 ? 0 : largest - least + 1;
            _parts[i] = part;
            LargestVertex = Math.Max(LargestVertex, largest);
        }
    }
}
