using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>Writes PNG pictures of eight bits a channel, red, green, blue and alpha.</summary>
internal static class PngWriter
{
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
        using (var packing = new ZLibStream(packed, CompressionLevel.Fastest, leaveOpen: true))
        {
            var line = new byte[1 + 4 * width];
            for (int row = 0; row < height; row++)
            {
                for (int column = 0; column < width; column++)
                {
                    Color32 pixel = pixels[row * width + column];
                    (line[4 * column + 1], line[4 * column + 2]) = (pixel.r, pixel.g);
                    (line[4 * column + 3], line[4 * column + 4]) = (pixel.b, pixel.a);
                }

                packing.Write(line);
            }
        }

        return packed.ToArray();
    }

    private static void WriteChunk(MemoryStream file, string name, byte[] content)
    {
        var chunk = new byte[12 + content.Length];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        System.Text.Encoding.Latin1.GetBytes(name, chunk.AsSpan(4));
        content.CopyTo(chunk, 8);
        BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(8 + content.Length), PngChecksum.Of(chunk.AsSpan(4, content.Length + 4)));
        file.Write(chunk);
    }
}
