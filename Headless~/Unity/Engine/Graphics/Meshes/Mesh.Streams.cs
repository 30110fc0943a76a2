using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public int vertexAttributeCount => _buffer.Layout.Attributes.Length;

    public int vertexBufferCount => _buffer.Layout.StreamCount;

    public bool HasVertexAttribute(VertexAttribute attr) => _buffer.Layout.IndexOf(attr) >= 0;

    public VertexAttributeDescriptor GetVertexAttribute(int index) => _buffer.Layout.Attributes[index];

    public VertexAttributeDescriptor[] GetVertexAttributes() => [.. _buffer.Layout.Attributes];

    public int GetVertexAttributes(List<VertexAttributeDescriptor> attributes)
    {
        Fill(attributes, _buffer.Layout.Attributes);
        return attributes.Count;
    }

    public int GetVertexAttributeDimension(VertexAttribute attr) => Described(attr)?.dimension ?? 0;

    public VertexAttributeFormat GetVertexAttributeFormat(VertexAttribute attr) =>
        Described(attr)?.format ?? VertexAttributeFormat.Float32;

    public int GetVertexAttributeStream(VertexAttribute attr) => Described(attr)?.stream ?? -1;

    public int GetVertexAttributeOffset(VertexAttribute attr)
    {
        int index = _buffer.Layout.IndexOf(attr);
        return index < 0 ? -1 : _buffer.Layout.Offset(index);
    }

    public int GetVertexBufferStride(int stream) =>
        (uint)stream < (uint)_buffer.Layout.StreamCount ? _buffer.Layout.Stride(stream) : 0;

    public void SetVertexBufferParams(int vertexCount, params VertexAttributeDescriptor[] attributes)
    {
        CheckReadable("vertex data");
        ArgumentOutOfRangeException.ThrowIfNegative(vertexCount);
        _buffer.Rebuild(new VertexLayout(attributes.Length == 0 ? [new VertexAttributeDescriptor()] : attributes), vertexCount);
    }

    public void SetVertexBufferData<T>(
        NativeArray<T> data,
        int dataStart,
        int meshBufferStart,
        int count,
        int stream = 0,
        MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckReadable("vertex data");
        CheckRange(dataStart, meshBufferStart, count, data.Length);
        SetStream(MemoryMarshal.AsBytes(data.AsReadOnlySpan().Slice(dataStart, count)), Unsafe.SizeOf<T>(), meshBufferStart, stream);
    }

    public void SetVertexBufferData<T>(
        T[] data,
        int dataStart,
        int meshBufferStart,
        int count,
        int stream = 0,
        MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckReadable("vertex data");
        CheckRange(dataStart, meshBufferStart, count, data.Length);
        SetStream(MemoryMarshal.AsBytes(data.AsSpan(dataStart, count)), Unsafe.SizeOf<T>(), meshBufferStart, stream);
    }

    /// <summary>As in Unity the unit of the starts and the count is T; the bytes must lie in the stream.</summary>
    private void SetStream(ReadOnlySpan<byte> bytes, int size, int start, int stream)
    {
        if ((uint)stream >= (uint)_buffer.Layout.StreamCount)
            throw new ArgumentException($"The mesh has no vertex stream {stream}, only {_buffer.Layout.StreamCount} streams.");
        Span<byte> target = _buffer.Stream(stream);
        if ((long)start * size + bytes.Length > target.Length)
        {
            throw new ArgumentException(
                $"The data reach beyond vertex stream {stream}: {bytes.Length} bytes from {(long)start * size}, the stream has {target.Length}.");
        }

        bytes.CopyTo(target[(start * size)..]);
    }

    private static void CheckRange(int dataStart, int meshBufferStart, int count, int length)
    {
        if (dataStart < 0 || meshBufferStart < 0 || count < 0 || dataStart + count > length)
        {
            throw new ArgumentOutOfRangeException(
                $"Bad start/count arguments (dataStart:{dataStart} meshBufferStart:{meshBufferStart} count:{count})");
        }
    }

    private VertexAttributeDescriptor? Described(VertexAttribute attribute)
    {
        int index = _buffer.Layout.IndexOf(attribute);
        return index < 0 ? null : _buffer.Layout.Attributes[index];
    }
}
