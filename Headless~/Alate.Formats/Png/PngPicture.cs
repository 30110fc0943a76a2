using System.Buffers.Binary;
using System.IO.Compression;

namespace Alate.Formats;

/// <summary>A PNG picture of three channels of 16 bits, not colour-managed.</summary>
internal sealed class PngPicture(int width, int height)
{
    private const int k_Channels = 3, k_BytesPerPixel = 2 * k_Channels;
    private const byte k_Sixteen = 16, k_TrueColour = 2, k_FilterUp = 2;

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
        stream.Write(PngChunks.Signature);
        PngChunks.Write(stream, "IHDR", PngChunks.Header(width, height, k_Sixteen, k_TrueColour));
        PngChunks.Write(stream, "IDAT", Compressed());
        PngChunks.Write(stream, "IEND", []);
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
}
