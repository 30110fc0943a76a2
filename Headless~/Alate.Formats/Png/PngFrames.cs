using System.Buffers.Binary;

namespace Alate.Formats;

/// <summary>Writes the frames of an animated PNG file (APNG, the third edition of PNG); a single one is a still picture.</summary>
internal sealed class PngFrames
{
    private readonly Stream m_File;
    private readonly int m_Count, m_Rate;
    private int m_Written, m_Sequence;

    /// <param name="file">It has its header.</param>
    /// <param name="count">Frames.</param>
    /// <param name="rate">Frames a second.</param>
    /// <param name="repeats">True for ever, false once.</param>
    public PngFrames(Stream file, int count, int rate, bool repeats)
    {
        m_File = file;
        m_Count = count;
        m_Rate = rate;
        if (count > 1)
            PngChunks.Write(file, "acTL", Numbers(count, repeats ? 0 : 1));
    }

    /// <summary>Writes a frame.</summary>
    /// <param name="left">First column.</param>
    /// <param name="top">First row.</param>
    /// <param name="right">Column behind the last.</param>
    /// <param name="bottom">Row behind the last.</param>
    /// <param name="packed">Its rows, packed.</param>
    /// <param name="isOver">True where it lies over the frame before, false where it stands in its place.</param>
    public void Write(int left, int top, int right, int bottom, byte[] packed, bool isOver)
    {
        if (m_Count > 1)
        {
            PngChunks.Write(m_File, "fcTL", [.. Numbers(m_Sequence++, right - left, bottom - top, left, top), 0, 1, (byte)(m_Rate >> 8),
                (byte)m_Rate, 0, isOver ? (byte)1 : (byte)0]);
        }

        if (m_Written++ == 0)
            PngChunks.Write(m_File, "IDAT", packed);
        else
            PngChunks.Write(m_File, "fdAT", [.. Numbers(m_Sequence++), .. packed]);
    }

    private static byte[] Numbers(params int[] numbers)
    {
        byte[] bytes = new byte[4 * numbers.Length];
        for (int k = 0; k < numbers.Length; k++)
            BinaryPrimitives.WriteInt32BigEndian(bytes.AsSpan(4 * k), numbers[k]);
        return bytes;
    }
}
