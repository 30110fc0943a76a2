using UnityEngine;

namespace Alate
{
    /// <summary>Use of the opacity of a picture on a wing.</summary>
    internal enum PictureOpacity
    {
        /// <summary>None: all of it is opaque.</summary>
        Solid,

        /// <summary>Outline: the wing is opaque, and clear around.</summary>
        Cut,

        /// <summary>Glass: some of the wing is seen through.</summary>
        Clear,
    }

    /// <summary>Finds out what the opacity of a picture is for.</summary>
    internal static class PictureOpacities
    {
        /// <summary>Opacity from which on a pixel is opaque, and up to which it is clear.</summary>
        private const byte k_Opaque = 250, k_Nothing = 8;

        /// <summary>Pixels by which a blurred outline reaches around what is clear.</summary>
        private const int k_Blur = 2;

        /// <summary>Share of the pixels that are seen from which on a picture is glass.</summary>
        private const double k_Glass = 0.01;

        /// <summary>Opacity of what has no picture.</summary>
        /// <param name="isClear">True where some of it is seen through.</param>
        public static PictureOpacity Of(bool isClear) => isClear ? PictureOpacity.Clear : PictureOpacity.Solid;

        /// <summary>Looks for pixels that are half clear away from what is clear.</summary>
        /// <param name="pixels">Row by row.</param>
        /// <param name="width">Pixels of a row.</param>
        public static PictureOpacity Of(Color32[] pixels, int width)
        {
            int seen = 0, clear = 0, half = 0, glass = 0;
            for (int k = 0; k < pixels.Length; k++)
            {
                byte alpha = pixels[k].a;
                if (alpha <= k_Nothing)
                    clear++;
                else
                    seen++;
                if (alpha <= k_Nothing || alpha >= k_Opaque)
                    continue;
                half++;
                if (!IsAtAnOutline(pixels, width, k))
                    glass++;

                // As many as are enough, however many of the others are seen.
                if (glass > k_Glass * pixels.Length)
                    return PictureOpacity.Clear;
            }

            // A picture without anything clear has no outline.
            if ((clear > 0 ? glass : half) > k_Glass * seen)
                return PictureOpacity.Clear;
            return clear > 0 ? PictureOpacity.Cut : PictureOpacity.Solid;
        }

        private static bool IsAtAnOutline(Color32[] pixels, int width, int pixel)
        {
            int column = pixel % width, row = pixel / width, rows = pixels.Length / width;
            for (int y = row - k_Blur; y <= row + k_Blur; y++)
            {
                for (int x = column - k_Blur; x <= column + k_Blur; x++)
                {
                    // What lies beside the picture is clear, too.
                    if (x < 0 || x >= width || y < 0 || y >= rows || pixels[y * width + x].a <= k_Nothing)
                        return true;
                }
            }

            return false;
        }
    }
}
