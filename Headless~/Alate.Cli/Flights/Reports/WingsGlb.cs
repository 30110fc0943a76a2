using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>
/// wings.glb: the body and the wings of an insect, metres, Y up, facing +Z; the last beat as an animation that loops. A wing's mesh is its
/// shape at phase 0, and each further key frame is one morph target.
/// </summary>
internal sealed class WingsGlb
{
    private const int k_KeyFrames = 24;

    private readonly GlbScene m_Scene = new();
    private readonly GlbLooks m_Looks;
    private readonly List<int> m_WingNodes = [];
    private int m_Abdomen;
    private Func<double, float4> m_AbdomenAt;

    private WingsGlb()
    {
        m_Looks = new GlbLooks(m_Scene.Buffer);
    }

    /// <summary>Writes the file.</summary>
    /// <param name="flight">The beat.</param>
    /// <param name="stream">Where to.</param>
    /// <param name="path">A free flight along which the insect moves, beating; null beats on the spot.</param>
    /// <param name="beside">What moves beside an insect on the spot; null for nothing.</param>
    public static void Write(FlightRecord flight, Stream stream, FreeRecord path = null, IGlbLoop beside = null)
    {
        var glb = new WingsGlb();
        InsectAbdomen abdomen = flight.Insect.Abdomen;
        glb.AddPart("body", abdomen == null ? flight.Insect.Body : abdomen.Trunk);
        if (abdomen != null)
            glb.AddAbdomen(flight);
        foreach (RecordedWing wing in flight.Wings)
            glb.AddWing(wing);
        glb.Finish(flight, path, beside, stream);
    }

    // What light passes is a part of its own: a viewer that sorts it against the rest would else spoil the solid part too.
    private int AddPart(string name, SurfaceMesh body)
    {
        float3[] positions = Array.ConvertAll(body.positions, position => FileAxes.ToGltf(position));
        float3[] normals = Array.ConvertAll(body.normals, FileAxes.Unit);
        JsonObject attributes = Attributes(positions, normals, body.colours);
        if (body.uvs != null)
            attributes["TEXCOORD_0"] = m_Scene.Buffer.AddPairs(Array.ConvertAll(body.uvs, uv => new float2(uv.x, 1f - uv.y)));
        var primitives = new JsonArray();
        foreach (IGrouping<bool, int[]> part in SurfaceMesh.Turned(body.triangles).Chunk(3)
            .GroupBy(triangle => IsGlass(triangle, body.colours)))
        {
            int[] indices = part.SelectMany(triangle => triangle).ToArray();
            primitives.Add(
                m_Scene.Primitive(attributes.DeepClone(), indices, positions.Length, m_Looks.Plain(body.colours != null, part.Key)));
        }

        return m_Scene.AddNode(name, new JsonObject { ["name"] = name, ["primitives"] = primitives });
    }

    private void AddAbdomen(FlightRecord flight)
    {
        m_Abdomen = AddPart("abdomen", flight.Insect.Abdomen.Surface);
        float3 hinge = FileAxes.ToGltf(flight.Insect.Abdomen.Hinge);
        m_Scene.Nodes[m_Abdomen]["translation"] = new JsonArray(hinge.x, hinge.y, hinge.z);
        m_AbdomenAt = turns => quaternion.RotateX(flight.AbdomenAt(turns)).value;
    }

    // The mirror image in x turns the same way about x.
    private void Swing(JsonArray samplers, JsonArray channels, int times, IEnumerable<double> turns)
    {
        if (m_AbdomenAt == null)
            return;
        samplers.Add(GlbScene.Sampler(times, m_Scene.Buffer.AddQuadruples(turns.Select(m_AbdomenAt).ToList())));
        channels.Add(GlbScene.Channel(samplers.Count - 1, m_Abdomen, "rotation"));
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
            attributes["TEXCOORD_0"] = m_Scene.Buffer.AddPairs(Array.ConvertAll(surface.uvs, uv => new float2(uv.x, 1f - uv.y)));
        int material = texture == null
            ? m_Looks.Plain(wing.Wing.Colours != null, IsGlass(indices, wing.Wing.Colours))
            : m_Looks.Of(texture.Png, texture.Opacity, wing.Wing.Name);
        JsonObject primitive = m_Scene.Primitive(attributes, indices, rest.Length, material);
        var targets = new JsonArray();
        for (int key = 1; key < k_KeyFrames; key++)
        {
            (float3[] positions, float3[] normals) = Shape(wing, key);
            targets.Add(new JsonObject
            {
                ["POSITION"] = m_Scene.Buffer.AddVectors(positions.Zip(rest, (one, other) => one - other).ToList()),
                ["NORMAL"] = m_Scene.Buffer.AddVectors(normals.Zip(restNormals, (one, other) => one - other).ToList()),
            });
        }

        primitive["targets"] = targets;
        var mesh = new JsonObject
        {
            ["name"] = name,
            ["primitives"] = new JsonArray(primitive),
            ["weights"] = GlbScene.NoWeights(k_KeyFrames - 1),
        };
        m_WingNodes.Add(m_Scene.AddNode(name, mesh));
    }

    private JsonObject Attributes(float3[] positions, float3[] normals, UnityEngine.Color32[] colours)
    {
        var attributes =
            new JsonObject { ["POSITION"] = m_Scene.Buffer.AddVectors(positions), ["NORMAL"] = m_Scene.Buffer.AddVectors(normals) };
        if (colours != null)
            attributes["COLOR_0"] = m_Scene.Buffer.AddColours(colours);
        return attributes;
    }

    private void Finish(FlightRecord flight, FreeRecord path, IGlbLoop beside, Stream stream)
    {
        beside?.AddTo(m_Scene, m_Looks);
        int parts = m_Scene.Nodes.Count;
        var children = new JsonArray(Enumerable.Range(0, parts).Select(k => (JsonNode)k).ToArray());
        m_Scene.Nodes.Add(new JsonObject { ["name"] = flight.Insect.Name, ["children"] = children });
        double period = 1.0 / flight.Wings[0].Frequency;
        JsonObject gltf = m_Scene.Begin(flight.Insect.DisplayName, [parts]);
        JsonObject animation = path == null ? Animation(period, beside?.Beats ?? 1) : Animation(path, parts);
        beside?.Animate(animation, period);
        gltf["animations"] = new JsonArray(animation);
        m_Scene.AddAccessors(gltf);
        byte[] binary = m_Scene.AddBuffer(gltf);
        m_Looks.WriteTo(gltf);
        GlbWriter.Write(gltf, binary, stream);
    }

    private JsonObject Animation(double period, int beats)
    {
        JsonObject sampler = m_Scene.Cycle(k_KeyFrames, beats, period);
        var channels = new JsonArray();
        foreach (int node in m_WingNodes)
            channels.Add(GlbScene.Channel(0, node, "weights"));
        var samplers = new JsonArray(sampler);
        IEnumerable<double> turns = Enumerable.Range(0, beats * k_KeyFrames + 1).Select(key => (double)key / k_KeyFrames);
        Swing(samplers, channels, (int)sampler["input"], turns);
        return new JsonObject { ["name"] = "beat", ["samplers"] = samplers, ["channels"] = channels };
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

        int times = m_Scene.Buffer.AddScalars(path.Moments.Select(at => (float)at.Time).ToArray());
        var samplers = new JsonArray
        {
            GlbScene.Sampler(times, m_Scene.Buffer.AddScalars(weights)),
            GlbScene.Sampler(times, m_Scene.Buffer.AddVectors(path.Moments.Select(at => FileAxes.ToGltf(path.Thorax(at))).ToList())),
            // A mirror image in x turns the other way about y and z.
            GlbScene.Sampler(
                times, m_Scene.Buffer.AddQuadruples(path.Moments.Select(at => at.Rotation.value * new float4(1f, -1f, -1f, 1f)).ToList())),
        };
        var channels = new JsonArray { GlbScene.Channel(1, root, "translation"), GlbScene.Channel(2, root, "rotation") };
        foreach (int node in m_WingNodes)
            channels.Add(GlbScene.Channel(0, node, "weights"));
        Swing(samplers, channels, times, path.Moments.Select(at => at.Phase / (2.0 * Math.PI)));
        return new JsonObject { ["name"] = "flight", ["samplers"] = samplers, ["channels"] = channels };
    }

    private static bool IsGlass(int[] vertices, UnityEngine.Color32[] colours) =>
        colours != null && vertices.Any(vertex => colours[vertex].a < byte.MaxValue);

    private static (float3[] Positions, float3[] Normals) Shape(RecordedWing wing, int key)
    {
        (float3[] positions, float3[] normals) = wing.At((double)key / k_KeyFrames);
        return (Array.ConvertAll(positions, FileAxes.ToGltf), Array.ConvertAll(normals, FileAxes.Unit));
    }
}
