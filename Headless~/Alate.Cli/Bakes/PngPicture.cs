using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Text;

namespace Alate.Cli.Bakes;

/// <summary>A PNG picture of three channels of 16 bits, not colour-managed.</summary>
internal sealed class PngPicture(int width, int height)
{
    private const int k_Channels = 3, k_BytesPerPixel = 2 * k_Channels;
    private const byte k_Sixteen = 16, k_TrueColour = 2, k_FilterUp = 2;

    private static readonly byte[] s_Signature = [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];
    private static readonly uint[] s_Remainders = Remainders();

    private readonly byte[] m_Pixels = new byte[(long)width * height * k_BytesPerPixel];

    public int Width => width;

    public int Height => height;

    /// <summary>Sets a pixel, from the upper left; channels from 0 to 1.</summary>
    public void Set(int column, int row, Unity.Mathematics.float3 colour)
    {
        int at = (row * width + column) * k_BytesPerPixel;
        for (int channel = 0; channel < k_Channels; channel++)
        {
            ushort value = (ushort)Math.Round(65535.0 * Math.Clamp(colour[channel], 0f, 1f));
            BinaryPrimitives.WriteUInt16BigEndian(m_Pixels.AsSpan(at + 2 * channel), value);
        }
    }

    public void Write(Stream stream)
    {
        stream.Write(s_Signature);
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        header[8] = k_Sixteen;
        header[9] = k_TrueColour;
        WriteChunk(stream, "IHDR", header);
        WriteChunk(stream, "IDAT", Compressed());
        WriteChunk(stream, "IEND", []);
    }

    // Rows are frames, which differ little from one to the next.
    private byte[] Compressed()
    {
        int stride = width * k_BytesPerPixel;
        byte[] row = new byte[1 + stride];
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.Optimal, leaveOpen: true))
        {
            for (int y = 0; y < height; y++)
            {
                row[0] = k_FilterUp;
                for (int k = 0; k < stride; k++)
                    row[1 + k] = (byte)(m_Pixels[y * stride + k] - (y > 0 ? m_Pixels[(y - 1) * stride + k] : 0));
                zlib.Write(row);
            }
        }

        return packed.ToArray();
    }

    private static void WriteChunk(Stream stream, string name, byte[] content)
    {
        byte[] chunk = new byte[12 + content.Length];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        Encoding.ASCII.GetBytes(name).CopyTo(chunk, 4);
        content.CopyTo(chunk, 8);
        BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(8 + content.Length), Check(chunk.AsSpan(4, 4 + content.Length)));
        stream.Write(chunk);
    }

    private static uint Check(ReadOnlySpan<byte> bytes)
    {
        uint check = uint.MaxValue;
        foreach (byte value in bytes)
            check = s_Remainders[(check ^ value) & 0xFF] ^ (check >> 8);
        return ~check;
    }

    // Of the polynomial that PNG's check sum divides by.
    private static uint[] Remainders()
    {
        uint[] remainders = new uint[256];
        for (uint k = 0; k < remainders.Length; k++)
        {
            uint remainder = k;
            for (int bit = 0; bit < 8; bit++)
                remainder = (remainder & 1) != 0 ? 0xEDB88320u ^ (remainder >> 1) : remainder >> 1;
            remainders[k] = remainder;
        }

        return remainders;
    }
}
