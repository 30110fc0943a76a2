using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    private static string ChannelName(VertexAttribute channel) => channel switch
    {
        VertexAttribute.Position => "vertices",
        VertexAttribute.TexCoord0 => "uv",
        >= VertexAttribute.TexCoord1 and <= VertexAttribute.TexCoord7 => $"uv{channel - VertexAttribute.TexCoord0 + 1}",
        _ => $"{channel.ToString().ToLowerInvariant()}s",
    };

    private T[] ReadChannel<T>(VertexAttribute channel) where T : unmanaged =>
        CanAccess(ChannelName(channel)) ? _buffer.ReadAll<T>(channel) : [];

    private void WriteChannel<T>(VertexAttribute channel, ReadOnlySpan<T> values, VertexAttributeFormat format, int dimension)
        where T : unmanaged
    {
        if (!CanAccess(ChannelName(channel)) || !Resize(channel, values.Length))
            return;
        if (values.Length == 0 && channel != VertexAttribute.Position)
        {
            if (_buffer.Layout.IndexOf(channel) >= 0)
                _buffer.Rebuild(_buffer.Layout.Without(channel), _buffer.Count);
            return;
        }

        EnsureAttribute(channel, format, dimension);
        _buffer.WriteAll(channel, values);
    }

    private void WriteFloats<T>(VertexAttribute channel, ReadOnlySpan<T> values) where T : unmanaged =>
        WriteChannel(channel, values, VertexAttributeFormat.Float32, MemoryMarshal.AsBytes(values[..Math.Min(1, values.Length)]).Length / 4);

    private void WriteList<T>(VertexAttribute channel, List<T> values, int start, int length) where T : unmanaged =>
        WriteFloats<T>(channel, CollectionsMarshal.AsSpan(values).Slice(start, length));

    private unsafe void WriteNative<T>(VertexAttribute channel, NativeArray<T> values, int start, int length, int floats)
        where T : struct
    {
        if (System.Runtime.CompilerServices.Unsafe.SizeOf<T>() != floats * 4)
            throw new ArgumentException($"{ChannelName(channel)} of a NativeArray must be structs of {floats * 4} bytes ({floats} floats).");
        ReadOnlySpan<float> all = MemoryMarshal.Cast<T, float>(values.GetSubArray(start, length).AsReadOnlySpan());
        switch (floats)
        {
            case 2: WriteFloats(channel, MemoryMarshal.Cast<float, Vector2>(all)); break;
            case 3: WriteFloats(channel, MemoryMarshal.Cast<float, Vector3>(all)); break;
            default: WriteFloats(channel, MemoryMarshal.Cast<float, Vector4>(all)); break;
        }
    }

    /// <summary>Positions set the number of vertices; everything else must keep to it.</summary>
    private bool Resize(VertexAttribute channel, int count)
    {
        if (channel == VertexAttribute.Position)
        {
            if (count < _indices.LargestVertex + 1)
            {
                Debug.LogError(
                    "Mesh.vertices is too small. The supplied vertex array has less vertices than are referenced by the triangles array.", this);
                return false;
            }

            _buffer.Rebuild(_buffer.Layout, count);
            return true;
        }

        if (count == 0 || count == _buffer.Count)
            return true;
        Debug.LogError(
            $"Mesh.{ChannelName(channel)} is out of bounds. The supplied array needs to be the same size as the Mesh.vertices array.", this);
        return false;
    }

    private void EnsureAttribute(VertexAttribute channel, VertexAttributeFormat format, int dimension)
    {
        int index = _buffer.Layout.IndexOf(channel);
        if (index >= 0 && _buffer.Layout.Attributes[index].dimension == dimension)
            return;
        _buffer.Rebuild(_buffer.Layout.With(new VertexAttributeDescriptor(channel, format, Math.Max(dimension, 1))), _buffer.Count);
    }
}
