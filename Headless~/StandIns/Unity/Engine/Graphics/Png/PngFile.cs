using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>Reads PNG pictures of every colour type, depth and interlacing (ISO/IEC 15948), as the editor's own decoder would.</summary>
[StandInExtension]
public sealed class PngFile
{
    internal static readonly byte[] Signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    private const int k_LongestSide = 16384;

    private readonly ReadOnlyMemory<byte> m_File;
    private readonly MemoryStream m_Packed = new();
    private PngHeader m_Header;
    private byte[] m_Palette = [];
    private byte[] m_Transparency;

    private PngFile(ReadOnlyMemory<byte> file)
    {
        m_File = file;
    }

    public int Width => m_Header.Width;

    public int Height => m_Header.Height;

    /// <summary>[row * Width + column] Rows from top to bottom.</summary>
    public Color32[] Pixels { get; private set; }

    /// <summary>Reads a whole file.</summary>
    /// <exception cref="FormatException">It is no PNG picture or a damaged one; the message says why, in one line that begins with
    /// "it".</exception>
    public static PngFile Read(ReadOnlyMemory<byte> file)
    {
        if (file.Length == 0)
            throw new FormatException("it is empty.");
        if (file.Length < Signature.Length || !file.Span[..Signature.Length].SequenceEqual(Signature))
            throw new FormatException("it is not a PNG picture.");
        var png = new PngFile(file);
        png.ReadChunks();
        var colours = new PngColours(png.m_Header, png.m_Palette, png.m_Transparency);
        png.Pixels = new PngScanlines(png.m_Header, colours).Read(png.Unpacked());
        return png;
    }

    private void ReadChunks()
    {
        int at = Signature.Length;
        for (string name = ""; name != "IEND";)
        {
            ReadOnlySpan<byte> rest = m_File.Span[at..];
            if (rest.Length < 12 || BinaryPrimitives.ReadUInt32BigEndian(rest) > rest.Length - 12)
                throw new FormatException("it is cut off: the file ends too early.");
            int length = (int)BinaryPrimitives.ReadUInt32BigEndian(rest);
            name = System.Text.Encoding.Latin1.GetString(rest.Slice(4, 4));
            if (PngChecksum.Of(rest.Slice(4, length + 4)) != BinaryPrimitives.ReadUInt32BigEndian(rest[(8 + length)..]))
                throw new FormatException($"it is damaged: the checksum of its part '{name}' is wrong.");
            ReadChunk(name, rest.Slice(8, length), isFirst: at == Signature.Length);
            at += length + 12;
        }

        if (m_Packed.Length == 0)
            throw new FormatException("it is damaged: it holds no pixels.");
    }

    private void ReadChunk(string name, ReadOnlySpan<byte> content, bool isFirst)
    {
        if (isFirst != (name == "IHDR"))
            throw new FormatException("it is damaged: its header is not where it should be.");
        switch (name)
        {
            case "IHDR":
                m_Header = PngHeader.Read(content, k_LongestSide);
                break;
            case "PLTE":
                m_Palette = content.ToArray();
                break;
            case "tRNS":
                m_Transparency = content.ToArray();
                break;
            case "IDAT":
                m_Packed.Write(content);
                break;
        }
    }

    private byte[] Unpacked()
    {
        byte[] pixels = new byte[m_Header.UnpackedLength];
        m_Packed.Position = 0;
        try
        {
            using var unpacking = new ZLibStream(m_Packed, CompressionMode.Decompress);
            unpacking.ReadExactly(pixels);
        }
        catch (EndOfStreamException)
        {
            throw new FormatException("it is damaged: some of its pixels are missing.");
        }
        catch (InvalidDataException)
        {
            throw new FormatException("it is damaged: its pixels cannot be unpacked.");
        }

        return pixels;
    }
}
