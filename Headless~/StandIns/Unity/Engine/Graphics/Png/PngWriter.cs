using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
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
            byte[] above = new byte[4 * width];
            for (int row = 0; row < height; row++)
            {
                byte[] line = Line(pixels.AsSpan(row * width, width));
                packing.Write(Filtered(line, above));
                above = line;
            }
        }

        return packed.ToArray();
    }

    private static byte[] Line(ReadOnlySpan<Color32> pixels)
    {
        byte[] line = new byte[4 * pixels.Length];
        for (int k = 0; k < pixels.Length; k++)
            (line[4 * k], line[4 * k + 1], line[4 * k + 2], line[4 * k + 3]) = (pixels[k].r, pixels[k].g, pixels[k].b, pixels[k].a);
        return line;
    }

    // The filter whose differences are smallest in sum, as the standard advises.
    private static byte[] Filtered(byte[] line, byte[] above)
    {
        byte[] best = null;
        long least = long.MaxValue;
        for (byte filter = 0; filter <= k_Filters; filter++)
        {
            byte[] filtered = new byte[1 + line.Length];
            filtered[0] = filter;
            long sum = 0;
            for (int k = 0; k < line.Length; k++)
            {
                int left = k < 4 ? 0 : line[k - 4], corner = k < 4 ? 0 : above[k - 4];
                filtered[k + 1] = (byte)(line[k] - Predicted(filter, left, above[k], corner));
                sum += Math.Abs((int)(sbyte)filtered[k + 1]);
            }

            (best, least) = sum < least ? (filtered, sum) : (best, least);
        }

        return best;
    }

    private static int Predicted(byte filter, int left, int above, int corner)
    {
        int toLeft = Math.Abs(above - corner), toAbove = Math.Abs(left - corner), toCorner = Math.Abs(left + above - 2 * corner);
        return filter switch
        {
            0 => 0,
            1 => left,
            2 => above,
            3 => (left + above) / 2,
            _ => toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner,
        };
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
