using System.Runtime.CompilerServices;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Materials of a scene for pictures, with each texture read once.</summary>
internal sealed class SceneLooks
{
    /// <summary>Narrowness of a gleam where a material does not say it, as the shader has it.</summary>
    private const float k_Shine = 24f;

    private readonly ConditionalWeakTable<Texture2D, MippedPicture> m_Pictures = [];

    /// <summary>Look of a material.</summary>
    /// <param name="material">The material.</param>
    /// <param name="tint">Linear light and opacity in place of its own; null for its own.</param>
    public SceneLook Of(Material material, float4? tint) => Plain(material, tint) with
    {
        Picture = PictureOf(material) is { } texture
            ? m_Pictures.GetValue(texture, read => new MippedPicture(read.width, read.height, read.CopyPixels()))
            : null,
    };

    /// <summary>Look of a material without its texture.</summary>
    /// <param name="material">The material.</param>
    /// <param name="tint">Linear light and opacity in place of its own; null for its own.</param>
    public static SceneLook Plain(Material material, float4? tint)
    {
        float shine = Number(material, "_Shine");
        return new SceneLook(
            null, tint ?? Shading.Linear(Tint(material)), Number(material, "_VertexColours") > 0.5f, Number(material, "_Cull") < 0.5f,
            Number(material, "_Translucent") > 0.5f, Number(material, "_Through"), Number(material, "_Gloss"),
            shine > 0f ? shine : k_Shine)
        {
            IsCut = material.IsKeywordEnabled(WingShaders.Cut),
            Underside = material.HasProperty("_Underside") ? Shading.Linear(material.GetColor("_Underside")) : default,
        };
    }

    /// <summary>Texture of a material; null for none.</summary>
    public static Texture2D PictureOf(Material material) =>
        material.SurfaceTexture() is Texture2D texture && texture != null ? texture : null;

    private static float Number(Material material, string name) => material.HasProperty(name) ? material.GetFloat(name) : 0f;

    // White where nobody has set it.
    private static Color Tint(Material material)
    {
        foreach (string name in new[] { "_BaseColor", "_Color" })
        {
            if (material.HasProperty(name) && material.GetColor(name) is { a: > 0f } colour)
                return colour;
        }

        return Color.white;
    }
}
