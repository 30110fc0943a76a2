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
            var png = PngFile.Read(data);
            tex.Become(png.Width, png.Height, UpsideDown(png.Width, png.Height, png.Pixels), !markNonReadable);
            return true;
        }
        catch (FormatException)
        {
            return false;
        }
    }

    public static byte[] EncodeToPNG(this Texture2D tex) =>
        PngWriter.Write(tex.width, tex.height, UpsideDown(tex.width, tex.height, tex.GetPixels32()));

    // Textures begin with their lowest row, PNG pictures with their highest.
    private static Color32[] UpsideDown(int width, int height, Color32[] pixels)
    {
        var turned = new Color32[pixels.Length];
        for (int row = 0; row < height; row++)
            Array.Copy(pixels, row * width, turned, (height - 1 - row) * width, width);
        return turned;
    }
}
