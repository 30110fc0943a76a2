using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Numerics;
using System.Runtime.InteropServices;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>Writes PNG pictures of eight bits a channel, red, green, blue and alpha.</summary>
internal static class PngWriter
{
    /// <summary>The last of the filters: none, left, above, mean, Paeth.</summary>
    private const byte k_Filters = 4;

    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="pixels">Rows from top to bottom.</param>
    public static byte[] Write(int width, int height, Color32[] pixels)
    {
        using var file = new MemoryStream();
        file.Write(PngFile.Signature);
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        header[8] = 8;
        header[9] = PngHeader.Rgba;
        WriteChunk(file, "IHDR", header);
        WriteChunk(file, "IDAT", Packed(width, height, pixels));
        WriteChunk(file, "IEND", []);
        return file.ToArray();
    }

    private static byte[] Packed(int width, int height, Color32[] pixels)
    {
        using var packed = new MemoryStream();
        using (var packing = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            // Four bytes of nothing are left of each row.
            byte[] line = new byte[4 + 4 * width], above = new byte[line.Length];
            byte[] best = new byte[1 + 4 * width], filtered = new byte[best.Length];
            for (int row = 0; row < height; row++)
            {
                MemoryMarshal.AsBytes(pixels.AsSpan(row * width, width)).CopyTo(line.AsSpan(4));
                int least = int.MaxValue;
                for (byte filter = 0; filter <= k_Filters; filter++)
                {
                    filtered[0] = filter;
                    int sum = Filter(filter, line, above, filtered.AsSpan(1));
                    if (sum >= least)
                        continue;
                    least = sum;
                    (best, filtered) = (filtered, best);
                }

                packing.Write(best);
                (line, above) = (above, line);
            }
        }

        return packed.ToArray();
    }

    // Sum of the differences from what the filter predicts: the filter with the least is taken, as the standard advises.
    private static int Filter(byte filter, ReadOnlySpan<byte> line, ReadOnlySpan<byte> above, Span<byte> filtered)
    {
        ReadOnlySpan<byte> here = line[4..], left = line[..^4], up = above[4..], corner = above[..^4];
        int sum = 0, k = 0;
        for (; k + Vector<byte>.Count <= filtered.Length; k += Vector<byte>.Count)
        {
            Vector<byte> a = new(left[k..]), b = new(up[k..]), c = new(corner[k..]);
            Vector<byte> difference = new Vector<byte>(here[k..]) - filter switch
            {
                0 => default,
                1 => a,
                2 => b,
                3 => (a & b) + ((a ^ b) >>> 1),
                _ => Paeth(a, b, c),
            };
            difference.CopyTo(filtered[k..]);
            Vector.Widen(Vector.Min(difference, Vector<byte>.Zero - difference), out Vector<ushort> low, out Vector<ushort> high);
            sum += Vector.Sum(low + high);
        }

        for (; k < filtered.Length; k++)
        {
            int predicted = filter switch
            {
                0 => 0,
                1 => left[k],
                2 => up[k],
                3 => (left[k] + up[k]) / 2,
                _ => Paeth(left[k], up[k], corner[k]),
            };
            filtered[k] = (byte)(here[k] - predicted);
            sum += Math.Abs((int)(sbyte)filtered[k]);
        }

        return sum;
    }

    // Which of the three is nearest to left + above - corner.
    private static int Paeth(int left, int above, int corner)
    {
        int toLeft = Math.Abs(above - corner), toAbove = Math.Abs(left - corner), toCorner = Math.Abs(left + above - 2 * corner);
        return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
    }

    private static Vector<byte> Paeth(Vector<byte> left, Vector<byte> above, Vector<byte> corner)
    {
        Vector.Widen(left, out Vector<ushort> leftLow, out Vector<ushort> leftHigh);
        Vector.Widen(above, out Vector<ushort> aboveLow, out Vector<ushort> aboveHigh);
        Vector.Widen(corner, out Vector<ushort> cornerLow, out Vector<ushort> cornerHigh);
        return Vector.Narrow(Paeth(leftLow, aboveLow, cornerLow), Paeth(leftHigh, aboveHigh, cornerHigh));
    }

    private static Vector<ushort> Paeth(Vector<ushort> left, Vector<ushort> above, Vector<ushort> corner)
    {
        Vector<short> a = Vector.AsVectorInt16(left), b = Vector.AsVectorInt16(above), c = Vector.AsVectorInt16(corner);
        Vector<short> toLeft = Vector.Abs(b - c), toAbove = Vector.Abs(a - c), toCorner = Vector.Abs(a + b - c - c);
        Vector<short> isLeft = Vector.LessThanOrEqual(toLeft, toAbove) & Vector.LessThanOrEqual(toLeft, toCorner);
        var rest = Vector.ConditionalSelect(Vector.LessThanOrEqual(toAbove, toCorner), b, c);
        return Vector.AsVectorUInt16(Vector.ConditionalSelect(isLeft, a, rest));
    }

    private static void WriteChunk(MemoryStream file, string name, byte[] content)
    {
        byte[] chunk = new byte[12 + content.Length];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        System.Text.Encoding.Latin1.GetBytes(name, chunk.AsSpan(4));
        content.CopyTo(chunk, 8);
        BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(8 + content.Length), PngChecksum.Of(chunk.AsSpan(4, content.Length + 4)));
        file.Write(chunk);
    }
}
