using System.Collections.Generic;

namespace UnityEngine;

/// <summary>
/// Properties of Unity's own shaders and the package's, as far as materials are tested with them; null accepts every name.
/// </summary>
internal static class ShaderProperties
{
    private static readonly Dictionary<string, string[]> s_Known = new()
    {
        ["Standard"] = ["_MainTex", "_Color", "_Glossiness", "_Mode", "_SrcBlend", "_DstBlend", "_ZWrite", "_Cutoff", "_Metallic"],
        ["Universal Render Pipeline/Lit"] =
        [
            "_BaseMap", "_BaseColor", "_Smoothness", "_Cull", "_Surface", "_Blend", "_AlphaClip", "_AlphaToMask", "_Cutoff", "_SrcBlend",
            "_DstBlend", "_ZWrite", "_MainTex", "_Color",
        ],
        ["HDRP/Lit"] =
        [
            "_BaseColorMap", "_BaseColor", "_Smoothness", "_DoubleSidedEnable", "_CullMode", "_CullModeForward", "_DoubleSidedConstants",
            "_SurfaceType",
            "_AlphaCutoffEnable", "_AlphaCutoff", "_ZTestDepthEqualForOpaque", "_TransparentZWrite", "_AlphaSrcBlend", "_AlphaDstBlend",
            "_SrcBlend", "_DstBlend", "_ZWrite", "_MainTex", "_Color",
        ],
        ["Alate/Wing"] =
        [
            "_MainTex", "_Color", "_Underside", "_VertexColours", "_Through", "_Gloss", "_Shine", "_Cull", "_Translucent", "_Cut",
            "_AlphaToMask", "_SrcBlend", "_DstBlend", "_ZWrite", "_BakeMap", "_SkinMap", "_SkinLast",
        ],
    };

    public static IReadOnlyCollection<string> Of(string shader) => s_Known.GetValueOrDefault(shader);

    /// <summary>Property of Material.mainTexture: the one marked [MainTexture], or the one of that name.</summary>
    public static string MainTexture(string shader) =>
        shader switch { "Universal Render Pipeline/Lit" => "_BaseMap", "HDRP/Lit" => "_BaseColorMap", _ => "_MainTex" };

    /// <summary>Property of Material.color, likewise.</summary>
    public static string MainColour(string shader) => shader is "Universal Render Pipeline/Lit" or "HDRP/Lit" ? "_BaseColor" : "_Color";
}
