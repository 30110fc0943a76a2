namespace Alate.Drawing;

/// <summary>Look of a wall behind insects, chosen by eye.</summary>
/// <param name="Middle">Colour where it is lit most, sRGB.</param>
/// <param name="Edge">Colour in the corners of the picture, sRGB.</param>
/// <param name="Shade">Share of its light that a shadow takes where nothing passes.</param>
internal readonly record struct BackdropLook(float3 Middle, float3 Edge, float Shade)
{
    /// <summary>A bright wall.</summary>
    public static BackdropLook Studio { get; } = new(Shading.Colour(0xf5f4f1), Shading.Colour(0xb9bec6), 0.5f);

    /// <summary>A dim one, on which pale and glassy wings show.</summary>
    public static BackdropLook Dark { get; } = new(Shading.Colour(0x46515d), Shading.Colour(0x12161c), 0.6f);
}
