using System.Text.Json.Nodes;

namespace Alate.Formats;

/// <summary>The parts of a glTF file that all have: nodes with meshes, their numbers, and the frame around them.</summary>
internal sealed class GlbScene
{
    private const int k_Triangles = 4;

    public GlbBuffer Buffer { get; } = new();

    public JsonArray Nodes { get; } = [];

    public JsonArray Meshes { get; } = [];

    /// <summary>Adds a node with a mesh.</summary>
    public int AddNode(string name, JsonObject mesh)
    {
        Meshes.Add(mesh);
        Nodes.Add(new JsonObject { ["name"] = name, ["mesh"] = Meshes.Count - 1 });
        return Nodes.Count - 1;
    }

    /// <summary>Triangles of a mesh that have one material.</summary>
    public JsonObject Primitive(JsonNode attributes, int[] indices, int vertexCount, int material) => new()
    {
        ["attributes"] = attributes,
        ["indices"] = Buffer.AddIndices(indices, vertexCount),
        ["material"] = material,
        ["mode"] = k_Triangles,
    };

    /// <summary>The weights of a number of shapes, all zero.</summary>
    public static JsonArray NoWeights(int count) => new(Enumerable.Repeat(0, count).Select(zero => (JsonNode)zero).ToArray());

    /// <summary>Numbers over time, straight between its keys.</summary>
    public static JsonObject Sampler(int input, int output) =>
        new() { ["input"] = input, ["output"] = output, ["interpolation"] = "LINEAR" };

    /// <summary>
    /// Weights that pass from one shape to the next and back to the first, which is the mesh itself: a sampler's numbers.
    /// </summary>
    /// <param name="shapes">Shapes of a round; all but the first are targets.</param>
    /// <param name="rounds">Rounds.</param>
    /// <param name="period">Seconds of a round.</param>
    public JsonObject Cycle(int shapes, int rounds, double period)
    {
        int targets = shapes - 1;
        float[] times = new float[rounds * shapes + 1], weights = new float[times.Length * targets];
        for (int key = 0; key < times.Length; key++)
        {
            times[key] = (float)(period * key / shapes);
            if (key % shapes > 0)
                weights[key * targets + key % shapes - 1] = 1f;
        }

        return Sampler(Buffer.AddScalars(times), Buffer.AddScalars(weights));
    }

    /// <summary>A sampler's target: <c>translation</c>, <c>rotation</c> or <c>weights</c> of a node.</summary>
    public static JsonObject Channel(int sampler, int node, string path) =>
        new() { ["sampler"] = sampler, ["target"] = new JsonObject { ["node"] = node, ["path"] = path } };

    /// <summary>Begins the file: its scene of these nodes, all nodes and meshes.</summary>
    public JsonObject Begin(string name, IEnumerable<int> roots) => new()
    {
        ["asset"] = new JsonObject { ["version"] = "2.0", ["generator"] = "Alate Insect Wings" },
        ["scene"] = 0,
        ["scenes"] = new JsonArray(new JsonObject
        {
            ["name"] = name,
            ["nodes"] = new JsonArray(roots.Select(root => (JsonNode)root).ToArray()),
        }),
        ["nodes"] = Nodes,
        ["meshes"] = Meshes,
    };

    /// <summary>Adds what says where the numbers lie.</summary>
    public void AddAccessors(JsonObject gltf)
    {
        gltf["accessors"] = Buffer.Accessors;
        gltf["bufferViews"] = Buffer.Views;
    }

    /// <summary>Adds the length of the numbers, when all are there.</summary>
    /// <returns>The numbers.</returns>
    public byte[] AddBuffer(JsonObject gltf)
    {
        byte[] binary = Buffer.ToArray();
        gltf["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = binary.Length });
        return binary;
    }
}
