using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>A mesh's vertices as they lie in memory: up to four interleaved streams.</summary>
internal sealed class VertexBuffers
{
    public const int MaxStreams = 4;

    private readonly byte[][] _streams = new byte[MaxStreams][];
    private readonly int[] _strides = new int[MaxStreams];
    private VertexAttributeDescriptor[] _attributes = [];

    public int Count { get; private set; }

    public IReadOnlyList<VertexAttributeDescriptor> Attributes => _attributes;

    public int StreamCount
    {
        get
        {
            int count = 0;
            foreach (VertexAttributeDescriptor a in _attributes)
                count = Math.Max(count, a.stream + 1);
            return count;
        }
    }

    public int Stride(int stream) => _strides[stream];

    public Span<byte> Stream(int stream) => _streams[stream];

    public bool Has(VertexAttribute attribute) => Array.Exists(_attributes, a => a.attribute == attribute);

    public VertexAttributeDescriptor Find(VertexAttribute attribute) => Array.Find(_attributes, a => a.attribute == attribute);

    public int Offset(VertexAttribute attribute)
    {
        VertexAttributeDescriptor sought = Find(attribute);
        int offset = 0;
        foreach (VertexAttributeDescriptor a in _attributes)
        {
            if (a.attribute == attribute)
                return offset;
            if (a.stream == sought.stream)
                offset += a.Size;
        }

        return -1;
    }

    /// <summary>Takes a new layout; what both layouts have in the same format is kept, the rest is zero.</summary>
    public void Layout(int count, IReadOnlyList<VertexAttributeDescriptor> attributes)
    {
        var before = new VertexBuffers { Count = Count, _attributes = _attributes };
        Array.Copy(_streams, before._streams, MaxStreams);
        Array.Copy(_strides, before._strides, MaxStreams);

        _attributes = [.. attributes];
        Count = count;
        Array.Clear(_strides);
        foreach (VertexAttributeDescriptor a in _attributes)
            _strides[a.stream] += a.Size;
        for (int s = 0; s < MaxStreams; s++)
            _streams[s] = new byte[_strides[s] * count];
        foreach (VertexAttributeDescriptor a in _attributes)
        {
            if (before.Has(a.attribute) && before.Find(a.attribute) is var b && b.format == a.format && b.dimension == a.dimension)
                CopyAttribute(before, a);
        }
    }

    /// <summary>All values of an attribute as floats; components that the buffer lacks are 0.</summary>
    public float[] Read(VertexAttribute attribute, int components)
    {
        float[] values = new float[Count * components];
        VertexAttributeDescriptor a = Find(attribute);
        int offset = Offset(attribute), stride = _strides[a.stream], size = a.Size / a.dimension;
        ReadOnlySpan<byte> stream = _streams[a.stream];
        for (int v = 0; v < Count; v++)
        {
            for (int c = 0; c < Math.Min(components, a.dimension); c++)
                values[v * components + c] = VertexNumbers.Read(stream[(v * stride + offset + c * size)..], a.format);
        }

        return values;
    }

    public void Write(VertexAttribute attribute, ReadOnlySpan<float> values, int components)
    {
        VertexAttributeDescriptor a = Find(attribute);
        int offset = Offset(attribute), stride = _strides[a.stream], size = a.Size / a.dimension;
        Span<byte> stream = _streams[a.stream];
        for (int v = 0; v < values.Length / components; v++)
        {
            for (int c = 0; c < Math.Min(components, a.dimension); c++)
                VertexNumbers.Write(stream[(v * stride + offset + c * size)..], a.format, values[v * components + c]);
        }
    }

    public VertexBuffers Copy()
    {
        var copy = new VertexBuffers();
        copy.Layout(Count, _attributes);
        for (int s = 0; s < MaxStreams; s++)
            _streams[s]?.CopyTo(copy._streams[s], 0);
        return copy;
    }

    private void CopyAttribute(VertexBuffers from, VertexAttributeDescriptor a)
    {
        int source = from.Find(a.attribute).stream;
        int fromOffset = from.Offset(a.attribute), toOffset = Offset(a.attribute);
        for (int v = 0; v < Math.Min(Count, from.Count); v++)
        {
            from._streams[source].AsSpan(v * from._strides[source] + fromOffset, a.Size)
                .CopyTo(_streams[a.stream].AsSpan(v * _strides[a.stream] + toOffset, a.Size));
        }
    }
}

/// <summary>Single numbers in the formats of vertex buffers.</summary>
internal static class VertexNumbers
{
    public static float Read(ReadOnlySpan<byte> at, VertexAttributeFormat format) => format switch
    {
        VertexAttributeFormat.Float32 => MemoryMarshal.Read<float>(at),
        VertexAttributeFormat.Float16 => (float)MemoryMarshal.Read<Half>(at),
        VertexAttributeFormat.UNorm8 => at[0] / 255f,
        VertexAttributeFormat.SNorm8 => Math.Max((sbyte)at[0] / 127f, -1f),
        VertexAttributeFormat.UNorm16 => MemoryMarshal.Read<ushort>(at) / 65535f,
        VertexAttributeFormat.SNorm16 => Math.Max(MemoryMarshal.Read<short>(at) / 32767f, -1f),
        VertexAttributeFormat.UInt8 => at[0],
        VertexAttributeFormat.SInt8 => (sbyte)at[0],
        VertexAttributeFormat.UInt16 => MemoryMarshal.Read<ushort>(at),
        VertexAttributeFormat.SInt16 => MemoryMarshal.Read<short>(at),
        VertexAttributeFormat.UInt32 => MemoryMarshal.Read<uint>(at),
        _ => MemoryMarshal.Read<int>(at),
    };

    public static void Write(Span<byte> at, VertexAttributeFormat format, float value)
    {
        switch (format)
        {
            case VertexAttributeFormat.Float32: MemoryMarshal.Write(at, value); break;
            case VertexAttributeFormat.Float16: MemoryMarshal.Write(at, (Half)value); break;
            case VertexAttributeFormat.UNorm8: at[0] = (byte)MathF.Round(Math.Clamp(value, 0f, 1f) * 255f); break;
            case VertexAttributeFormat.SNorm8: at[0] = (byte)(sbyte)MathF.Round(Math.Clamp(value, -1f, 1f) * 127f); break;
            case VertexAttributeFormat.UNorm16: MemoryMarshal.Write(at, (ushort)MathF.Round(Math.Clamp(value, 0f, 1f) * 65535f)); break;
            case VertexAttributeFormat.SNorm16: MemoryMarshal.Write(at, (short)MathF.Round(Math.Clamp(value, -1f, 1f) * 32767f)); break;
            case VertexAttributeFormat.UInt8: at[0] = (byte)value; break;
            case VertexAttributeFormat.SInt8: at[0] = (byte)(sbyte)value; break;
            case VertexAttributeFormat.UInt16: MemoryMarshal.Write(at, (ushort)value); break;
            case VertexAttributeFormat.SInt16: MemoryMarshal.Write(at, (short)value); break;
            case VertexAttributeFormat.UInt32: MemoryMarshal.Write(at, (uint)value); break;
            default: MemoryMarshal.Write(at, (int)value); break;
        }
    }
}
