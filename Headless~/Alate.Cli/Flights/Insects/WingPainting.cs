using System.Collections.Concurrent;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Paintings of the catalogue's wings, each made once.</summary>
internal static class WingPainting
{
    /// <summary>Columns of the painted ones: a scale of a butterfly's wing margin is then three pixels wide.</summary>
    private const int k_Width = 1024;

    private static readonly ConcurrentDictionary<WingPattern, WingTexture> s_Painted = new();

    /// <summary>The painting of a wing of the catalogue; null where it has none.</summary>
    public static WingTexture Of(WingDefinition wing) => wing.Pattern == null ? null : s_Painted.GetOrAdd(wing.Pattern, _ => Paint(wing));

    // Square pixels, in a size that every viewer halves without a rest.
    private static WingTexture Paint(WingDefinition wing)
    {
        double depth = wing.Contour.Front - wing.Contour.Rear;
        int height = 1;
        while (height < k_Width && 1.4 * height < k_Width * depth)
            height *= 2;
        Color32[] pixels = wing.Paint(k_Width, height);
        var picture = new Texture2D(k_Width, height);
        picture.SetPixels32(pixels);
        byte[] png = picture.EncodeToPNG();
        UnityEngine.Object.DestroyImmediate(picture);
        var fromAbove = new Color32[pixels.Length];
        for (int row = 0; row < height; row++)
            pixels.AsSpan((height - 1 - row) * k_Width, k_Width).CopyTo(fromAbove.AsSpan(row * k_Width));
        return new WingTexture(png, k_Width, height, fromAbove);
    }
}
