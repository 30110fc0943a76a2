using System.Globalization;
using UnityEngine;

namespace Alate.Drawing;

/// <summary>Words and a scale bar on a picture of pixels.</summary>
internal sealed class PathLabels(Color32[] pixels, int width)
{
    private const float k_Size = 26f;
    private const int k_Margin = 24, k_BarHeight = 4;

    private static readonly Color32 s_Ink = new Color32(0x33, 0x33, 0x33, 0xff);

    /// <summary>Writes a line in the upper left corner.</summary>
    public void Title(string text) => Write(text, k_Margin, k_Margin + k_Size);

    /// <summary>Draws a bar of a round length, about a sixth of the width, in the lower left corner.</summary>
    /// <param name="pixelsPerMetre">Scale of the picture.</param>
    public void Scale(float pixelsPerMetre)
    {
        double wanted = width / 6.0 / pixelsPerMetre, power = Math.Pow(10, Math.Floor(Math.Log10(wanted)));
        double length = (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1) * power;
        int below = pixels.Length / width - k_Margin, bar = (int)Math.Round(length * pixelsPerMetre);
        Fill(k_Margin, below - k_BarHeight, bar, k_BarHeight);
        Fill(k_Margin, below - 3 * k_BarHeight, k_BarHeight, 2 * k_BarHeight);
        Fill(k_Margin + bar - k_BarHeight, below - 3 * k_BarHeight, k_BarHeight, 2 * k_BarHeight);
        string text = length < 0.01 ? (1000 * length).ToString("0.###", CultureInfo.InvariantCulture) + " mm"
            : length < 1 ? (100 * length).ToString("0.###", CultureInfo.InvariantCulture) + " cm"
            : length.ToString("0.###", CultureInfo.InvariantCulture) + " m";
        Write(text, k_Margin, below - 6 * k_BarHeight);
    }

    private void Write(string text, float left, float baseLine)
    {
        (List<float2[]> strokes, float pen) = Lettering.Strokes(text, k_Size, isBold: false);
        foreach (float2[] stroke in strokes)
        {
            foreach ((int pixel, float covered) in Pen.Cover(
                new int2(width, pixels.Length / width), Array.ConvertAll(stroke, point => point + new float2(left, baseLine)), pen))
            {
                pixels[pixel] = Color.Lerp(pixels[pixel], s_Ink, covered);
            }
        }
    }

    private void Fill(int left, int top, int wide, int high)
    {
        for (int y = Math.Max(top, 0); y < top + high; y++)
        {
            for (int x = Math.Max(left, 0); x < Math.Min(left + wide, width); x++)
                pixels[y * width + x] = s_Ink;
        }
    }
}
