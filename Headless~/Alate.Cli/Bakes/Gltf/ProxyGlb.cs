using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>The mesh of an insect at rest, whose second texture coordinates find each vertex in a texture.</summary>
internal static class ProxyGlb
{
    public static void Write(InsectBake bake, BakePictures pictures, BakeLayout layout, Stream stream)
    {
        var scene = new BakeScene(bake, pictures);
        JsonObject attributes = scene.RestAttributes();

        // glTF's coordinates have their origin at the top.
        float2[] places = Enumerable.Range(0, bake.Surface.VertexCount).Select(vertex => Turned(layout.CoordinatesOf(vertex))).ToArray();
        attributes["TEXCOORD_1"] = scene.Buffer.AddPairs(places);
        scene.Write([scene.AddMeshNode(scene.Mesh(attributes))], null, stream);
    }

    private static float2 Turned(float2 place) => new(place.x, 1f - place.y);
}
