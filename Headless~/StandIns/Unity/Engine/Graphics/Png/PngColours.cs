using System;
using System.Buffers.Binary;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>The colours of a row's pixels.</summary>
internal sealed class PngColours
{
    private readonly PngHeader m_Header;
    private readonly byte[] m_Palette;
    private readonly byte[] m_PaletteAlpha;

    /// <summary>The samples of the one transparent colour; null for none.</summary>
    private readonly int[] m_Key;

    public PngColours(PngHeader header, byte[] palette, byte[] transparency)
    {
        m_Header = header;
        m_Palette = palette;
        bool hasPalette = header.ColourType == PngHeader.Palette;
        if (hasPalette && (palette.Length == 0 || palette.Length % 3 != 0))
            throw new FormatException("it is damaged: its palette is missing or incomplete.");
        m_PaletteAlpha = hasPalette ? transparency ?? [] : [];
        if (!hasPalette && transparency?.Length >= 2 * header.Channels && header.Channels is 1 or 3)
        {
            m_Key = new int[header.Channels];
            for (int c = 0; c < m_Key.Length; c++)
                m_Key[c] = BinaryPrimitives.ReadUInt16BigEndian(transparency.AsSpan(2 * c));
        }
    }

    public Color32 At(ReadOnlySpan<byte> line, int column)
    {
        int first = column * m_Header.Channels;
        if (m_Header.ColourType == PngHeader.Palette)
            return FromPalette(Sample(line, first));
        byte red = Byte(line, first);
        bool isGrey = m_Header.ColourType is PngHeader.Grey or PngHeader.GreyAlpha;
        bool hasAlpha = m_Header.ColourType is PngHeader.GreyAlpha or PngHeader.Rgba;
        byte green = isGrey ? red : Byte(line, first + 1), blue = isGrey ? red : Byte(line, first + 2);
        byte alpha = hasAlpha ? Byte(line, first + m_Header.Channels - 1) : IsKey(line, first) ? (byte)0 : (byte)255;
        return new Color32(red, green, blue, alpha);
    }

    private Color32 FromPalette(int index)
    {
        if (3 * index >= m_Palette.Length)
            throw new FormatException("it is damaged: a pixel has a colour that is not in the palette.");
        byte alpha = index < m_PaletteAlpha.Length ? m_PaletteAlpha[index] : (byte)255;
        return new Color32(m_Palette[3 * index], m_Palette[3 * index + 1], m_Palette[3 * index + 2], alpha);
    }

    private bool IsKey(ReadOnlySpan<byte> line, int first)
    {
        for (int c = 0; m_Key != null && c < m_Key.Length; c++)
        {
            if (Sample(line, first + c) != m_Key[c])
                return false;
        }

        return m_Key != null;
    }

    private byte Byte(ReadOnlySpan<byte> line, int index) => m_Header.Depth switch
    {
        8 => line[index],
        16 => line[2 * index],
        _ => (byte)(Sample(line, index) * 255 / ((1 << m_Header.Depth) - 1)),
    };

    private int Sample(ReadOnlySpan<byte> line, int index)
    {
        int depth = m_Header.Depth;
        if (depth == 8)
            return line[index];
        if (depth == 16)
            return BinaryPrimitives.ReadUInt16BigEndian(line[(2 * index)..]);
        int bit = index * depth;
        return (line[bit / 8] >> (8 - depth - bit % 8)) & ((1 << depth) - 1);
    }
}
