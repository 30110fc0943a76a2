using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>
/// A player of animated PNG files with a palette, from the third edition of PNG alone: check sums, order, disposal and blending of the
/// frames.
/// </summary>
internal sealed class ApngPlayer
{
    private readonly byte[] m_Palette, m_Opacity;
    private readonly List<Color32[]> m_Frames = [];

    public ApngPlayer(byte[] file)
    {
        Assert.That(file[..8], Is.EqualTo(new byte[] { 137, 80, 78, 71, 13, 10, 26, 10 }));
        List<(string Name, byte[] Content)> chunks = Chunks(file);
        byte[] header = chunks[0].Content;
        (Width, Height) = (Number(header, 0), Number(header, 4));
        Assert.That(header[8..], Is.EqualTo(new byte[] { 8, 3, 0, 0, 0 }), "eight bits of a palette, not interlaced");
        m_Palette = chunks.Find(chunk => chunk.Name == "PLTE").Content;
        m_Opacity = chunks.Find(chunk => chunk.Name == "tRNS").Content ?? [];
        (string name, byte[] animation) = chunks.Find(chunk => chunk.Name == "acTL");
        Assert.That(name, Is.Not.Null);
        Repeats = Number(animation, 4);
        Play(chunks);
        Assert.That(m_Frames, Has.Count.EqualTo(Number(animation, 0)), "frames that are told");
    }

    public int Width { get; }

    public int Height { get; }

    /// <summary>Number of plays; 0 is for ever.</summary>
    public int Repeats { get; }

    /// <summary>[frame] Seconds.</summary>
    public List<double> Delays { get; } = [];

    /// <summary>[frame] Rows from above.</summary>
    public IReadOnlyList<Color32[]> Frames => m_Frames;

    private void Play(List<(string Name, byte[] Content)> chunks)
    {
        var shown = new Color32[Width * Height];
        int sequence = 0;
        for (int k = 0; k < chunks.Count; k++)
        {
            if (chunks[k].Name != "fcTL")
                continue;
            byte[] control = chunks[k].Content, packed = chunks[k + 1].Content;
            Assert.That(Number(control, 0), Is.EqualTo(sequence++));
            if (chunks[k + 1].Name == "fdAT")
                Assert.That(Number(packed, 0), Is.EqualTo(sequence++));
            else
                Assert.That((chunks[k + 1].Name, m_Frames.Count), Is.EqualTo(("IDAT", 0)));
            (int width, int height, int left, int top) = (Number(control, 4), Number(control, 8), Number(control, 12), Number(control, 16));
            Assert.That(width > 0 && height > 0 && left >= 0 && top >= 0 && left + width <= Width && top + height <= Height, Is.True,
                "within the picture");
            Delays.Add(BinaryPrimitives.ReadUInt16BigEndian(control.AsSpan(20)) / (double)BinaryPrimitives.ReadUInt16BigEndian(
                control.AsSpan(22)));
            var before = (Color32[])shown.Clone();
            Draw(shown, packed[(chunks[k + 1].Name == "fdAT" ? 4 : 0)..], (width, height, left, top), isOver: control[25] == 1);
            m_Frames.Add((Color32[])shown.Clone());
            for (int at = 0; control[24] > 0 && at < width * height; at++)
            {
                int place = (top + at / width) * Width + left + at % width;
                shown[place] = control[24] == 2 ? before[place] : default;
            }
        }
    }

    private void Draw(Color32[] shown, byte[] packed, (int Width, int Height, int Left, int Top) part, bool isOver)
    {
        using var zlib = new ZLibStream(new MemoryStream(packed), CompressionMode.Decompress);
        byte[] row = new byte[part.Width + 1];
        for (int y = 0; y < part.Height; y++)
        {
            zlib.ReadExactly(row);
            Assert.That(row[0], Is.Zero, "no filter");
            for (int x = 0; x < part.Width; x++)
            {
                int entry = row[1 + x];
                byte opacity = entry < m_Opacity.Length ? m_Opacity[entry] : byte.MaxValue;
                if (!isOver || opacity > 0)
                {
                    shown[(part.Top + y) * Width + part.Left + x] = new Color32(
                        m_Palette[3 * entry], m_Palette[3 * entry + 1], m_Palette[3 * entry + 2], opacity);
                }
            }
        }

        Assert.That(zlib.ReadByte(), Is.EqualTo(-1), "nothing behind the last row");
    }

    private static List<(string Name, byte[] Content)> Chunks(byte[] file)
    {
        var chunks = new List<(string, byte[])>();
        for (int at = 8; at < file.Length;)
        {
            int length = Number(file, at);
            Assert.That((uint)Number(file, at + 8 + length), Is.EqualTo(Check(file.AsSpan(at + 4, 4 + length))), "check sum");
            chunks.Add((Encoding.ASCII.GetString(file, at + 4, 4), file[(at + 8)..(at + 8 + length)]));
            at += 12 + length;
        }

        return chunks;
    }

    // Bit by bit (ISO/IEC 3309).
    private static uint Check(ReadOnlySpan<byte> bytes)
    {
        uint check = uint.MaxValue;
        foreach (byte value in bytes)
        {
            check ^= value;
            for (int bit = 0; bit < 8; bit++)
                check = (check >> 1) ^ ((check & 1) * 0xEDB88320u);
        }

        return ~check;
    }

    private static int Number(byte[] bytes, int at) => BinaryPrimitives.ReadInt32BigEndian(bytes.AsSpan(at));
}
