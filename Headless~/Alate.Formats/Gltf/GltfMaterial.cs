using System.Text.Json.Nodes;

namespace Alate.Formats;

/// <summary>Materials of glTF files.</summary>
internal static class GltfMaterial
{
    /// <summary>A material. Vertex colours multiply its colour, so that it is white under them; a membrane without any is pale.</summary>
    public static JsonObject Of(bool isPainted, PictureOpacity opacity, string name) => new()
    {
        ["name"] = name,
        ["doubleSided"] = true,
        ["alphaMode"] = opacity switch { PictureOpacity.Clear => "BLEND", PictureOpacity.Cut => "MASK", _ => "OPAQUE" },
        ["pbrMetallicRoughness"] = new JsonObject
        {
            ["baseColorFactor"] = isPainted
                ? new JsonArray(1.0, 1.0, 1.0, 1.0)
                : new JsonArray(FileColours.Membrane.Red, FileColours.Membrane.Green, FileColours.Membrane.Blue, 1.0),
            ["metallicFactor"] = 0.0,
            ["roughnessFactor"] = FileColours.Roughness,
        },
    };
}
