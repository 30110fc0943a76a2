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

    /// <param name="ground">A colour that is kept as it is.</param>
    /// <param name="pixels">All colours; opacity does not count.</param>
    /// <param name="most">Entries, at most 256.</param>
    public ColourTable(Color32 ground, IEnumerable<Color32> pixels, int most)
    {
        var cells = new Dictionary<int, Cell>();
        foreach (Color32 pixel in pixels)
        {
            if (pixel.Equals(ground))
                continue;
            int key = (pixel.r >> (8 - k_Bits) << (2 * k_Bits)) | (pixel.g >> (8 - k_Bits) << k_Bits) | (pixel.b >> (8 - k_Bits));
            cells.TryGetValue(key, out Cell cell);
            cells[key] = new Cell(cell.R + pixel.r, cell.G + pixel.g, cell.B + pixel.b, cell.Count + 1);
        }

        var boxes = new List<List<Cell>> { cells.Values.ToList() };
        while (boxes.Count < most - 1)
        {
            List<Cell> widest = boxes.Where(box => box.Count > 1).MaxBy(Spread);
            if (widest == null)
                break;
            boxes.Remove(widest);
            boxes.AddRange(Halves(widest));
        }

        Colours = boxes.Where(box => box.Count > 0).Select(Mean).Prepend(ground).ToArray();
    }

    /// <summary>The entries.</summary>
    public Color32[] Colours { get; }

    /// <summary>
    /// Number of the entry for a colour at a place: the nearest one, or by turns those around it where no entry is near, so that shades
    /// have no steps.
    /// </summary>
    public byte IndexOf(Color32 colour, int x, int y)
    {
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
        int key = (colour.r << 16) | (colour.g << 8) | colour.b;
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

    // Variance that a cut can save; the square root of the count keeps large plain grounds from taking all.
    private static double Spread(List<Cell> box) =>
        Enumerable.Range(0, 3).Max(channel => Range(box, channel)) * Math.Sqrt(Math.Sqrt(box.Sum(cell => (double)cell.Count)));

    private static double Range(List<Cell> box, int channel) => box.Max(cell => cell.Of(channel)) - box.Min(cell => cell.Of(channel));

    private static List<Cell>[] Halves(List<Cell> box)
    {
        int channel = Enumerable.Range(0, 3).MaxBy(one => Range(box, one));
        double middle = 0.5 * (box.Max(cell => cell.Of(channel)) + box.Min(cell => cell.Of(channel)));
        return [box.FindAll(cell => cell.Of(channel) <= middle), box.FindAll(cell => cell.Of(channel) > middle)];
    }

    private static Color32 Mean(List<Cell> box)
    {
        long count = Math.Max(box.Sum(cell => cell.Count), 1);
        return new Color32((byte)(box.Sum(cell => cell.R) / count), (byte)(box.Sum(cell => cell.G) / count),
            (byte)(box.Sum(cell => cell.B) / count), byte.MaxValue);
    }

    /// <summary>Sums of the colours that are gathered.</summary>
    private readonly record struct Cell(long R, long G, long B, long Count)
    {
        public double Of(int channel) => (channel == 0 ? R : channel == 1 ? G : B) / (double)Count;
    }
}
