using System.Text.Json.Nodes;

namespace Alate.Formats;

/// <summary>Materials of glTF files.</summary>
internal static class GltfMaterial
{
    /// <summary>A material. Vertex colours multiply its colour, so that it is white under them; a membrane without any is pale.</summary>
    public static JsonObject Of(bool isPainted, bool isGlass, string name) => new()
    {
        ["name"] = name,
        ["doubleSided"] = true,
        ["alphaMode"] = isGlass ? "BLEND" : "OPAQUE",
        ["pbrMetallicRoughness"] = new JsonObject
        {
            ["baseColorFactor"] = isPainted ? new JsonArray(1.0, 1.0, 1.0, 1.0) : new JsonArray(0.62, 0.57, 0.41, 1.0),
            ["metallicFactor"] = 0.0,
            ["roughnessFactor"] = 0.75,
        },
    };
}
