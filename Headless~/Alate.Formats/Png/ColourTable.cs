using UnityEngine;

namespace Alate.Formats;

/// <summary>
/// A few colours for many, by median cut (Heckbert 1982): the boxes with the largest spread of what is in them are halved.
/// </summary>
internal sealed class ColourTable
{
    /// <summary>Bits of a channel by which colours are gathered.</summary>
    private const int k_Bits = 5;

    /// <summary>Sum of the differences of the channels at which an entry is taken as it is.</summary>
    private const int k_Near = 4;

    /// <summary>Order of thresholds (Bayer 1973).</summary>
    private static readonly int[,] s_Order = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 }, { 3, 11, 1, 9 }, { 15, 7, 13, 5 } };

    private readonly Dictionary<int, byte> m_Nearest = [];
    private readonly int m_Ground;

    /// <param name="ground">A colour that is kept as it is.</param>
    /// <param name="pixels">All colours; opacity does not count.</param>
    /// <param name="most">Entries, at most 256.</param>
    public ColourTable(Color32 ground, IEnumerable<Color32> pixels, int most)
    {
        var cells = new Cell[1 << (3 * k_Bits)];
        foreach (Color32 pixel in pixels)
        {
            if (Key(pixel) == Key(ground))
                continue;
            ref Cell cell = ref cells[
                (pixel.r >> (8 - k_Bits) << (2 * k_Bits)) | (pixel.g >> (8 - k_Bits) << k_Bits) | (pixel.b >> (8 - k_Bits))];
            cell = new Cell(cell.R + pixel.r, cell.G + pixel.g, cell.B + pixel.b, cell.Count + 1);
        }

        var boxes = new List<Box> { new(Array.FindAll(cells, cell => cell.Count > 0)) };
        while (boxes.Count < most - 1)
        {
            Box widest = boxes.Where(box => box.Cells.Length > 1).MaxBy(box => box.Spread);
            if (widest == null)
                break;
            boxes.Remove(widest);
            boxes.AddRange(widest.Halves());
        }

        Colours = boxes.Where(box => box.Cells.Length > 0).Select(box => box.Mean).Prepend(ground).ToArray();
        m_Ground = Key(ground);
    }

    /// <summary>The entries.</summary>
    public Color32[] Colours { get; }

    /// <summary>
    /// Number of the entry for a colour at a place: the nearest one, or by turns those around it where no entry is near, so that shades
    /// have no steps.
    /// </summary>
    public byte IndexOf(Color32 colour, int x, int y)
    {
        if (Key(colour) == m_Ground)
            return 0;
        byte nearest = IndexOf(colour);
        Color32 entry = Colours[nearest];
        if (Math.Abs(entry.r - colour.r) + Math.Abs(entry.g - colour.g) + Math.Abs(entry.b - colour.b) <= k_Near)
            return nearest;
        int shift = (3 * s_Order[x & 3, y & 3] - 23) / 4;
        return IndexOf(new Color32(Shifted(colour.r, shift), Shifted(colour.g, shift), Shifted(colour.b, shift), byte.MaxValue));
    }

    private static byte Shifted(byte value, int shift) => (byte)Math.Clamp(value + shift, 0, 255);

    private byte IndexOf(Color32 colour)
    {
        int key = Key(colour);
        if (m_Nearest.TryGetValue(key, out byte index))
            return index;
        int least = int.MaxValue;
        for (int k = 0; k < Colours.Length; k++)
        {
            int r = Colours[k].r - colour.r, g = Colours[k].g - colour.g, b = Colours[k].b - colour.b,
                distance = 2 * r * r + 4 * g * g + b * b;
            if (distance < least)
                (least, index) = (distance, (byte)k);
        }

        m_Nearest.Add(key, index);
        return index;
    }

    private static int Key(Color32 colour) => (colour.r << 16) | (colour.g << 8) | colour.b;

    /// <summary>Colours that become one.</summary>
    private sealed class Box
    {
        private readonly int m_Widest;
        private readonly double m_Middle;

        public Box(Cell[] cells)
        {
            Cells = cells;
            double range = 0;
            for (int channel = 0; channel < 3 && cells.Length > 0; channel++)
            {
                double least = cells.Min(cell => cell.Of(channel)), most = cells.Max(cell => cell.Of(channel));
                if (channel == 0 || most - least > range)
                    (m_Widest, range, m_Middle) = (channel, most - least, 0.5 * (most + least));
            }

            Spread = range * Math.Sqrt(Math.Sqrt(cells.Sum(cell => (double)cell.Count)));
        }

        public Cell[] Cells { get; }

        /// <summary>Variance that a cut can save; the root of the count keeps large plain grounds from taking all.</summary>
        public double Spread { get; }

        public Color32 Mean
        {
            get
            {
                long count = Cells.Sum(cell => cell.Count);
                return new Color32((byte)(Cells.Sum(cell => cell.R) / count), (byte)(Cells.Sum(cell => cell.G) / count),
                    (byte)(Cells.Sum(cell => cell.B) / count), byte.MaxValue);
            }
        }

        public Box[] Halves() => [new(Array.FindAll(Cells, cell => cell.Of(m_Widest) <= m_Middle)),
            new(Array.FindAll(Cells, cell => cell.Of(m_Widest) > m_Middle))];
    }

    /// <summary>Sums of the colours that are gathered.</summary>
    private readonly record struct Cell(long R, long G, long B, long Count)
    {
        public double Of(int channel) => (channel == 0 ? R : channel == 1 ? G : B) / (double)Count;
    }
}
