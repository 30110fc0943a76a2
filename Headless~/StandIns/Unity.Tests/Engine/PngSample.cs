using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;

namespace Unity.Tests.Engine;

/// <summary>Writes small PNG files of every kind, to read them back.</summary>
internal sealed class PngSample
{
    private static readonly int[,] s_Passes = { { 0, 0, 8, 8 }, { 4, 0, 8, 8 }, { 0, 4, 4, 8 }, { 2, 0, 4, 4 }, { 0, 2, 2, 4 },
        { 1, 0, 2, 2 }, { 0, 1, 1, 2 } };

    public int Width { get; init; } = 13;

    public int Height { get; init; } = 11;

    public int ColourType { get; init; } = 6;

    public int Depth { get; init; } = 8;

    public bool IsInterlaced { get; init; }

    public byte[] Palette { get; init; }

    public byte[] Transparency { get; init; }

    public int Channels => ColourType switch { 2 => 3, 4 => 2, 6 => 4, _ => 1 };

    public int Most => (1 << Depth) - 1;

    /// <summary>A sample that depends on everything.</summary>
    public int Sample(int column, int row, int channel) =>
        (column * 37 + row * 91 + channel * 53 + column * row * 7) % (Palette == null ? Most + 1 : Palette.Length / 3);

    public byte[] Write()
    {
        using var file = new MemoryStream();
        file.Write([0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10]);
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, Width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), Height);
        (header[8], header[9], header[12]) = ((byte)Depth, (byte)ColourType, (byte)(IsInterlaced ? 1 : 0));
        WriteChunk(file, "IHDR", header);
        WriteChunk(file, "tEXt", [1, 2, 3]);
        if (Palette != null)
            WriteChunk(file, "PLTE", Palette);
        if (Transparency != null)
            WriteChunk(file, "tRNS", Transparency);
        byte[] packed = Packed();
        WriteChunk(file, "IDAT", packed[..(packed.Length / 2)]);
        WriteChunk(file, "IDAT", packed[(packed.Length / 2)..]);
        WriteChunk(file, "IEND", []);
        return file.ToArray();
    }

    public static void WriteChunk(Stream file, string name, byte[] content)
    {
        byte[] chunk = new byte[8 + content.Length];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        for (int k = 0; k < 4; k++)
            chunk[4 + k] = (byte)name[k];
        content.CopyTo(chunk, 8);
        uint check = uint.MaxValue;
        foreach (byte next in chunk.AsSpan(4))
        {
            check ^= next;
            for (int bit = 0; bit < 8; bit++)
                check = (check & 1) != 0 ? 0xEDB88320 ^ (check >> 1) : check >> 1;
        }

        file.Write(chunk);
        BinaryPrimitives.WriteUInt32BigEndian(chunk, ~check);
        file.Write(chunk, 0, 4);
    }

    private byte[] Packed()
    {
        using var packed = new MemoryStream();
        using (var packing = new ZLibStream(packed, CompressionLevel.Optimal, true))
        {
            if (!IsInterlaced)
                WritePass(packing, 0, 0, 1, 1);
            for (int pass = 0; IsInterlaced && pass < 7; pass++)
                WritePass(packing, s_Passes[pass, 0], s_Passes[pass, 1], s_Passes[pass, 2], s_Passes[pass, 3]);
        }

        return packed.ToArray();
    }

    private void WritePass(Stream packing, int left, int top, int across, int down)
    {
        int columns = (Width - left + across - 1) / across;
        byte[] above = new byte[(columns * Channels * Depth + 7) / 8];
        for (int row = top, line = 0; columns > 0 && row < Height; row += down, line++)
        {
            byte[] bytes = new byte[above.Length];
            for (int k = 0; k < columns * Channels; k++)
                Put(bytes, k, Sample(left + k / Channels * across, row, k % Channels));
            int filter = line % 5;
            packing.WriteByte((byte)filter);
            for (int k = 0; k < bytes.Length; k++)
                packing.WriteByte((byte)(bytes[k] - Guess(filter, bytes, above, k)));
            above = bytes;
        }
    }

    private void Put(byte[] bytes, int index, int sample)
    {
        if (Depth == 16)
            BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(2 * index), (ushort)sample);
        else
            bytes[index * Depth / 8] |= (byte)(sample << (8 - Depth - index * Depth % 8));
    }

    private int Guess(int filter, byte[] bytes, byte[] above, int k)
    {
        int step = Math.Max(1, Channels * Depth / 8), a = k >= step ? bytes[k - step] : 0, b = above[k],
            c = k >= step ? above[k - step] : 0;
        int p = a + b - c, pa = Math.Abs(p - a), pb = Math.Abs(p - b), pc = Math.Abs(p - c);
        return filter switch { 1 => a, 2 => b, 3 => (a + b) / 2, 4 => pa <= pb && pa <= pc ? a : pb <= pc ? b : c, _ => 0 };
    }
}
