using System;
using System.Buffers.Binary;
using System.Collections.Generic;

namespace Unity.StandIns;

/// <summary>Header of a PNG picture.</summary>
internal readonly record struct PngHeader(int Width, int Height, int Depth, int ColourType, bool IsInterlaced)
{
    public const int Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6;

    /// <summary>Column and row of the first pixel and the steps to the next of each of the seven passes of an interlaced picture.</summary>
    private static readonly PngPass[] s_Interlaced =
        [new(0, 0, 8, 8), new(4, 0, 8, 8), new(0, 4, 4, 8), new(2, 0, 4, 4), new(0, 2, 2, 4), new(1, 0, 2, 2), new(0, 1, 1, 2)];

    private static readonly PngPass[] s_Plain = [new(0, 0, 1, 1)];

    public IReadOnlyList<PngPass> Passes => IsInterlaced ? s_Interlaced : s_Plain;

    public int Channels => ColourType switch { Rgb => 3, GreyAlpha => 2, Rgba => 4, _ => 1 };

    /// <summary>Bytes from a pixel to the one that predicts it.</summary>
    public int PixelBytes => Math.Max(1, Channels * Depth / 8);

    /// <summary>Bytes of all rows of all passes, with the byte before each that names its filter.</summary>
    public long UnpackedLength
    {
        get
        {
            long length = 0;
            foreach (PngPass pass in Passes)
                length += RowLength(pass) == 0 ? 0 : (RowLength(pass) + 1L) * pass.Rows(Height);
            return length;
        }
    }

    public int RowLength(PngPass pass) => (pass.Columns(Width) * Channels * Depth + 7) / 8;

    public static PngHeader Read(ReadOnlySpan<byte> content, int longestSide)
    {
        if (content.Length != 13)
            throw new FormatException("it is damaged: its header has the wrong length.");
        uint width = BinaryPrimitives.ReadUInt32BigEndian(content), height = BinaryPrimitives.ReadUInt32BigEndian(content[4..]);
        if (width == 0 || height == 0)
            throw new FormatException("it is damaged: it has no pixels.");
        if (width > longestSide || height > longestSide)
            throw new FormatException($"it is too large: {width} x {height} pixels; at most {longestSide} x {longestSide} are read.");
        var header = new PngHeader((int)width, (int)height, content[8], content[9], content[12] == 1);
        bool isKnown = header.ColourType switch
        {
            Grey => header.Depth is 1 or 2 or 4 or 8 or 16,
            Palette => header.Depth is 1 or 2 or 4 or 8,
            Rgb or GreyAlpha or Rgba => header.Depth is 8 or 16,
            _ => false,
        };
        if (!isKnown || content[10] != 0 || content[11] != 0 || content[12] > 1)
            throw new FormatException("it is damaged: there is no such kind of PNG picture.");
        return header;
    }
}
