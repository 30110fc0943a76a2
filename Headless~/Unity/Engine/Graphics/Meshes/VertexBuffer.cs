using System;
using System.Runtime.InteropServices;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>The vertices of a mesh as bytes in streams.</summary>
internal sealed class VertexBuffer
{
    private byte[][] _streams = [];

    public VertexLayout Layout { get; private set; } = VertexLayout.Empty;

    public int Count { get; private set; }

    public VertexBuffer Clone()
    {
        var clone = new VertexBuffer { Layout = Layout, Count = Count, _streams = new byte[_streams.Length][] };
        for (int i = 0; i < _streams.Length; i++)
            clone._streams[i] = (byte[])_streams[i].Clone();
        return clone;
    }

    public Span<byte> Stream(int stream) => _streams[stream];

    /// <summary>Changes layout and size; attributes that stay keep their values, new ones are zero.</summary>
    public void Rebuild(VertexLayout layout, int count)
    {
        if (ReferenceEquals(layout, Layout) && count == Count)
            return;
        var old = new VertexBuffer { Layout = Layout, Count = Count, _streams = _streams };
        _streams = new byte[layout.StreamCount][];
        for (int i = 0; i < _streams.Length; i++)
            _streams[i] = new byte[layout.Stride(i) * count];
        Layout = layout;
        Count = count;
        Span<float> value = stackalloc float[4];
        foreach (VertexAttributeDescriptor attribute in layout.Attributes)
        {
            if (old.Layout.IndexOf(attribute.attribute) < 0)
                continue;
            for (int vertex = 0; vertex < Math.Min(count, old.Count); vertex++)
            {
                old.Read(attribute.attribute, vertex, value);
                Write(attribute.attribute, vertex, value);
            }
        }
    }

    /// <summary>All values of one attribute as T, a struct of floats; missing components are 0 (w: 1 for colours).</summary>
    public T[] ReadAll<T>(VertexAttribute attribute) where T : unmanaged
    {
        if (Layout.IndexOf(attribute) < 0)
            return [];
        var values = new T[Count];
        Span<float> value = stackalloc float[4];
        for (int vertex = 0; vertex < Count; vertex++)
        {
            value.Clear();
            Read(attribute, vertex, value);
            MemoryMarshal.AsBytes(value)[..Size<T>()].CopyTo(MemoryMarshal.AsBytes(values.AsSpan(vertex, 1)));
        }

        return values;
    }

    public void WriteAll<T>(VertexAttribute attribute, ReadOnlySpan<T> values) where T : unmanaged
    {
        Span<float> value = stackalloc float[4];
        for (int vertex = 0; vertex < values.Length; vertex++)
        {
            value.Clear();
            MemoryMarshal.AsBytes(values.Slice(vertex, 1)).CopyTo(MemoryMarshal.AsBytes(value));
            Write(attribute, vertex, value);
        }
    }

    public void Read(VertexAttribute attribute, int vertex, Span<float> value)
    {
        Span<byte> bytes = Bytes(attribute, vertex, out VertexAttributeDescriptor descriptor);
        int size = VertexFormats.Size(descriptor.format);
        for (int i = 0; i < descriptor.dimension; i++)
            value[i] = VertexFormats.Read(bytes[(i * size)..], descriptor.format);
    }

    public void Write(VertexAttribute attribute, int vertex, ReadOnlySpan<float> value)
    {
        Span<byte> bytes = Bytes(attribute, vertex, out VertexAttributeDescriptor descriptor);
        int size = VertexFormats.Size(descriptor.format);
        for (int i = 0; i < descriptor.dimension; i++)
            VertexFormats.Write(bytes[(i * size)..], descriptor.format, value[i]);
    }

    private static unsafe int Size<T>() where T : unmanaged => sizeof(T);

    private Span<byte> Bytes(VertexAttribute attribute, int vertex, out VertexAttributeDescriptor descriptor)
    {
        int index = Layout.IndexOf(attribute);
        descriptor = Layout.Attributes[index];
        return _streams[descriptor.stream].AsSpan(vertex * Layout.Stride(descriptor.stream) + Layout.Offset(index));
    }
}
