using Unity.StandIns;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Cli;

/// <summary>Lists what a playing scene draws.</summary>
internal static class SceneItems
{
    private static readonly int s_Colour = Shader.PropertyToID("_Color");

    /// <summary>Everything that a camera may see now: renderers, then instances.</summary>
    public static IEnumerable<SceneItem> Of(Camera camera)
    {
        foreach (MeshRenderer renderer in Resources.FindObjectsOfTypeAll<MeshRenderer>())
        {
            if (!renderer.enabled || !IsInScene(renderer.gameObject) || !renderer.TryGetComponent(out MeshFilter filter)
                || filter.sharedMesh == null)
            {
                continue;
            }

            Material[] materials = renderer.sharedMaterials;
            for (int part = 0; part < filter.sharedMesh.subMeshCount && materials.Length > 0; part++)
            {
                int slot = Math.Min(part, materials.Length - 1);
                if (materials[slot] != null)
                    yield return Of(renderer, filter.sharedMesh, part, materials[slot], Properties(renderer, slot));
            }
        }

        foreach (DrawnBatch batch in DrawnInstances.Calls ?? [])
        {
            if (batch.Camera == null || batch.Camera == camera)
                yield return Of(batch);
        }
    }

    /// <summary>True for an object that is active in a scene.</summary>
    public static bool IsInScene(GameObject one) => one.activeInHierarchy && one.scene.IsValid();

    private static SceneItem Of(MeshRenderer renderer, Mesh mesh, int part, Material material, MaterialPropertyBlock own)
    {
        var item = new SceneItem(mesh, part, material, [renderer.localToWorldMatrix])
        {
            CastsShadow = renderer.shadowCastingMode != ShadowCastingMode.Off,
            Colour = own.HasColor(s_Colour) ? Shading.Linear(own.GetColor("_Color")) : null,
        };
        return material.IsKeywordEnabled(CardSkins.Keyword) && mesh.HasVertexAttribute(MeshShape.JointAttribute)
            ? item with { SkinStart = own.GetFloat(CardSkins.Start), Tints = [Shading.Linear(own.GetColor("_SkinTint"))] }
            : item;
    }

    private static SceneItem Of(DrawnBatch batch) => new(batch.Mesh, batch.Submesh, batch.Material, batch.Matrices)
    {
        CastsShadow = batch.Parameters.shadowCastingMode != ShadowCastingMode.Off,
        Tints = batch.Properties.GetValueOrDefault("_BakeTint"),
        Rows = batch.Properties.GetValueOrDefault("_BakeRows"),
        NextRows = batch.Properties.GetValueOrDefault("_BakeNextRows"),
    };

    // Those of a material hide those of the whole renderer.
    private static MaterialPropertyBlock Properties(MeshRenderer renderer, int slot)
    {
        var own = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(own, slot);
        if (own.isEmpty)
            renderer.GetPropertyBlock(own);
        return own;
    }
}
