using UnityEngine;

namespace Alate.Cli;

/// <summary>Part of a mesh that a scene draws, once or in instances.</summary>
/// <param name="Mesh">The mesh.</param>
/// <param name="Part">Its submesh.</param>
/// <param name="Material">Its material.</param>
/// <param name="Places">[instance] From the mesh to the scene.</param>
internal sealed record SceneItem(Mesh Mesh, int Part, Material Material, Matrix4x4[] Places)
{
    /// <summary>True where it stands in the way of the sun.</summary>
    public bool CastsShadow { get; init; } = true;

    /// <summary>Linear light and opacity in place of the material's own; null for that.</summary>
    public float4? Colour { get; init; }

    /// <summary>[instance] Linear light by which it is multiplied; null for none.</summary>
    public Vector4[] Tints { get; init; }

    /// <summary>First joint where the graphics card deforms the mesh; null where it does not.</summary>
    public float? SkinStart { get; init; }

    /// <summary>
    /// [instance] Rows of baked loops before and after, how far the phase lies between them, and the share of the next loop; null where
    /// nothing is baked.
    /// </summary>
    public Vector4[] Rows { get; init; }

    /// <summary>[instance] Rows of the next loop, and how far the phase lies between them.</summary>
    public Vector4[] NextRows { get; init; }

    /// <summary>Texture with joints or baked loops; null for none.</summary>
    public Texture2D Map => (Texture2D)(Rows != null ? Material.GetTexture(BakedLoops.Map)
        : SkinStart != null ? Material.GetTexture(CardSkins.Map) : null);

    /// <summary>Linear light and opacity by which an instance is multiplied beside those of the material.</summary>
    public float4 TintOf(int instance) => Tints == null ? 1f : new float4(((float4)Tints[instance]).xyz, 1f);
}
