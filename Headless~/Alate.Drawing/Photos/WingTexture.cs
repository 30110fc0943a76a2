using System.Buffers.Binary;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Drawing;

/// <summary>The colours of a wing as a PNG file, upper row first, for the texture coordinates of its mesh.</summary>
/// <param name="Png">The file.</param>
/// <param name="Width">Pixels in a row.</param>
/// <param name="Height">Rows.</param>
/// <param name="Pixels">Rows from above.</param>
internal sealed record WingTexture(byte[] Png, int Width, int Height, Color32[] Pixels)
{
    /// <summary>A picture that a user has.</summary>
    /// <exception cref="FormatException">It is no PNG file.</exception>
    public static WingTexture Of(byte[] png)
    {
        var file = PngFile.Read(png);
        return new WingTexture(png, file.Width, file.Height, file.Pixels);
    }

    /// <summary>Use of its opacity.</summary>
    public PictureOpacity Opacity { get; } = PictureOpacities.Of(Pixels, Width);

    /// <summary>True where some of it is seen through.</summary>
    public bool IsGlass => Opacity == PictureOpacity.Clear;

    /// <summary>The colour at texture coordinates, blended between the four pixels around; linear light and opacity.</summary>
    public float4 ColourAt(float2 uv)
    {
        float2 place = math.clamp(new float2(uv.x, 1f - uv.y), 0f, 1f) * new float2(Width, Height) - 0.5f, share = math.frac(place);
        var corner = (int2)math.floor(place);
        return math.lerp(
            math.lerp(At(corner), At(corner + new int2(1, 0)), share.x),
            math.lerp(At(corner + new int2(0, 1)), At(corner + 1), share.x), share.y);
    }

    private float4 At(int2 pixel)
    {
        Color32 colour = Pixels[math.clamp(pixel.y, 0, Height - 1) * Width + math.clamp(pixel.x, 0, Width - 1)];
        return new float4(Shading.ToLinear(new float3(colour.r, colour.g, colour.b) / 255f), colour.a / 255f);
    }

    /// <summary>Pixels of a PNG file by its header alone; 0 where it has none.</summary>
    public static long CountPixels(byte[] png)
    {
        const int k_Size = 16;
        return png.Length < k_Size + 8
            ? 0
            : (long)BinaryPrimitives.ReadUInt32BigEndian(png.AsSpan(k_Size)) * BinaryPrimitives.ReadUInt32BigEndian(png.AsSpan(k_Size + 4));
    }
}
