using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Authoring
{
    /// <summary>The pixels of a picture of one wing: a silhouette, a line drawing or a photo, on plain or transparent ground.</summary>
    /// <remarks>
    /// Places in a picture are in pixels from its top left corner, x to the right and y down, so that the centre of the first pixel lies at
    /// (0.5, 0.5).
    /// </remarks>
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class WingPicture
    {
        /// <summary>Shortest side of a picture, pixels.</summary>
        public const int MinSide = 32;

        /// <summary>Longest side of a picture, pixels.</summary>
        public const int MaxSide = 16384;

        private readonly Color32[] m_Pixels;

        /// <summary>A picture of these pixels.</summary>
        /// <param name="width">Pixels in a row.</param>
        /// <param name="height">Rows.</param>
        /// <param name="pixels">[row * width + column] Rows from top to bottom; kept, not copied.</param>
        /// <exception cref="ArgumentNullException">There are no pixels.</exception>
        /// <exception cref="ArgumentException">The number of pixels is not width × height.</exception>
        /// <exception cref="FormatException">A side is not between <see cref="MinSide"/> and <see cref="MaxSide"/>.</exception>
        public WingPicture(int width, int height, Color32[] pixels)
        {
            if (pixels == null)
                throw new ArgumentNullException(nameof(pixels));
            CheckSize(width, height);
            if (pixels.LongLength != (long)width * height)
            {
                throw new ArgumentException(
                    $"A picture of {width} × {height} pixels needs {(long)width * height} of them, not {pixels.LongLength}.",
                    nameof(pixels));
            }
            Width = width;
            Height = height;
            m_Pixels = pixels;
        }

        /// <summary>Pixels in a row.</summary>
        public int Width { get; }

        /// <summary>Rows.</summary>
        public int Height { get; }

        /// <summary>A picture of shades of grey.</summary>
        /// <param name="width">Pixels in a row.</param>
        /// <param name="height">Rows.</param>
        /// <param name="shades">[row * width + column] Rows from top to bottom; 0 is black.</param>
        /// <exception cref="ArgumentNullException">There are no shades.</exception>
        /// <exception cref="ArgumentException">The number of shades is not width × height.</exception>
        /// <exception cref="FormatException">A side is not between <see cref="MinSide"/> and <see cref="MaxSide"/>.</exception>
        public static WingPicture FromGrey(int width, int height, byte[] shades)
        {
            if (shades == null)
                throw new ArgumentNullException(nameof(shades));
            return new WingPicture(width, height, Array.ConvertAll(shades, shade => new Color32(shade, shade, shade, 255)));
        }

        /// <summary>The picture in a readable texture.</summary>
        /// <exception cref="ArgumentNullException">There is no texture.</exception>
        /// <exception cref="ArgumentException">The texture is not readable.</exception>
        /// <exception cref="FormatException">A side is not between <see cref="MinSide"/> and <see cref="MaxSide"/>.</exception>
        public static WingPicture FromTexture(Texture2D texture)
        {
            if (texture == null)
                throw new ArgumentNullException(nameof(texture));
            if (!texture.isReadable)
            {
                throw new ArgumentException(
                    $"Texture '{texture.name}' is not readable: turn on Read/Write in its import settings.", nameof(texture));
            }
            CheckSize(texture.width, texture.height);
            Color32[] pixels = texture.GetPixels32();
            // Textures begin with their lowest row.
            for (int row = 0; row < texture.height / 2; row++)
                SwapRows(pixels, texture.width, row, texture.height - 1 - row);

            return new WingPicture(texture.width, texture.height, pixels);
        }

        /// <summary>The pixel in a column and a row, both from 0 at the top left.</summary>
        internal Color32 this[int column, int row] => m_Pixels[row * Width + column];

        private static void SwapRows(Color32[] pixels, int width, int a, int b)
        {
            for (int column = 0; column < width; column++)
                (pixels[a * width + column], pixels[b * width + column]) = (pixels[b * width + column], pixels[a * width + column]);
        }

        private static void CheckSize(int width, int height)
        {
            if (width < MinSide || height < MinSide)
                throw new FormatException($"The picture is too small: {width} × {height} pixels; it needs at least {MinSide} × {MinSide}.");
            if (width > MaxSide || height > MaxSide)
                throw new FormatException($"The picture is too large: {width} × {height} pixels; at most {MaxSide} × {MaxSide} are read.");
        }
    }
}
