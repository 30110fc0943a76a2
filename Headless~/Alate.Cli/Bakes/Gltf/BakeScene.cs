using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// The parts of a glTF file of a baked insect that all forms have: vertices, primitives by material, the file around them. Metres, Y up,
/// facing +Z.
/// </summary>
internal sealed class BakeScene(InsectBake bake)
{
    private readonly GlbScene m_File = new();
    private readonly JsonArray m_Materials = [];
    private readonly Dictionary<BakedPart, int> m_MaterialOf = [];

    public GlbBuffer Buffer => m_File.Buffer;

    public JsonArray Nodes => m_File.Nodes;

    public JsonArray Animations { get; } = [];

    /// <summary>Positions of a frame.</summary>
    public float3[] Positions(IEnumerable<float3> insect) =>
        insect.Select(position => FileAxes.ToGltf(position) * bake.MetresPerUnit).ToArray();

    /// <summary>Attributes of the vertices at rest.</summary>
    public JsonObject RestAttributes() => Attributes(
        Positions(bake.Surface.Positions.Select(position => (float3)position)), Array.ConvertAll(bake.Surface.Normals, FileAxes.Unit));

    /// <summary>Attributes of the vertices: what never changes beside positions and normals.</summary>
    public JsonObject Attributes(float3[] positions, float3[] normals)
    {
        var attributes = new JsonObject
        {
            ["POSITION"] = Buffer.AddVectors(positions),
            ["NORMAL"] = Buffer.AddVectors(normals),
            ["TEXCOORD_0"] = Buffer.AddPairs(Array.ConvertAll(bake.Surface.Uvs, uv => new float2(uv.x, 1f - uv.y))),
        };
        if (bake.Surface.Parts.Any(part => part.HasColours))
            attributes["COLOR_0"] = Buffer.AddColours(bake.Surface.Colours);
        return attributes;
    }

    /// <summary>A mesh of all parts over the same vertices.</summary>
    /// <param name="attributes">Of every part.</param>
    /// <param name="targets">Shapes of every part; null for none.</param>
    public JsonObject Mesh(JsonObject attributes, JsonArray targets = null)
    {
        var primitives = new JsonArray();
        foreach (BakedPart part in bake.Surface.Parts)
        {
            JsonObject primitive = m_File.Primitive(
                attributes.DeepClone(), SurfaceMesh.Turned(part.Triangles), bake.Surface.VertexCount, MaterialOf(part));
            if (targets != null)
                primitive["targets"] = targets.DeepClone();
            primitives.Add(primitive);
        }

        return new JsonObject { ["name"] = bake.Name, ["primitives"] = primitives };
    }

    /// <summary>Adds a node with a mesh.</summary>
    public int AddMeshNode(JsonObject mesh) => m_File.AddNode(bake.Name, mesh);

    /// <summary>Times of the frames of a clip, and of its first again, seconds.</summary>
    public int Times(BakedClip clip, int count) =>
        Buffer.AddScalars(Enumerable.Range(0, count + 1).Select(key => key / (clip.Frequency * count)).ToArray());

    /// <summary>Writes the file.</summary>
    /// <param name="roots">Nodes of the scene.</param>
    /// <param name="skins">Null for none.</param>
    /// <param name="stream">Where to.</param>
    public void Write(IEnumerable<int> roots, JsonArray skins, Stream stream)
    {
        JsonObject gltf = m_File.Begin(bake.Name, roots);
        gltf["materials"] = m_Materials;
        m_File.AddAccessors(gltf);
        if (skins != null)
            gltf["skins"] = skins;
        if (Animations.Count > 0)
            gltf["animations"] = Animations;
        byte[] binary = m_File.AddBuffer(gltf);
        GlbWriter.Write(gltf, binary, stream);
    }

    private int MaterialOf(BakedPart part)
    {
        if (m_MaterialOf.TryGetValue(part, out int material))
            return material;
        bool isGlass = part.HasColours && part.Triangles.Any(vertex => bake.Surface.Colours[vertex].a < byte.MaxValue);
        m_Materials.Add(GltfMaterial.Of(part.HasColours, isGlass, part.Name));
        m_MaterialOf.Add(part, m_Materials.Count - 1);
        return m_Materials.Count - 1;
    }
}
