using System.IO.Compression;
using UnityEngine;

namespace Alate.Formats;

/// <summary>Writes films and small pictures of 255 colours as PNG files.</summary>
internal static class IndexedPng
{
    private const byte k_Indexed = 3;
    private const int k_Colours = 255;

    /// <summary>An animation; a single frame is a still picture.</summary>
    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="frames">[frame] Rows from above; opaque.</param>
    /// <param name="rate">Frames a second.</param>
    /// <param name="repeats">True for ever, false once.</param>
    /// <param name="texts">What is written in it, for those who do not see it.</param>
    public static byte[] Write(int width, int height, IReadOnlyList<Color32[]> frames, int rate, bool repeats, IEnumerable<string> texts)
    {
        var table = new ColourTable(frames[0][0], frames.SelectMany(frame => frame), k_Colours);
        using var file = new MemoryStream();
        file.Write(PngChunks.Signature);
        PngChunks.Write(file, "IHDR", PngChunks.Header(width, height, 8, k_Indexed));
        PngChunks.WriteTexts(file, texts);
        // Entry 0 is see-through: where a frame is as the one before.
        PngChunks.Write(file, "PLTE", [0, 0, 0, .. table.Colours.SelectMany(colour => new[] { colour.r, colour.g, colour.b })]);
        PngChunks.Write(file, "tRNS", [0]);
        var film = new PngFrames(file, frames.Count, rate, repeats);
        byte[] before = null;
        foreach (Color32[] frame in frames)
        {
            byte[] indices = Indices(frame, width, table);
            byte[] changed = before == null ? indices : Changed(indices, before);
            (int left, int top, int right, int bottom) = before == null ? (0, 0, width, height) : Extent(changed, width, height);
            film.Write(left, top, right, bottom, Packed(changed, width, left, top, right, bottom), before != null);
            before = indices;
        }

        PngChunks.Write(file, "IEND", []);
        return file.ToArray();
    }

    private static byte[] Indices(Color32[] frame, int width, ColourTable table)
    {
        byte[] indices = new byte[frame.Length];
        for (int k = 0; k < frame.Length; k++)
            indices[k] = (byte)(1 + table.IndexOf(frame[k], k % width, k / width));
        return indices;
    }

    private static byte[] Changed(byte[] indices, byte[] before)
    {
        byte[] changed = (byte[])indices.Clone();
        for (int k = 0; k < changed.Length; k++)
            changed[k] = indices[k] == before[k] ? (byte)0 : indices[k];
        return changed;
    }

    // At least one pixel.
    private static (int Left, int Top, int Right, int Bottom) Extent(byte[] changed, int width, int height)
    {
        (int left, int top, int right, int bottom) = (width, height, 0, 0);
        for (int k = 0; k < changed.Length; k++)
        {
            if (changed[k] == 0)
                continue;
            (left, right) = (Math.Min(left, k % width), Math.Max(right, k % width + 1));
            (top, bottom) = (Math.Min(top, k / width), k / width + 1);
        }

        return right == 0 ? (0, 0, 1, 1) : (left, top, right, bottom);
    }

    private static byte[] Packed(byte[] indices, int width, int left, int top, int right, int bottom)
    {
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            for (int row = top; row < bottom; row++)
            {
                zlib.WriteByte(0);
                zlib.Write(indices, row * width + left, right - left);
            }
        }

        return packed.ToArray();
    }
}
