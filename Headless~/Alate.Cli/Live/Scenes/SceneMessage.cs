using System.Runtime.InteropServices;
using System.Text.Json.Nodes;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Message that the page gets once: the insects there are, and the meshes and colours of the one that flies. Axes and winding are glTF's.
/// </summary>
internal static class SceneMessage
{
    /// <summary>Species with their variants, and sliders.</summary>
    public static JsonObject Hello(IEnumerable<InsectDefinition> insects, IEnumerable<ViewSlider> sliders) => new()
    {
        ["type"] = "hello",
        ["species"] = new JsonArray(insects.Select(species => (JsonNode)new JsonObject
        {
            ["name"] = species.Name,
            ["title"] = species.DisplayName,
            ["lands"] = PerchFlight.CanLand(species),
            ["variants"] = new JsonArray(species.Variants.Select(variant => (JsonNode)KnownSpecies.Word(variant)).ToArray()),
        }).ToArray()),
        ["sliders"] = new JsonArray(sliders.Select(slider => (JsonNode)new JsonObject
        {
            ["name"] = slider.Name,
            ["title"] = slider.Title,
            ["unit"] = slider.Unit,
            ["min"] = slider.Min,
            ["max"] = slider.Max,
            ["logarithmic"] = slider.IsLogarithmic,
            ["whole"] = slider.IsWhole,
        }).ToArray()),
    };

    /// <summary>The numbers that are flown now.</summary>
    public static JsonObject Settings(ViewSettings settings) => new()
    {
        ["type"] = "settings",
        ["species"] = settings.Species,
        ["variant"] = KnownSpecies.Word(settings.Variant),
        ["compare"] = settings.IsCompared,
        ["paused"] = settings.IsPaused,
        ["wake"] = settings.HasWake,
        ["landing"] = settings.IsLanding,
        ["values"] = new JsonObject(ViewSlider.All.Select(slider => KeyValuePair.Create(slider.Name, (JsonNode)slider.Of(settings)))),
    };

    /// <summary>The insect.</summary>
    /// <param name="insect">What flies.</param>
    /// <param name="wings">Its wings, in the order of the states.</param>
    /// <param name="columns">The columns, in the order of the states.</param>
    /// <param name="settings">The numbers.</param>
    /// <param name="remark">What the viewer should know; may be empty.</param>
    /// <param name="isOwn">True where the wings are the viewer's own.</param>
    public static JsonObject Scene(Insect insect, IReadOnlyList<RecordedWing> wings, IEnumerable<ComparisonColumn> columns,
        ViewSettings settings, string remark, bool isOwn) => new()
        {
            ["type"] = "scene",
            ["name"] = insect.Name,
            ["title"] = insect.DisplayName,
            ["remark"] = remark,
            ["own"] = isOwn,
            ["reach"] = Math.Max(wings.Max(wing => math.length(wing.Placement.Hinge) + wing.Placement.Length),
            insect.Body.positions.Max(place => math.length(place))),
            ["settings"] = Settings(settings),
            ["columns"] = new JsonArray(columns
            .Select(column => (JsonNode)new JsonObject { ["title"] = column.Title, ["description"] = column.Description }).ToArray()),
            ["body"] = Body(insect.Abdomen?.Trunk ?? insect.Body),
            ["abdomen"] = insect.Abdomen == null ? null : Abdomen(insect.Abdomen),
            ["textures"] = new JsonArray(
            insect.Wings.Select(wing => wing.Texture == null ? null : (JsonNode)Convert.ToBase64String(wing.Texture.Png)).ToArray()),
            ["wings"] = new JsonArray(wings.Select((wing, k) => (JsonNode)Wing(wing, k / 2)).ToArray()),
        };

    /// <summary>Takes what an insect looks like out of a scene.</summary>
    public static JsonObject DetachLook(JsonObject scene)
    {
        var look = new JsonObject();
        foreach (string name in new[] { "body", "abdomen", "textures", "wings" })
        {
            scene.Remove(name, out JsonNode part);
            look[name] = part;
        }

        return look;
    }

    private static JsonObject Body(SurfaceMesh body) => new()
    {
        ["positions"] = Text(Array.ConvertAll(body.positions, place => FileAxes.ToGltf(place))),
        ["normals"] = Text(Array.ConvertAll(body.normals, FileAxes.Unit)),
        ["colours"] = Text(body.colours),
        ["triangles"] = Text(Flipped(body.triangles)),
    };

    private static JsonObject Abdomen(InsectAbdomen abdomen)
    {
        JsonObject said = Body(abdomen.Surface);
        float3 hinge = FileAxes.ToGltf(abdomen.Hinge);
        said["hinge"] = new JsonArray(hinge.x, hinge.y, hinge.z);
        return said;
    }

    private static JsonObject Wing(RecordedWing wing, int texture) => new()
    {
        ["name"] = wing.Wing.Name,
        ["side"] = wing.Placement.IsLeft ? "left" : "right",
        ["texture"] = texture,
        ["glass"] = wing.Wing.Texture?.IsGlass ?? wing.Wing.Colours?.Any(colour => colour.a < byte.MaxValue) ?? false,
        ["cut"] = wing.Wing.Texture?.Opacity == PictureOpacity.Cut,
        ["underside"] = wing.Wing.Pattern is WingPattern pattern ? Underside(pattern) : null,
        ["chains"] = wing.ChainCount,
        ["joints"] = wing.JointsPerChain,
        ["uvs"] = wing.Wing.Surface.uvs == null ? null : Text(Array.ConvertAll(wing.Wing.Surface.uvs, uv => new Vector2(uv.x, 1f - uv.y))),
        ["colours"] = wing.Wing.Texture == null && wing.Wing.Colours != null ? Text(wing.Wing.Colours) : null,
        // A right wing turns once, by the mirror of glTF's axes; a left one and a mesh of a left wing once more each.
        ["triangles"] = Text(wing.IsMeshMirrored == wing.Placement.IsLeft ? Flipped(wing.Triangles) : wing.Triangles),
    };

    private static JsonArray Underside(WingPattern pattern)
    {
        float4 paler = Shading.Linear(pattern.Underside);
        return [paler.x, paler.y, paler.z, paler.w];
    }

    private static string Text<T>(T[] values) where T : struct => Convert.ToBase64String(MemoryMarshal.AsBytes<T>(values));

    private static int[] Flipped(int[] triangles) => SurfaceMesh.Turned(triangles);
}
