using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>Connected pixels of a set.</summary>
    internal sealed class PixelPart
    {
        private readonly List<int> m_Pixels = new List<int>();
        private readonly int m_Width;
        private int m_Left = int.MaxValue, m_Top = int.MaxValue, m_Right = int.MinValue, m_Bottom = int.MinValue;

        /// <param name="width">Of the picture.</param>
        public PixelPart(int width)
        {
            m_Width = width;
        }

        public int Count => m_Pixels.Count;

        /// <summary>The longer side of the part's bounds, pixels.</summary>
        public int Extent => Math.Max(m_Right - m_Left, m_Bottom - m_Top) + 1;

        public void Add(int column, int row)
        {
            m_Pixels.Add(row * m_Width + column);
            m_Left = Math.Min(m_Left, column);
            m_Right = Math.Max(m_Right, column);
            m_Top = Math.Min(m_Top, row);
            m_Bottom = Math.Max(m_Bottom, row);
        }

        /// <summary>Number of the four sides of a picture that the part reaches.</summary>
        public int SidesReached(int height) =>
            (m_Left == 0 ? 1 : 0) + (m_Top == 0 ? 1 : 0) + (m_Right == m_Width - 1 ? 1 : 0) + (m_Bottom == height - 1 ? 1 : 0);

        /// <summary>Returns true where a condition on column and row holds for any of the pixels.</summary>
        public bool Any(Func<int, int, bool> holds) => m_Pixels.Exists(at => holds(at % m_Width, at / m_Width));

        /// <summary>Number of the pixels for which a condition on column and row holds.</summary>
        public int CountOf(Func<int, int, bool> holds)
        {
            int count = 0;
            foreach (int at in m_Pixels)
                count += holds(at % m_Width, at / m_Width) ? 1 : 0;
            return count;
        }

        public void AddTo(PixelMask mask)
        {
            foreach (int at in m_Pixels)
                mask[at % m_Width, at / m_Width] = true;
        }

        public PixelMask ToMask(int height)
        {
            var mask = new PixelMask(m_Width, height);
            AddTo(mask);
            return mask;
        }
    }
}
