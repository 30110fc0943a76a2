using System.Runtime.CompilerServices;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Reads what a playing scene shows: its renderers, instances, lights and camera.</summary>
internal sealed class SceneReader
{
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
            Behind(camera));
    }

    /// <summary>Light of the scene that is loaded.</summary>
    public static SceneLight LightNow()
    {
        Light[] lit = [.. Resources.FindObjectsOfTypeAll<Light>().Where(light => light.enabled && SceneItems.IsInScene(light.gameObject)
            && light.intensity > 0f)];
        Light sun = RenderSettings.sun != null ? RenderSettings.sun : Array.Find(lit, light => light.type == LightType.Directional);
        IEnumerable<SceneLamp> lamps = lit.Where(light => light.type == LightType.Point)
            .Select(light => new SceneLamp(light.transform.position, LightOf(light), light.range));
        return new SceneLight(
            Shading.Linear(RenderSettings.ambientSkyColor).xyz, Shading.Linear(RenderSettings.ambientEquatorColor).xyz,
            Shading.Linear(RenderSettings.ambientGroundColor).xyz, sun == null ? new float3(0f, 1f, 0f) : -(float3)sun.transform.forward,
            sun == null ? 0f : LightOf(sun), sun != null && sun.shadows != LightShadows.None, [.. lamps]);
    }

    /// <summary>Linear light of what a camera has behind all.</summary>
    public static float3 Behind(Camera camera) => Shading.Linear(camera.backgroundColor).xyz;

    private static float3 LightOf(Light light) => light.intensity * Shading.Linear(light.color).xyz;

    private List<SceneSurface> Surfaces(Camera camera)
    {
        var found = new List<SceneSurface>();
        var skins = new Dictionary<Texture2D, CardSkins>();
        foreach (SceneItem item in SceneItems.Of(camera))
        {
            var shape = MeshShape.Of(item.Mesh, item.Part);
            SceneLook look = m_Looks.Of(item.Material, item.Colour);
            for (int k = 0; k < item.Places.Length; k++)
            {
                MeshShape shown = item.Rows != null ? Loops(item.Map).Shape(shape, item.Rows[k], item.NextRows[k])
                    : item.SkinStart is { } start ? Skins(item.Map, skins).Shape(shape, start)
                    : shape;
                SceneLook tinted = look with { Tint = look.Tint * item.TintOf(k) };
                found.Add(shown.Placed(item.Places[k], tinted) with { CastsShadow = item.CastsShadow });
            }
        }

        return found;
    }

    private BakedLoops Loops(Texture2D map) => m_Loops.GetValue(map, read => new BakedLoops(read));

    // The joints move from frame to frame: the texture is read once a picture.
    private static CardSkins Skins(Texture2D map, Dictionary<Texture2D, CardSkins> skins)
    {
        if (!skins.TryGetValue(map, out CardSkins known))
            skins[map] = known = new CardSkins(map);
        return known;
    }
}
