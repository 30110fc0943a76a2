using System;

namespace Unity.StandIns;

/// <summary>The cyclic redundancy check of PNG's parts (ISO 3309).</summary>
internal static class PngChecksum
{
    private static readonly uint[] s_Table = MakeTable();

    public static uint Of(ReadOnlySpan<byte> bytes)
    {
        uint check = uint.MaxValue;
        foreach (byte next in bytes)
            check = s_Table[(check ^ next) & 0xFF] ^ (check >> 8);
        return ~check;
    }

    private static uint[] MakeTable()
    {
        uint[] table = new uint[256];
        for (uint k = 0; k < table.Length; k++)
        {
            uint entry = k;
            for (int bit = 0; bit < 8; bit++)
                entry = (entry & 1) != 0 ? 0xEDB88320 ^ (entry >> 1) : entry >> 1;
            table[k] = entry;
        }

        return table;
    }
}
