using System.Runtime.CompilerServices;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Reads what a playing scene shows: its renderers, instances, lights and camera.</summary>
internal sealed class SceneReader
{
    private static readonly int s_Colour = Shader.PropertyToID("_Color");

    private readonly SceneLooks m_Looks = new();
    private readonly ConditionalWeakTable<Texture2D, BakedLoops> m_Loops = [];

    /// <summary>Shot of what a camera sees now.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="size">Columns and rows of the picture.</param>
    public SceneShot Shot(Camera camera, int2 size)
    {
        Transform eye = camera.transform;
        return new SceneShot(
            new SceneCamera(eye.position, eye.rotation, camera.fieldOfView, camera.nearClipPlane, size), Surfaces(camera), LightNow(),
            Shading.Linear(camera.backgroundColor).xyz);
    }

    private static SceneLight LightNow()
    {
        Light[] lit = [.. Resources.FindObjectsOfTypeAll<Light>().Where(light => light.enabled && IsInScene(light.gameObject)
            && light.intensity > 0f)];
        Light sun = RenderSettings.sun != null ? RenderSettings.sun : Array.Find(lit, light => light.type == LightType.Directional);
        IEnumerable<SceneLamp> lamps = lit.Where(light => light.type == LightType.Point)
            .Select(light => new SceneLamp(light.transform.position, LightOf(light), light.range));
        return new SceneLight(
            Shading.Linear(RenderSettings.ambientSkyColor).xyz, Shading.Linear(RenderSettings.ambientEquatorColor).xyz,
            Shading.Linear(RenderSettings.ambientGroundColor).xyz, sun == null ? new float3(0f, 1f, 0f) : -(float3)sun.transform.forward,
            sun == null ? 0f : LightOf(sun), sun != null && sun.shadows != LightShadows.None, [.. lamps]);
    }

    private static float3 LightOf(Light light) => light.intensity * Shading.Linear(light.color).xyz;

    private static bool IsInScene(GameObject one) => one.activeInHierarchy && one.scene.IsValid();

    private List<SceneSurface> Surfaces(Camera camera)
    {
        var found = new List<SceneSurface>();
        var skins = new Dictionary<Texture, CardSkins>();
        foreach (MeshRenderer renderer in Resources.FindObjectsOfTypeAll<MeshRenderer>())
        {
            if (renderer.enabled && IsInScene(renderer.gameObject) && renderer.TryGetComponent(out MeshFilter filter)
                && filter.sharedMesh != null)
            {
                Add(found, renderer, filter.sharedMesh, skins);
            }
        }

        foreach (DrawnBatch batch in DrawnInstances.Calls ?? [])
        {
            if (batch.Camera == null || batch.Camera == camera)
                Add(found, batch);
        }

        return found;
    }

    private void Add(List<SceneSurface> found, MeshRenderer renderer, Mesh mesh, Dictionary<Texture, CardSkins> skins)
    {
        Material[] materials = renderer.sharedMaterials;
        Matrix4x4 place = renderer.localToWorldMatrix;
        for (int part = 0; part < mesh.subMeshCount && materials.Length > 0; part++)
        {
            int slot = Math.Min(part, materials.Length - 1);
            if (materials[slot] == null)
                continue;
            MaterialPropertyBlock own = Properties(renderer, slot);
            var shape = MeshShape.Of(mesh, part);
            SceneLook look = m_Looks.Of(materials[slot], own.HasColor(s_Colour) ? Shading.Linear(own.GetColor("_Color")) : null);
            if (materials[slot].IsKeywordEnabled(CardSkins.Keyword) && shape.Joints != null)
            {
                shape = Skins(materials[slot].GetTexture(CardSkins.Map), skins).Shape(shape, own.GetFloat(CardSkins.Start));
                look = Tinted(look, Shading.Linear(own.GetColor("_SkinTint")));
            }

            found.Add(shape.Placed(place, look));
        }
    }

    // Those of a material hide those of the whole renderer.
    private static MaterialPropertyBlock Properties(MeshRenderer renderer, int slot)
    {
        var own = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(own, slot);
        if (own.isEmpty)
            renderer.GetPropertyBlock(own);
        return own;
    }

    // The joints move from frame to frame: the texture is read once a picture.
    private static CardSkins Skins(Texture map, Dictionary<Texture, CardSkins> skins)
    {
        if (!skins.TryGetValue(map, out CardSkins known))
            skins[map] = known = new CardSkins((Texture2D)map);
        return known;
    }

    private void Add(List<SceneSurface> found, DrawnBatch batch)
    {
        var shape = MeshShape.Of(batch.Mesh, batch.Submesh);
        bool isBaked = batch.Properties.TryGetValue("_BakeRows", out Vector4[] rows);
        Vector4[] next = batch.Properties.GetValueOrDefault("_BakeNextRows"), tints = batch.Properties.GetValueOrDefault("_BakeTint");
        BakedLoops loops = isBaked ? m_Loops.GetValue((Texture2D)batch.Material.GetTexture("_BakeMap"), map => new BakedLoops(map)) : null;
        SceneLook look = m_Looks.Of(batch.Material, null);
        for (int k = 0; k < batch.Matrices.Length; k++)
        {
            MeshShape shown = isBaked ? loops.Shape(shape, rows[k], next[k]) : shape;
            found.Add(shown.Placed(batch.Matrices[k], tints == null ? look : Tinted(look, tints[k])));
        }
    }

    private static SceneLook Tinted(SceneLook look, float4 tint) => look with { Tint = look.Tint * new float4(tint.xyz, 1f) };
}
