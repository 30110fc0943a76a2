using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>A set of pixels.</summary>
    internal sealed class PixelMask
    {
        public readonly int width;
        public readonly int height;

        private readonly bool[] m_Pixels;

        public PixelMask(int width, int height)
        {
            this.width = width;
            this.height = height;
            m_Pixels = new bool[width * height];
        }

        /// <summary>Number of pixels in the set.</summary>
        public int Count
        {
            get
            {
                int count = 0;
                foreach (bool pixel in m_Pixels)
                    count += pixel ? 1 : 0;
                return count;
            }
        }

        public bool this[int column, int row]
        {
            get => m_Pixels[row * width + column];
            set => m_Pixels[row * width + column] = value;
        }

        /// <summary>Returns true where a pixel is in the set; pixels outside the picture are not.</summary>
        public bool Contains(int column, int row) => column >= 0 && row >= 0 && column < width && row < height && this[column, row];

        public PixelMask Copy()
        {
            var copy = new PixelMask(width, height);
            m_Pixels.CopyTo(copy.m_Pixels, 0);
            return copy;
        }

        /// <summary>Set grown to all pixels within a distance.</summary>
        public PixelMask Grown(double radius) => Within(radius, true);

        /// <summary>
        /// Set shrunk to all pixels further than a distance from every pixel outside; the picture's rim does not count as outside.
        /// </summary>
        public PixelMask Shrunk(double radius) => Within(radius, false);

        /// <summary>Set with its holes filled.</summary>
        public PixelMask Filled()
        {
            var outside = new PixelMask(width, height);
            var open = new Stack<int>();
            for (int column = 0; column < width; column++)
            {
                Reach(column, 0, outside, open);
                Reach(column, height - 1, outside, open);
            }

            for (int row = 0; row < height; row++)
            {
                Reach(0, row, outside, open);
                Reach(width - 1, row, outside, open);
            }

            while (open.Count > 0)
            {
                int at = open.Pop(), column = at % width, row = at / width;
                Reach(column - 1, row, outside, open);
                Reach(column + 1, row, outside, open);
                Reach(column, row - 1, outside, open);
                Reach(column, row + 1, outside, open);
            }

            var filled = new PixelMask(width, height);
            for (int k = 0; k < m_Pixels.Length; k++)
                filled.m_Pixels[k] = !outside.m_Pixels[k];
            return filled;
        }

        /// <summary>Parts whose pixels touch by a side or a corner, the largest first.</summary>
        public List<PixelPart> Parts()
        {
            var parts = new List<PixelPart>();
            bool[] seen = new bool[m_Pixels.Length];
            for (int k = 0; k < m_Pixels.Length; k++)
            {
                if (m_Pixels[k] && !seen[k])
                    parts.Add(PartFrom(k, seen));
            }

            parts.Sort((a, b) => b.Count.CompareTo(a.Count));
            return parts;
        }

        private PixelPart PartFrom(int first, bool[] seen)
        {
            var part = new PixelPart(width);
            var open = new Stack<int>();
            seen[first] = true;
            open.Push(first);
            while (open.Count > 0)
            {
                int at = open.Pop(), column = at % width, row = at / width;
                part.Add(column, row);
                for (int y = Math.Max(0, row - 1); y <= Math.Min(height - 1, row + 1); y++)
                {
                    for (int x = Math.Max(0, column - 1); x <= Math.Min(width - 1, column + 1); x++)
                    {
                        int next = y * width + x;
                        if (!m_Pixels[next] || seen[next])
                            continue;
                        seen[next] = true;
                        open.Push(next);
                    }
                }
            }

            return part;
        }

        private void Reach(int column, int row, PixelMask outside, Stack<int> open)
        {
            if (column < 0 || row < 0 || column >= width || row >= height || this[column, row] || outside[column, row])
                return;
            outside[column, row] = true;
            open.Push(row * width + column);
        }

        private PixelMask Within(double radius, bool state)
        {
            int limit = (int)radius + 1;
            int[] rows = RowDistances(state, limit);
            var result = new PixelMask(width, height);
            bool[] reached = new bool[width];
            int[] reaches = new int[limit + 1];
            for (int k = 0; k <= limit; k++)
                reaches[k] = k <= radius ? (int)Math.Sqrt(radius * radius - (double)k * k) : -1;
            for (int row = 0; row < height; row++)
            {
                // A pixel that far above or below reaches so far to either side.
                int from = row * width, until = -1;
                for (int column = 0; column < width; column++)
                {
                    until = Math.Max(until, reaches[rows[from + column]] < 0 ? -1 : column + reaches[rows[from + column]]);
                    reached[column] = column <= until;
                }

                until = width;
                for (int column = width - 1; column >= 0; column--)
                {
                    until = Math.Min(until, reaches[rows[from + column]] < 0 ? width : column - reaches[rows[from + column]]);
                    result.m_Pixels[from + column] = (reached[column] || column >= until) == state;
                }
            }

            return result;
        }

        // How many rows away the next pixel of a state is, up to a limit.
        private int[] RowDistances(bool state, int limit)
        {
            int[] distances = new int[m_Pixels.Length];
            for (int k = 0; k < distances.Length; k++)
                distances[k] = m_Pixels[k] == state ? 0 : k < width ? limit : Math.Min(limit, distances[k - width] + 1);
            for (int k = distances.Length - width - 1; k >= 0; k--)
                distances[k] = Math.Min(distances[k], distances[k + width] + 1);
            return distances;
        }
    }
}
