using System.Globalization;

namespace Alate.Drawing;

/// <summary>A bar of a round length, about a sixth of a width, with its length above.</summary>
internal static class ScaleBar
{
    private const int k_Ink = 0x3d3a34;
    private const float k_End = 7f, k_Size = 13f;

    /// <param name="page">Where to.</param>
    /// <param name="corner">Lower left one, units of the page.</param>
    /// <param name="unitsPerMetre">Scale of what is measured.</param>
    /// <param name="width">Of what is measured, units of the page.</param>
    public static void Draw(PixelPage page, float2 corner, float unitsPerMetre, float width)
    {
        double length = Length(width / 6.0 / unitsPerMetre);
        float bar = (float)(length * unitsPerMetre);
        page.Stroke(
            [corner + new float2(0f, -k_End), corner, corner + new float2(bar, 0f), corner + new float2(bar, -k_End)], k_Ink, 2f);
        page.Text(corner.x, corner.y - k_End - 5f, k_Size, Written(length));
    }

    // 1, 2 or 5 times a power of ten, at most a length.
    private static double Length(double most)
    {
        double power = Math.Pow(10.0, Math.Floor(Math.Log10(most * (1.0 + 1e-6))));
        return (most / power >= 5.0 * (1.0 - 1e-6) ? 5.0 : most / power >= 2.0 * (1.0 - 1e-6) ? 2.0 : 1.0) * power;
    }

    private static string Written(double length)
    {
        (double factor, string unit) = length < 0.01 ? (1000.0, "mm") : length < 1.0 ? (100.0, "cm") : (1.0, "m");
        return (factor * length).ToString("0.###", CultureInfo.InvariantCulture) + " " + unit;
    }
}
