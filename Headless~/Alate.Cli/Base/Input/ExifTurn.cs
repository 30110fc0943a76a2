using System.Buffers.Binary;
using UnityEngine;

namespace Alate.Cli;

/// <summary>The turn that a camera writes beside a picture, instead of turning its pixels (Exif 2.32, 4.6.4: Orientation).</summary>
internal static class ExifTurn
{
    private const ushort k_Orientation = 0x0112;

    /// <summary>Orientation, 1 to 8; 1, upright, where none is said.</summary>
    /// <param name="exif">A TIFF file; what is damaged says nothing.</param>
    public static int Of(ReadOnlySpan<byte> exif)
    {
        bool little = exif.StartsWith("II*\0"u8);
        if (exif.Length < 8 || !little && !exif.StartsWith("MM\0*"u8))
            return 1;
        long at = Long(exif[4..], little);
        if (at + 2 > exif.Length)
            return 1;
        int count = Short(exif[(int)at..], little);
        for (long entry = at + 2; count > 0 && entry + 12 <= exif.Length; count--, entry += 12)
        {
            if (Short(exif[(int)entry..], little) == k_Orientation)
                return Short(exif[((int)entry + 8)..], little) is >= 1 and <= 8 and var said ? said : 1;
        }

        return 1;
    }

    /// <summary>Content of the part of a PNG file that has it; empty where there is none.</summary>
    /// <param name="png">A whole file.</param>
    public static ReadOnlySpan<byte> InPng(ReadOnlySpan<byte> png)
    {
        for (int at = PngChunks.Signature.Length; at + 12 <= png.Length;)
        {
            uint length = BinaryPrimitives.ReadUInt32BigEndian(png[at..]);
            if (length > png.Length - at - 12)
                break;
            if (png[(at + 4)..].StartsWith("eXIf"u8))
                return png.Slice(at + 8, (int)length);
            at += 12 + (int)length;
        }

        return default;
    }

    /// <summary>Turns a picture upright.</summary>
    /// <param name="orientation">1 to 8.</param>
    /// <param name="width">Pixels in a row; those of the result after.</param>
    /// <param name="height">Rows; those of the result after.</param>
    /// <param name="pixels">[row · width + column]</param>
    public static Color32[] Upright(int orientation, ref int width, ref int height, Color32[] pixels)
    {
        if (orientation == 1)
            return pixels;
        int wide = width, high = height;
        bool isOnSide = orientation >= 5;
        (width, height) = isOnSide ? (high, wide) : (wide, high);
        var turned = new Color32[pixels.Length];
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                (int column, int row) = isOnSide ? (y, x) : (x, y);
                if (orientation is 2 or 3 or 7 or 8)
                    column = wide - 1 - column;
                if (orientation is 3 or 4 or 6 or 7)
                    row = high - 1 - row;
                turned[y * width + x] = pixels[row * wide + column];
            }
        }

        return turned;
    }

    private static ushort Short(ReadOnlySpan<byte> bytes, bool little) =>
        little ? BinaryPrimitives.ReadUInt16LittleEndian(bytes) : BinaryPrimitives.ReadUInt16BigEndian(bytes);

    private static uint Long(ReadOnlySpan<byte> bytes, bool little) =>
        little ? BinaryPrimitives.ReadUInt32LittleEndian(bytes) : BinaryPrimitives.ReadUInt32BigEndian(bytes);
}
