using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using Alate.Drawing;
using Alate.Formats;
using Unity.Mathematics;

namespace Alate.Cli;

/// <summary>
/// wings.glb: the body and the wings of an insect, metres, Y up, facing +Z; the last beat as an animation that loops. A wing's mesh is its
/// shape at
/// phase 0, and each further key frame is one morph target.
/// </summary>
internal sealed class WingsGlb
{
    private const int k_KeyFrames = 24;

    private readonly GlbBuffer m_Buffer = new();
    private readonly GlbLooks m_Looks;
    private readonly JsonArray m_Nodes = [];
    private readonly JsonArray m_Meshes = [];
    private readonly List<int> m_WingNodes = [];

    private WingsGlb()
    {
        m_Looks = new GlbLooks(m_Buffer);
    }

    /// <summary>Writes the file.</summary>
    /// <param name="flight">The beat.</param>
    /// <param name="stream">Where to.</param>
    /// <param name="path">A free flight along which the insect moves, beating; null beats on the spot.</param>
    public static void Write(FlightRecord flight, Stream stream, FreeRecord path = null)
    {
        var glb = new WingsGlb();
        glb.AddBody(flight.Insect.Body);
        foreach (RecordedWing wing in flight.Wings)
            glb.AddWing(wing);
        GlbWriter.Write(glb.Finish(flight, path), glb.m_Buffer.ToArray(), stream);
    }

    // What light passes is a part of its own: a viewer that sorts it against the rest would else spoil the solid part too.
    private void AddBody(SurfaceMesh body)
    {
        float3[] positions = Array.ConvertAll(body.positions, position => FileAxes.ToGltf(position));
        float3[] normals = Array.ConvertAll(body.normals, FileAxes.Unit);
        JsonObject attributes = Attributes(positions, normals, body.colours);
        if (body.uvs != null)
            attributes["TEXCOORD_0"] = m_Buffer.AddPairs(Array.ConvertAll(body.uvs, uv => new float2(uv.x, 1f - uv.y)));
        var primitives = new JsonArray();
        foreach (IGrouping<bool, int[]> part in SurfaceMesh.Turned(body.triangles).Chunk(3).GroupBy(triangle => IsGlass(triangle, body.colours)))
        {
            int[] indices = part.SelectMany(triangle => triangle).ToArray();
            primitives.Add(Primitive(attributes.DeepClone(), indices, positions.Length, m_Looks.Plain(body.colours != null, part.Key)));
        }

        AddNode("body", new JsonObject { ["name"] = "body", ["primitives"] = primitives });
    }

    private void AddWing(RecordedWing wing)
    {
        string name = $"{wing.Wing.Name} {(wing.Placement.IsLeft ? "left" : "right")}";
        (float3[] rest, float3[] restNormals) = Shape(wing, 0);
        int[] indices = wing.IsMeshMirrored == wing.Placement.IsLeft ? SurfaceMesh.Turned(wing.Triangles) : wing.Triangles;
        SurfaceMesh surface = wing.Wing.Surface;
        WingTexture texture = surface.uvs == null ? null : wing.Wing.Texture;
        JsonObject attributes = Attributes(rest, restNormals, texture == null ? wing.Wing.Colours : null);
        if (texture != null)
            attributes["TEXCOORD_0"] = m_Buffer.AddPairs(Array.ConvertAll(surface.uvs, uv => new float2(uv.x, 1f - uv.y)));
        int material = texture == null ? m_Looks.Plain(wing.Wing.Colours != null, IsGlass(indices, wing.Wing.Colours)) : m_Looks.Of(texture.Png, texture.IsGlass, wing.Wing.Name);
        JsonObject primitive = Primitive(attributes, indices, rest.Length, material);
        var targets = new JsonArray();
        for (int key = 1; key < k_KeyFrames; key++)
        {
            (float3[] positions, float3[] normals) = Shape(wing, key);
            targets.Add(new JsonObject
            {
                ["POSITION"] = m_Buffer.AddVectors(positions.Zip(rest, (one, other) => one - other).ToList()),
                ["NORMAL"] = m_Buffer.AddVectors(normals.Zip(restNormals, (one, other) => one - other).ToList()),
            });
        }

        primitive["targets"] = targets;
        var weights = new JsonArray(Enumerable.Repeat(0, k_KeyFrames - 1).Select(zero => (JsonNode)zero).ToArray());
        var mesh = new JsonObject { ["name"] = name, ["primitives"] = new JsonArray(primitive), ["weights"] = weights };
        m_WingNodes.Add(AddNode(name, mesh));
    }

    private JsonObject Attributes(float3[] positions, float3[] normals, UnityEngine.Color32[] colours)
    {
        var attributes = new JsonObject { ["POSITION"] = m_Buffer.AddVectors(positions), ["NORMAL"] = m_Buffer.AddVectors(normals) };
        if (colours != null)
            attributes["COLOR_0"] = m_Buffer.AddColours(colours);
        return attributes;
    }

    private JsonObject Primitive(JsonNode attributes, int[] indices, int vertexCount, int material) => new()
    {
        ["attributes"] = attributes,
        ["indices"] = m_Buffer.AddIndices(indices, vertexCount),
        ["material"] = material,
        ["mode"] = 4,
    };

    private int AddNode(string name, JsonObject mesh)
    {
        m_Meshes.Add(mesh);
        m_Nodes.Add(new JsonObject { ["name"] = name, ["mesh"] = m_Meshes.Count - 1 });
        return m_Nodes.Count - 1;
    }

    private JsonObject Finish(FlightRecord flight, FreeRecord path)
    {
        int parts = m_Nodes.Count;
        var children = new JsonArray(Enumerable.Range(0, parts).Select(k => (JsonNode)k).ToArray());
        m_Nodes.Add(new JsonObject { ["name"] = flight.Insect.Name, ["children"] = children });
        double period = 1.0 / flight.Wings[0].Frequency;
        JsonArray animations = [path == null ? Animation(period) : Animation(path, parts)];
        var gltf = new JsonObject
        {
            ["asset"] = new JsonObject { ["version"] = "2.0", ["generator"] = "Alate Insect Wings" },
            ["scene"] = 0,
            ["scenes"] = new JsonArray(new JsonObject { ["name"] = flight.Insect.DisplayName, ["nodes"] = new JsonArray(parts) }),
            ["nodes"] = m_Nodes,
            ["meshes"] = m_Meshes,
            ["animations"] = animations,
            ["accessors"] = m_Buffer.Accessors,
            ["bufferViews"] = m_Buffer.Views,
            ["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = m_Buffer.ToArray().Length }),
        };
        m_Looks.WriteTo(gltf);
        return gltf;
    }

    // Between two key frames the weight passes from one target to the next; the last key repeats the first, which is no target at all.
    private JsonObject Animation(double period)
    {
        float[] times = new float[k_KeyFrames + 1];
        float[] weights = new float[(k_KeyFrames + 1) * (k_KeyFrames - 1)];
        for (int key = 0; key <= k_KeyFrames; key++)
        {
            times[key] = (float)(period * key / k_KeyFrames);
            if (key is > 0 and < k_KeyFrames)
                weights[key * (k_KeyFrames - 1) + key - 1] = 1f;
        }

        var sampler = new JsonObject
        {
            ["input"] = m_Buffer.AddScalars(times),
            ["output"] = m_Buffer.AddScalars(weights),
            ["interpolation"] = "LINEAR",
        };
        var channels = new JsonArray();
        foreach (int node in m_WingNodes)
            channels.Add(new JsonObject { ["sampler"] = 0, ["target"] = new JsonObject { ["node"] = node, ["path"] = "weights" } });
        return new JsonObject { ["name"] = "beat", ["samplers"] = new JsonArray(sampler), ["channels"] = channels };
    }

    // The whole flight: where the body is, and between which two shapes of the beat its wings are.
    private JsonObject Animation(FreeRecord path, int root)
    {
        int count = path.Moments.Count;
        float[] weights = new float[count * (k_KeyFrames - 1)];
        for (int k = 0; k < count; k++)
        {
            double at = path.Moments[k].Phase / (2.0 * Math.PI) * k_KeyFrames;
            int before = (int)at % k_KeyFrames, after = (before + 1) % k_KeyFrames;
            float blend = (float)(at - Math.Floor(at));
            if (before > 0)
                weights[k * (k_KeyFrames - 1) + before - 1] = 1f - blend;
            if (after > 0)
                weights[k * (k_KeyFrames - 1) + after - 1] = blend;
        }

        int times = m_Buffer.AddScalars(path.Moments.Select(at => (float)at.Time).ToArray());
        var samplers = new JsonArray
        {
            Sampler(times, m_Buffer.AddScalars(weights)),
            Sampler(times, m_Buffer.AddVectors(path.Moments.Select(at => FileAxes.ToGltf(path.Thorax(at))).ToList())),
            // A mirror image in x turns the other way about y and z.
            Sampler(times, m_Buffer.AddQuadruples(path.Moments.Select(at => at.Rotation.value * new float4(1f, -1f, -1f, 1f)).ToList())),
        };
        var channels = new JsonArray { Channel(1, root, "translation"), Channel(2, root, "rotation") };
        foreach (int node in m_WingNodes)
            channels.Add(Channel(0, node, "weights"));
        return new JsonObject { ["name"] = "flight", ["samplers"] = samplers, ["channels"] = channels };
    }

    private static JsonObject Sampler(int input, int output) => new() { ["input"] = input, ["output"] = output, ["interpolation"] = "LINEAR" };

    private static JsonObject Channel(int sampler, int node, string path) =>
        new() { ["sampler"] = sampler, ["target"] = new JsonObject { ["node"] = node, ["path"] = path } };

    private static bool IsGlass(int[] vertices, UnityEngine.Color32[] colours) =>
        colours != null && vertices.Any(vertex => colours[vertex].a < byte.MaxValue);

    private static (float3[] Positions, float3[] Normals) Shape(RecordedWing wing, int key)
    {
        (float3[] positions, float3[] normals) = wing.At((double)key / k_KeyFrames);
        return (Array.ConvertAll(positions, FileAxes.ToGltf), Array.ConvertAll(normals, FileAxes.Unit));
    }
}
