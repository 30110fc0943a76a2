using System;
using System.IO;
using System.IO.Compression;
using System.Text;
using NUnit.Framework;

namespace Alate.Tests.Bakes
{
    /// <summary>A reader of PNG files with three channels of 16 bits, written from the specification alone.</summary>
    internal sealed class WidePng
    {
        private readonly byte[] m_Rows;
        private readonly int m_Stride;

        public WidePng(byte[] file)
        {
            Assert.That(file.AsSpan(0, 8).ToArray(), Is.EqualTo(new byte[] { 137, 80, 78, 71, 13, 10, 26, 10 }));
            using var packed = new MemoryStream();
            int at = 8;
            string name;
            do
            {
                int length = Number(file, at);
                name = Encoding.ASCII.GetString(file, at + 4, 4);
                Assert.That(Number(file, at + 8 + length), Is.EqualTo(Check(file, at + 4, length + 4)), $"check sum of {name}");
                if (name == "IHDR")
                {
                    Width = Number(file, at + 8);
                    Height = Number(file, at + 12);
                    Assert.That(file.AsSpan(at + 16, 5).ToArray(), Is.EqualTo(new byte[] { 16, 2, 0, 0, 0 }),
                        "16 bits, true colour, not interlaced");
                }

                Assert.That(name, Is.Not.EqualTo("sRGB").And.Not.EqualTo("gAMA").And.Not.EqualTo("iCCP"), "not colour-managed");
                if (name == "IDAT")
                    packed.Write(file, at + 8, length);
                at += 12 + length;
            }
            while (name != "IEND");
            Assert.That(at, Is.EqualTo(file.Length));

            m_Stride = 6 * Width;
            m_Rows = new byte[m_Stride * Height];
            packed.Position = 0;
            using var unpacked = new ZLibStream(packed, CompressionMode.Decompress);
            byte[] row = new byte[1 + m_Stride];
            for (int y = 0; y < Height; y++)
            {
                unpacked.ReadExactly(row);
                for (int k = 0; k < m_Stride; k++)
                    m_Rows[y * m_Stride + k] = (byte)(row[1 + k] + Predicted(row[0], y, k));
            }

            Assert.That(unpacked.ReadByte(), Is.EqualTo(-1));
        }

        public int Width { get; }

        public int Height { get; }

        /// <summary>A channel from 0 to 1, from the upper left.</summary>
        public double this[int column, int row, int channel]
        {
            get
            {
                int at = row * m_Stride + 6 * column + 2 * channel;
                return (256 * m_Rows[at] + m_Rows[at + 1]) / 65535.0;
            }
        }

        private int Predicted(byte filter, int y, int k)
        {
            int left = k >= 6 ? m_Rows[y * m_Stride + k - 6] : 0, above = y > 0 ? m_Rows[(y - 1) * m_Stride + k] : 0;
            int corner = k >= 6 && y > 0 ? m_Rows[(y - 1) * m_Stride + k - 6] : 0;
            switch (filter)
            {
                case 0: return 0;
                case 1: return left;
                case 2: return above;
                case 3: return (left + above) / 2;
                default:
                    int guess = left + above - corner, toLeft = Math.Abs(guess - left), toAbove = Math.Abs(guess - above),
                        toCorner = Math.Abs(guess - corner);
                    return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
            }
        }

        private static int Number(byte[] file, int at) => file[at] << 24 | file[at + 1] << 16 | file[at + 2] << 8 | file[at + 3];

        // By the division of polynomials itself, bit by bit.
        private static int Check(byte[] file, int at, int length)
        {
            uint check = 0xFFFFFFFF;
            for (int k = at; k < at + length; k++)
            {
                check ^= file[k];
                for (int bit = 0; bit < 8; bit++)
                    check = (check & 1) != 0 ? 0xEDB88320 ^ (check >> 1) : check >> 1;
            }

            return (int)~check;
        }
    }
}
