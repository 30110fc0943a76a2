using System.Buffers.Binary;

namespace Alate.Formats;

/// <summary>Writes the parts of PNG files (ISO/IEC 15948): length, name, content, check sum.</summary>
internal static class PngChunks
{
    /// <summary>First bytes of every file.</summary>
    public static readonly byte[] Signature = [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];

    private static readonly uint[] s_Remainders = Remainders();

    /// <summary>Writes a part.</summary>
    public static void Write(Stream stream, string name, ReadOnlySpan<byte> content)
    {
        byte[] chunk = new byte[12 + content.Length];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        Encoding.ASCII.GetBytes(name).CopyTo(chunk, 4);
        content.CopyTo(chunk.AsSpan(8));
        BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(8 + content.Length), Check(chunk.AsSpan(4, 4 + content.Length)));
        stream.Write(chunk);
    }

    /// <summary>Writes what a picture says in words, for those who do not see it; nothing where it says nothing.</summary>
    public static void WriteTexts(Stream stream, IEnumerable<string> texts)
    {
        string description = string.Join('\n', texts);
        if (description.Length > 0)
            Write(stream, "iTXt", [.. "Description\0\0\0\0\0"u8, .. Encoding.UTF8.GetBytes(description)]);
    }

    /// <summary>Content of the header.</summary>
    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="depth">Bits of a channel.</param>
    /// <param name="colour">The colour type.</param>
    public static byte[] Header(int width, int height, byte depth, byte colour)
    {
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        header[8] = depth;
        header[9] = colour;
        return header;
    }

    private static uint Check(ReadOnlySpan<byte> bytes)
    {
        uint check = uint.MaxValue;
        foreach (byte value in bytes)
            check = s_Remainders[(check ^ value) & 0xFF] ^ (check >> 8);
        return ~check;
    }

    // Of the polynomial that PNG's check sum divides by.
    private static uint[] Remainders()
    {
        uint[] remainders = new uint[256];
        for (uint k = 0; k < remainders.Length; k++)
        {
            uint remainder = k;
            for (int bit = 0; bit < 8; bit++)
                remainder = (remainder & 1) != 0 ? 0xEDB88320u ^ (remainder >> 1) : remainder >> 1;
            remainders[k] = remainder;
        }

        return remainders;
    }
}
