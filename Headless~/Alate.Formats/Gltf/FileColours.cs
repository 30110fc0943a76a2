namespace Alate.Formats;

/// <summary>Colours of file formats, which count light.</summary>
internal static class FileColours
{
    /// <summary>Light of a value of sRGB, 0 to 1.</summary>
    public static double Linear(byte value)
    {
        double encoded = value / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4);
    }
}
