using UnityEngine;

namespace Alate.Cli;

/// <summary>One kind of wing of an insect: a surface and its skeleton, from which both sides fly.</summary>
internal sealed class InsectWing
{
    public string Name { get; init; }
    public WingPreset Preset { get; init; }
    public WingSkeleton Skeleton { get; init; }
    public SurfaceMesh Surface { get; init; }

    /// <summary>[vertex] Null where the mesh has none.</summary>
    public Color32[] Colours { get; init; }

    /// <summary>The catalogue's colouring, finer than the vertices' colours; else null.</summary>
    public WingPattern Pattern { get; init; }

    /// <summary>The wing as the catalogue describes it; null for a wing of the user's own.</summary>
    public WingDefinition Definition { get; init; }

    /// <summary>A picture of the user's for the mesh's texture coordinates; else null.</summary>
    public WingTexture Picture { get; init; }

    /// <summary>The picture or the catalogue's painting for the mesh's texture coordinates; null where there is neither.</summary>
    public WingTexture Texture => Picture ?? (Definition == null ? null : WingPainting.Of(Definition));

    /// <summary>Mesh units of one wing length of the pattern.</summary>
    public float PatternScale { get; init; }

    /// <summary>
    /// Origin of the mesh on the right side of the body, metres; null puts the hinge at <see cref="Hinge"/> and turns the wing frame to the
    /// body's.
    /// </summary>
    public float3? Origin { get; init; }

    /// <summary>Hinge on the right side of the body where <see cref="Origin"/> is null, metres.</summary>
    public float3 Hinge { get; init; }

    /// <summary>Placement on the body of a wing of this kind, whose rig gives the wing frame.</summary>
    public WingMount PlacementOf(in WingFrame frame, WingSide side)
    {
        if (Origin == null)
            return new WingMount(Hinge, Preset.WingLength, side);
        const float k_Metre = InsectDefinition.UnitsPerMetre;
        return new WingMount(Origin.Value + frame.origin / k_Metre, frame.length / k_Metre, side);
    }
}
