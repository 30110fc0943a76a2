using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// The parts of a glTF file of a baked insect that all forms have: vertices, primitives by material, the file around them. Metres, Y up,
/// facing +Z.
/// </summary>
internal sealed class BakeScene
{
    private const string k_Colours = "COLOR_0";

    private readonly InsectBake m_Bake;
    private readonly BakePictures m_Pictures;
    private readonly GlbScene m_File = new();
    private readonly GlbLooks m_Looks;
    private readonly Dictionary<BakedPart, int> m_MaterialOf = [];

    /// <param name="bake">The insect.</param>
    /// <param name="pictures">Pictures on its parts.</param>
    public BakeScene(InsectBake bake, BakePictures pictures)
    {
        m_Bake = bake;
        m_Pictures = pictures;
        m_Looks = new GlbLooks(m_File.Buffer);
    }

    public GlbBuffer Buffer => m_File.Buffer;

    public JsonArray Nodes => m_File.Nodes;

    public JsonArray Animations { get; } = [];

    /// <summary>Positions of a frame.</summary>
    public float3[] Positions(IEnumerable<float3> insect) =>
        insect.Select(position => FileAxes.ToGltf(position) * m_Bake.MetresPerUnit).ToArray();

    /// <summary>Attributes of the vertices at rest.</summary>
    public JsonObject RestAttributes() => Attributes(
        Positions(m_Bake.Surface.Positions.Select(position => (float3)position)), Array.ConvertAll(m_Bake.Surface.Normals, FileAxes.Unit));

    /// <summary>Attributes of the vertices: what never changes beside positions and normals.</summary>
    public JsonObject Attributes(float3[] positions, float3[] normals)
    {
        var attributes = new JsonObject
        {
            ["POSITION"] = Buffer.AddVectors(positions),
            ["NORMAL"] = Buffer.AddVectors(normals),
            ["TEXCOORD_0"] = Buffer.AddPairs(Array.ConvertAll(m_Bake.Surface.Uvs, uv => new float2(uv.x, 1f - uv.y))),
        };
        if (m_Bake.Surface.Parts.Any(part => part.HasColours))
            attributes[k_Colours] = Buffer.AddColours(m_Bake.Surface.Colours);
        return attributes;
    }

    /// <summary>A mesh of all parts over the same vertices.</summary>
    /// <param name="attributes">Of every part.</param>
    /// <param name="targets">Shapes of every part; null for none.</param>
    public JsonObject Mesh(JsonObject attributes, JsonArray targets = null)
    {
        var primitives = new JsonArray();
        foreach (BakedPart part in m_Bake.Surface.Parts)
        {
            JsonNode own = attributes.DeepClone();
            if (m_Pictures.Of(part) != null)
                own.AsObject().Remove(k_Colours);
            JsonObject primitive = m_File.Primitive(
                own, SurfaceMesh.Turned(part.Triangles), m_Bake.Surface.VertexCount, MaterialOf(part));
            if (targets != null)
                primitive["targets"] = targets.DeepClone();
            primitives.Add(primitive);
        }

        return new JsonObject { ["name"] = m_Bake.Name, ["primitives"] = primitives };
    }

    /// <summary>Adds a node with a mesh.</summary>
    public int AddMeshNode(JsonObject mesh) => m_File.AddNode(m_Bake.Name, mesh);

    /// <summary>Times of the keys of a clip, seconds.</summary>
    public int Times(BakedClip clip) => Buffer.AddScalars(
        Enumerable.Range(0, clip.KeyCount).Select(key => key / (clip.Frequency * clip.Frames.Count)).ToArray());

    /// <summary>Writes the file.</summary>
    /// <param name="roots">Nodes of the scene.</param>
    /// <param name="skins">Null for none.</param>
    /// <param name="stream">Where to.</param>
    public void Write(IEnumerable<int> roots, JsonArray skins, Stream stream)
    {
        JsonObject gltf = m_File.Begin(m_Bake.Name, roots);
        m_File.AddAccessors(gltf);
        if (skins != null)
            gltf["skins"] = skins;
        if (Animations.Count > 0)
            gltf["animations"] = Animations;
        byte[] binary = m_File.AddBuffer(gltf);
        m_Looks.WriteTo(gltf);
        GlbWriter.Write(gltf, binary, stream);
    }

    private int MaterialOf(BakedPart part)
    {
        if (m_MaterialOf.TryGetValue(part, out int material))
            return material;
        material = m_Pictures.Of(part) is { } picture
            ? m_Looks.Of(picture.Png, picture.Opacity, part.Name)
            : m_Looks.Plain(part.HasColours, BakePictures.IsGlass(m_Bake, part), part.Name);
        m_MaterialOf.Add(part, material);
        return material;
    }
}
