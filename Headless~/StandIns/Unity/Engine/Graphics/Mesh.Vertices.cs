using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Attributes and streams.</summary>
public sealed partial class Mesh
{
    public int vertexBufferCount
    {
        get
        {
            CheckAlive();
            return _vertices.StreamCount;
        }
    }

    public int vertexAttributeCount
    {
        get
        {
            CheckAlive();
            return _vertices.Attributes.Count;
        }
    }

    public bool HasVertexAttribute(VertexAttribute attr) => Alive()._vertices.Has(attr);
    public VertexAttributeDescriptor GetVertexAttribute(int index) => Alive()._vertices.Attributes[index];
    public VertexAttributeDescriptor[] GetVertexAttributes() => [.. Alive()._vertices.Attributes];
    public int GetVertexAttributeDimension(VertexAttribute attr) => Alive()._vertices.Find(attr).dimension;
    public VertexAttributeFormat GetVertexAttributeFormat(VertexAttribute attr) => Alive()._vertices.Find(attr).format;
    public int GetVertexAttributeOffset(VertexAttribute attr) => Alive()._vertices.Offset(attr);
    public int GetVertexAttributeStream(VertexAttribute attr) => Alive()._vertices.Has(attr) ? _vertices.Find(attr).stream : -1;
    public int GetVertexBufferStride(int stream) => Alive()._vertices.Stride(stream);

    /// <summary>The buffer that holds the positions, as the graphics card has it; empty where there are none.</summary>
    [Unity.StandIns.StandInExtension]
    public ReadOnlySpan<byte> PositionBuffer() => HasVertexAttribute(VertexAttribute.Position)
        ? _vertices.Stream(_vertices.Find(VertexAttribute.Position).stream)
        : default;

    public void SetVertexBufferParams(int vertexCount, params VertexAttributeDescriptor[] attributes)
    {
        CheckAlive();
        if (vertexCount < 0)
            throw new ArgumentException($"The number of vertices cannot be negative: {vertexCount}.", nameof(vertexCount));
        var seen = new HashSet<VertexAttribute>();
        int[] strides = new int[VertexBuffers.MaxStreams];
        foreach (VertexAttributeDescriptor a in attributes)
        {
            if (!seen.Add(a.attribute))
                throw new ArgumentException($"Mesh.SetVertexBufferParams: duplicate vertex attribute {a.attribute}.");
            if (a.dimension is < 1 or > 4)
                throw new ArgumentException($"Mesh.SetVertexBufferParams: {a.attribute} has the invalid dimension {a.dimension}.");
            if (a.stream is < 0 or >= VertexBuffers.MaxStreams)
                throw new ArgumentException($"Mesh.SetVertexBufferParams: {a.attribute} has the invalid stream {a.stream}.");
            if (a.Size % 4 != 0)
                throw new ArgumentException($"Mesh.SetVertexBufferParams: {a} has {a.Size} bytes, not a multiple of 4.");
            strides[a.stream] += a.Size;
        }

        _vertices.Layout(vertexCount, attributes);
    }

    public void SetVertexBufferData<T>(
        NativeArray<T> data, int dataStart, int meshBufferStart, int count, int stream = 0, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckPart(data.Length, dataStart, count);
        ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(data.AsReadOnlySpan());
        int size = System.Runtime.CompilerServices.Unsafe.SizeOf<T>();
        SetBuffer(bytes.Slice(dataStart * size, count * size), meshBufferStart * size, stream);
    }

    public void SetVertexBufferData<T>(
        T[] data, int dataStart, int meshBufferStart, int count, int stream = 0, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        CheckPart(data.Length, dataStart, count);
        int size = System.Runtime.CompilerServices.Unsafe.SizeOf<T>();
        SetBuffer(MemoryMarshal.AsBytes(data.AsSpan(dataStart, count)), meshBufferStart * size, stream);
    }

    /// <summary>The bytes of a stream, which Unity only shows through GraphicsBuffer or MeshData.</summary>
    [Unity.StandIns.StandInExtension]
    public byte[] CopyVertexStream(int stream) => Alive()._vertices.Stream(stream).ToArray();

    private void SetBuffer(ReadOnlySpan<byte> bytes, int start, int stream)
    {
        CheckAlive();
        if (!_readable)
        {
            throw new InvalidOperationException($"Not allowed to access vertex data on mesh '{name}' (isReadable is false; "
                + "Read/Write must be enabled in import settings)");
        }

        if ((uint)stream >= (uint)_vertices.StreamCount)
            throw new ArgumentOutOfRangeException(nameof(stream), stream, "The mesh has no such vertex stream.");
        Span<byte> buffer = _vertices.Stream(stream);
        if (start < 0 || start + bytes.Length > buffer.Length)
        {
            throw new ArgumentOutOfRangeException(
                nameof(bytes), $"Bytes {start} to {start + bytes.Length} do not fit into the vertex stream of {buffer.Length} bytes.");
        }

        bytes.CopyTo(buffer[start..]);
    }

    private static void CheckPart(int length, int start, int count)
    {
        if (start < 0 || count < 0 || start + count > length)
        {
            throw new ArgumentOutOfRangeException(
                $"Bad start/count arguments (start:{start} count:{count} length:{length})", (Exception)null);
        }
    }

    private T[] Get<T>(VertexAttribute attribute) where T : unmanaged
    {
        if (!CanRead(attribute.ToString()) || !_vertices.Has(attribute))
            return [];
        float[] values = _vertices.Read(attribute, Components<T>());
        return MemoryMarshal.Cast<float, T>(values).ToArray();
    }

    private void Set<T>(VertexAttribute attribute, T[] values, VertexAttributeFormat format = VertexAttributeFormat.Float32)
        where T : unmanaged
    {
        if (!CanWrite(attribute.ToString()))
            return;
        if (values == null || values.Length == 0)
        {
            if (attribute != VertexAttribute.Position)
                Relayout(attribute, null);
            return;
        }

        if (values.Length != _vertices.Count)
        {
            Debug.LogError($"Mesh.{attribute} is out of bounds. "
                + "The supplied array needs to be the same size as the Mesh.vertices array.", this);
            return;
        }

        if (!_vertices.Has(attribute) || (attribute == VertexAttribute.Color && _vertices.Find(attribute).format != format))
            Relayout(attribute, new VertexAttributeDescriptor(attribute, format, Components<T>()));
        _vertices.Write(attribute, MemoryMarshal.Cast<T, float>(values), Components<T>());
    }

    private void Relayout(VertexAttribute attribute, VertexAttributeDescriptor? now)
    {
        var layout = new List<VertexAttributeDescriptor>(_vertices.Attributes);
        layout.RemoveAll(a => a.attribute == attribute);
        if (now is { } added)
            layout.Add(added);
        layout.Sort((a, b) => a.attribute.CompareTo(b.attribute));
        _vertices.Layout(_vertices.Count, layout);
    }

    private void Resize(int count)
    {
        if (count != _vertices.Count)
            _vertices.Layout(count, _vertices.Attributes);
    }

    private static unsafe int Components<T>() where T : unmanaged => sizeof(T) / sizeof(float);

    private Mesh Alive()
    {
        CheckAlive();
        return this;
    }
}
