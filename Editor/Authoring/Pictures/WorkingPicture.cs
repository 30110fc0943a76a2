using System;
using UnityEngine;

namespace Alate.Authoring
{
    /// <summary>Picture shrunk by a whole factor to a size that is traced quickly, as planes from 0 to 255.</summary>
    internal sealed class WorkingPicture
    {
        /// <summary>Longest side, pixels. A thousandth of a wing is far finer than the mesh of any wing.</summary>
        private const int k_LongestSide = 1400;

        /// <summary>Alpha below which a pixel counts as transparent.</summary>
        private const int k_Transparent = 128;

        public WorkingPicture(WingPicture picture)
        {
            Factor = (Math.Max(picture.Width, picture.Height) + k_LongestSide - 1) / k_LongestSide;
            int width = picture.Width / Factor, height = picture.Height / Factor;
            Red = new PixelPlane(width, height);
            Green = new PixelPlane(width, height);
            Blue = new PixelPlane(width, height);
            Alpha = new PixelPlane(width, height);
            for (int row = 0; row < height; row++)
            {
                for (int column = 0; column < width; column++)
                    Average(picture, column, row);
            }

            HasTransparentGround = TransparentShareOfBorder(picture) > 0.5;
        }

        /// <summary>Number of pixels of the original along a side of one pixel here.</summary>
        public int Factor { get; }

        public PixelPlane Red { get; }

        public PixelPlane Green { get; }

        public PixelPlane Blue { get; }

        public PixelPlane Alpha { get; }

        public int Width => Alpha.width;

        public int Height => Alpha.height;

        /// <summary>True where most of the picture's border is transparent.</summary>
        public bool HasTransparentGround { get; }

        private void Average(WingPicture picture, int column, int row)
        {
            int red = 0, green = 0, blue = 0, alpha = 0;
            for (int y = row * Factor; y < (row + 1) * Factor; y++)
            {
                for (int x = column * Factor; x < (column + 1) * Factor; x++)
                {
                    Color32 pixel = picture[x, y];
                    red += pixel.r;
                    green += pixel.g;
                    blue += pixel.b;
                    alpha += pixel.a;
                }
            }

            float share = 1f / (Factor * Factor);
            Red[column, row] = share * red;
            Green[column, row] = share * green;
            Blue[column, row] = share * blue;
            Alpha[column, row] = share * alpha;
        }

        private static double TransparentShareOfBorder(WingPicture picture)
        {
            int transparent = 0;
            for (int x = 0; x < picture.Width; x++)
                transparent += IsTransparent(picture[x, 0]) + IsTransparent(picture[x, picture.Height - 1]);
            for (int y = 1; y + 1 < picture.Height; y++)
                transparent += IsTransparent(picture[0, y]) + IsTransparent(picture[picture.Width - 1, y]);
            return transparent / (2.0 * (picture.Width + picture.Height - 2));
        }

        private static int IsTransparent(Color32 pixel) => pixel.a < k_Transparent ? 1 : 0;
    }
}
