namespace Alate.Formats;

/// <summary>Colours of file formats, which count light, and how rough all surfaces are.</summary>
internal static class FileColours
{
    public const double Roughness = 0.75;

    /// <summary>Colour of a membrane that has neither a picture nor colours of its own.</summary>
    public static readonly (double Red, double Green, double Blue) Membrane = (0.62, 0.57, 0.41);

    /// <summary>Value of sRGB of a light, of what lies beyond 0 to 1 that of the nearer end.</summary>
    public static byte Encoded(double light)
    {
        double linear = Math.Clamp(light, 0.0, 1.0);
        return (byte)Math.Round(255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.Pow(linear, 1.0 / 2.4) - 0.055));
    }

    /// <summary>Light of a value of sRGB, 0 to 1.</summary>
    public static double Linear(byte value)
    {
        double encoded = value / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4);
    }
}
