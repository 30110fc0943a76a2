namespace Alate.Formats;

/// <summary>Colours of file formats, which count light, and how rough all surfaces are.</summary>
internal static class FileColours
{
    public const double Roughness = 0.75;

    /// <summary>Colour of a membrane that has neither a picture nor colours of its own.</summary>
    public static readonly (double Red, double Green, double Blue) Membrane = (0.62, 0.57, 0.41);

    /// <summary>Light of a value of sRGB, 0 to 1.</summary>
    public static double Linear(byte value)
    {
        double encoded = value / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4);
    }
}
