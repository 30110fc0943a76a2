using System.Buffers.Binary;
using StbImageSharp;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A JPEG picture, as cameras write it.</summary>
/// <param name="Width">Pixels in a row.</param>
/// <param name="Height">Rows.</param>
/// <param name="Pixels">[row · width + column] Rows from top to bottom.</param>
/// <param name="Exif">What the camera says of it, a TIFF file; empty for nothing.</param>
internal sealed record JpegFile(int Width, int Height, Color32[] Pixels, ReadOnlyMemory<byte> Exif)
{
    /// <summary>First bytes of every file.</summary>
    public static readonly byte[] Start = [0xFF, 0xD8, 0xFF];

    private const byte k_Exif = 0xE1, k_Scan = 0xDA, k_End = 0xD9;

    private static readonly byte[] s_ExifName = [.. "Exif\0\0"u8];

    /// <summary>Reads a whole file.</summary>
    /// <exception cref="FormatException">It is damaged or cut off; one line that begins with "it".</exception>
    public static JpegFile Read(byte[] file, int longestSide)
    {
        ReadOnlyMemory<byte> exif = CheckParts(file);
        try
        {
            ImageInfo? info = ImageInfo.FromStream(new MemoryStream(file));
            if (info is not { } size)
                throw new FormatException("it is damaged: it holds no pixels.");
            if (Math.Max(size.Width, size.Height) > longestSide)
                throw new FormatException($"it has {size.Width} × {size.Height} pixels; at most {longestSide} a side are read.");
            var read = ImageResult.FromMemory(file, ColorComponents.RedGreenBlue);
            var pixels = new Color32[read.Width * read.Height];
            for (int k = 0; k < pixels.Length; k++)
                pixels[k] = new Color32(read.Data[3 * k], read.Data[3 * k + 1], read.Data[3 * k + 2], byte.MaxValue);
            return new JpegFile(read.Width, read.Height, pixels, exif);
        }
        catch (Exception problem) when (problem is not (FormatException or OutOfMemoryException))
        {
            // The library has no type of its own, and runs out of its arrays in damaged files.
            throw new FormatException("it is damaged, or a kind of JPEG that is not read.");
        }
    }

    // The parts before the pixels, each with a length; behind the pixels the end. Returns the camera's part.
    private static ReadOnlyMemory<byte> CheckParts(byte[] file)
    {
        ReadOnlyMemory<byte> exif = default;
        int at = 2;
        while (at + 4 <= file.Length)
        {
            int length = BinaryPrimitives.ReadUInt16BigEndian(file.AsSpan(at + 2));
            byte kind = file[at + 1];
            if (file[at] != 0xFF)
                throw new FormatException("it is damaged: a part of it does not begin where the one before ends.");
            if (kind == k_Scan)
                return file.AsSpan(at).IndexOf([(byte)0xFF, k_End]) >= 0 ? exif : throw CutOff();
            ReadOnlyMemory<byte> content = file.AsMemory(at + 4, Math.Clamp(length - 2, 0, file.Length - at - 4));
            if (kind == k_Exif && exif.Length == 0 && content.Span.StartsWith(s_ExifName))
                exif = content[s_ExifName.Length..];
            // A byte of all ones may stand before any part.
            at += kind == 0xFF ? 1 : 2 + Math.Max(length, 2);
        }

        throw CutOff();
    }

    private static FormatException CutOff() => new("it is cut off: the file ends too early.");
}
