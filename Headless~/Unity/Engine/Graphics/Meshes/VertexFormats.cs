using System;
using System.Runtime.InteropServices;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>One number of a vertex stream as a float, in each format.</summary>
internal static class VertexFormats
{
    public static int Size(VertexAttributeFormat format) => format switch
    {
        VertexAttributeFormat.Float32 or VertexAttributeFormat.UInt32 or VertexAttributeFormat.SInt32 => 4,
        VertexAttributeFormat.UNorm8 or VertexAttributeFormat.SNorm8 or VertexAttributeFormat.UInt8 or VertexAttributeFormat.SInt8 => 1,
        _ => 2,
    };

    public static float Read(ReadOnlySpan<byte> bytes, VertexAttributeFormat format) => format switch
    {
        VertexAttributeFormat.Float32 => MemoryMarshal.Read<float>(bytes),
        VertexAttributeFormat.Float16 => (float)MemoryMarshal.Read<Half>(bytes),
        VertexAttributeFormat.UNorm8 => bytes[0] / 255f,
        VertexAttributeFormat.SNorm8 => MathF.Max((sbyte)bytes[0] / 127f, -1f),
        VertexAttributeFormat.UNorm16 => MemoryMarshal.Read<ushort>(bytes) / 65535f,
        VertexAttributeFormat.SNorm16 => MathF.Max(MemoryMarshal.Read<short>(bytes) / 32767f, -1f),
        VertexAttributeFormat.UInt8 => bytes[0],
        VertexAttributeFormat.SInt8 => (sbyte)bytes[0],
        VertexAttributeFormat.UInt16 => MemoryMarshal.Read<ushort>(bytes),
        VertexAttributeFormat.SInt16 => MemoryMarshal.Read<short>(bytes),
        VertexAttributeFormat.UInt32 => MemoryMarshal.Read<uint>(bytes),
        _ => MemoryMarshal.Read<int>(bytes),
    };

    public static void Write(Span<byte> bytes, VertexAttributeFormat format, float value)
    {
        switch (format)
        {
            case VertexAttributeFormat.Float32: MemoryMarshal.Write(bytes, value); break;
            case VertexAttributeFormat.Float16: MemoryMarshal.Write(bytes, (Half)value); break;
            case VertexAttributeFormat.UNorm8: bytes[0] = (byte)MathF.Round(Math.Clamp(value, 0f, 1f) * 255f); break;
            case VertexAttributeFormat.SNorm8: bytes[0] = (byte)(sbyte)MathF.Round(Math.Clamp(value, -1f, 1f) * 127f); break;
            case VertexAttributeFormat.UNorm16: MemoryMarshal.Write(bytes, (ushort)MathF.Round(Math.Clamp(value, 0f, 1f) * 65535f)); break;
            case VertexAttributeFormat.SNorm16: MemoryMarshal.Write(bytes, (short)MathF.Round(Math.Clamp(value, -1f, 1f) * 32767f)); break;
            case VertexAttributeFormat.UInt8: bytes[0] = (byte)value; break;
            case VertexAttributeFormat.SInt8: bytes[0] = (byte)(sbyte)value; break;
            case VertexAttributeFormat.UInt16: MemoryMarshal.Write(bytes, (ushort)value); break;
            case VertexAttributeFormat.SInt16: MemoryMarshal.Write(bytes, (short)value); break;
            case VertexAttributeFormat.UInt32: MemoryMarshal.Write(bytes, (uint)value); break;
            default: MemoryMarshal.Write(bytes, (int)value); break;
        }
    }
}
