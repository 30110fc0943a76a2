using System;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>
/// Turns the unpacked rows of a PNG picture into pixels: undoes the filters, and puts the passes of an interlaced one together.
/// </summary>
internal sealed class PngScanlines(PngHeader header, PngColours colours)
{
    public Color32[] Read(byte[] bytes)
    {
        var pixels = new Color32[header.Width * header.Height];
        int at = 0;
        foreach (PngPass pass in header.Passes)
        {
            int length = header.RowLength(pass);
            Span<byte> above = new byte[length];
            for (int row = 0; length > 0 && row < pass.Rows(header.Height); row++)
            {
                Span<byte> line = bytes.AsSpan(at + 1, length);
                Unfilter(bytes[at], line, above, header.PixelBytes);
                int target = (pass.FirstRow + row * pass.RowStep) * header.Width + pass.FirstColumn;
                for (int column = 0; column < pass.Columns(header.Width); column++)
                    pixels[target + column * pass.ColumnStep] = colours.At(line, column);
                above = line;
                at += length + 1;
            }
        }

        return pixels;
    }

    private static void Unfilter(int filter, Span<byte> line, ReadOnlySpan<byte> above, int step)
    {
        if (filter > 4)
            throw new FormatException("it is damaged: a row of pixels has an unknown filter.");
        for (int k = 0; k < line.Length; k++)
        {
            int left = k >= step ? line[k - step] : 0, corner = k >= step ? above[k - step] : 0;
            line[k] += (byte)(filter switch
            {
                1 => left,
                2 => above[k],
                3 => (left + above[k]) / 2,
                4 => Paeth(left, above[k], corner),
                _ => 0,
            });
        }
    }

    private static int Paeth(int left, int above, int corner)
    {
        int guess = left + above - corner;
        int toLeft = Math.Abs(guess - left), toAbove = Math.Abs(guess - above), toCorner = Math.Abs(guess - corner);
        return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
    }
}
