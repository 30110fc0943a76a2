using System;
using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Linq;
using Alate.Catalogue;
using UnityEngine;

namespace Alate.Cli.Pictures;

/// <summary>The colours of a wing as a PNG file, upper row first, for the texture coordinates of its mesh.</summary>
/// <param name="Png">The file.</param>
/// <param name="IsGlass">True where some of it is seen through.</param>
internal sealed record WingTexture(byte[] Png, bool IsGlass)
{
    /// <summary>Columns of the painted ones: a scale of a butterfly's wing margin is then three pixels wide.</summary>
    private const int k_Width = 1024;

    private static readonly ConcurrentDictionary<WingPattern, WingTexture> s_Painted = new();

    /// <summary>The painting of a wing of the catalogue; null where it has none.</summary>
    public static WingTexture Of(WingDefinition wing) => wing.Pattern == null ? null : s_Painted.GetOrAdd(wing.Pattern, _ => Paint(wing));

    /// <summary>A picture that a user has.</summary>
    public static WingTexture Of(byte[] png, Color32[] pixels) => new(png, pixels.Any(pixel => pixel.a < byte.MaxValue));

    /// <summary>Pixels of a PNG file by its header alone; 0 where it has none.</summary>
    public static long CountPixels(byte[] png)
    {
        const int k_Size = 16;
        return png.Length < k_Size + 8
            ? 0
            : (long)BinaryPrimitives.ReadUInt32BigEndian(png.AsSpan(k_Size)) * BinaryPrimitives.ReadUInt32BigEndian(png.AsSpan(k_Size + 4));
    }

    // Square pixels, in a size that every viewer halves without a rest.
    private static WingTexture Paint(WingDefinition wing)
    {
        double depth = wing.Contour.Front - wing.Contour.Rear;
        int height = 1;
        while (height < k_Width && 1.4 * height < k_Width * depth)
            height *= 2;
        Color32[] pixels = wing.Pattern.Paint(wing.Contour, k_Width, height);
        var picture = new Texture2D(k_Width, height);
        picture.SetPixels32(pixels);
        byte[] png = picture.EncodeToPNG();
        UnityEngine.Object.DestroyImmediate(picture);
        return Of(png, pixels);
    }
}
