using System;
using Unity.StandIns;

namespace UnityEngine;

public static class ImageConversion
{
    public static bool LoadImage(this Texture2D tex, byte[] data) => LoadImage(tex, data, false);

    /// <summary>PNG pictures only; Unity also reads JPEG.</summary>
    public static bool LoadImage(this Texture2D tex, byte[] data, bool markNonReadable)
    {
        ArgumentNullException.ThrowIfNull(tex);
        ArgumentNullException.ThrowIfNull(data);
        try
        {
            PngFile png = PngFile.Read(data);
            var upright = new Color32[png.Pixels.Length];
            for (int row = 0; row < png.Height; row++)
                Array.Copy(png.Pixels, row * png.Width, upright, (png.Height - 1 - row) * png.Width, png.Width);
            tex.Become(png.Width, png.Height, upright, !markNonReadable);
            return true;
        }
        catch (FormatException)
        {
            return false;
        }
    }
}
