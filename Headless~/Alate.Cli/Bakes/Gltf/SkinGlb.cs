using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// A baked insect with joints: each chain of a wing is a chain of nodes that turn and move, and a vertex follows the four joints around it,
/// blended in a straight line. What no wing moves follows the root.
/// </summary>
internal sealed class SkinGlb
{
    private readonly InsectBake m_Bake;
    private readonly BakeScene m_Scene;
    private readonly int[] m_NodeOf, m_ParentOf;
    private int m_Root;

    private SkinGlb(InsectBake bake, BakePictures pictures)
    {
        m_Bake = bake;
        m_Scene = new BakeScene(bake, pictures);
        m_NodeOf = new int[bake.JointCount];
        m_ParentOf = new int[bake.JointCount];
    }

    public static void Write(InsectBake bake, BakePictures pictures, Stream stream) => new SkinGlb(bake, pictures).WriteFile(stream);

    private void WriteFile(Stream stream)
    {
        AddJoints();
        JsonObject attributes = m_Scene.RestAttributes();
        AddInfluences(attributes);
        int mesh = m_Scene.AddMeshNode(m_Scene.Mesh(attributes));
        m_Scene.Nodes[mesh]["skin"] = 0;
        foreach (BakedClip clip in m_Bake.Clips)
            m_Scene.Animations.Add(Animation(clip));
        m_Scene.Write([m_Root, mesh], [Skin()], stream);
    }

    private void AddJoints()
    {
        var wings = new JsonArray();
        m_Root = AddNode("root", default, wings);
        foreach (BakedWing wing in m_Bake.Wings)
        {
            var chains = new JsonArray();
            wings.Add(AddNode(wing.Name, default, chains));
            JsonArray children = null;
            for (int joint = 0; joint < wing.RestJoints.Length; joint++)
            {
                int along = joint % wing.JointsPerChain;
                float3 rest = Place(wing.RestJoints[joint]), parent = along == 0 ? 0f : Place(wing.RestJoints[joint - 1]);
                var below = new JsonArray();
                int node = AddNode($"{wing.Name} {joint / wing.JointsPerChain + 1}.{along + 1}", rest - parent, below);
                (along == 0 ? chains : children).Add(node);
                children = below;
                m_NodeOf[wing.FirstJoint + joint] = node;
                m_ParentOf[wing.FirstJoint + joint] = along == 0 ? -1 : wing.FirstJoint + joint - 1;
            }
        }

        // glTF has no empty lists.
        foreach (JsonObject node in m_Scene.Nodes.OfType<JsonObject>().Where(node => ((JsonArray)node["children"]).Count == 0))
            node.Remove("children");
    }

    private int AddNode(string name, float3 place, JsonArray children)
    {
        m_Scene.Nodes.Add(
            new JsonObject { ["name"] = name, ["translation"] = new JsonArray(place.x, place.y, place.z), ["children"] = children });
        return m_Scene.Nodes.Count - 1;
    }

    // The joints of the skin are the root and then all joints of the wings, as they are counted.
    private JsonObject Skin()
    {
        var binds = new List<float3> { 0f };
        foreach (BakedWing wing in m_Bake.Wings)
            binds.AddRange(wing.RestJoints.Select(rest => -Place(rest)));
        return new JsonObject
        {
            ["name"] = m_Bake.Name,
            ["skeleton"] = m_Root,
            ["inverseBindMatrices"] = m_Scene.Buffer.AddTranslations(binds),
            ["joints"] = new JsonArray(m_NodeOf.Prepend(m_Root).Select(node => (JsonNode)node).ToArray()),
        };
    }

    private void AddInfluences(JsonObject attributes)
    {
        var joints = new int4[m_Bake.Surface.VertexCount];
        float4[] weights = Enumerable.Repeat(new float4(1f, 0f, 0f, 0f), joints.Length).ToArray();
        foreach (BakedWing wing in m_Bake.Wings)
        {
            for (int k = 0; k < wing.Vertices.Length; k++)
            {
                float4 share = wing.VertexWeights[k] / math.csum(wing.VertexWeights[k]);
                weights[wing.Vertices[k]] = share;

                // A joint without weight is the first one, as the format wants it.
                joints[wing.Vertices[k]] = math.select(0, wing.VertexJoints[k] + wing.FirstJoint + 1, share != 0f);
            }
        }

        attributes["JOINTS_0"] = m_Scene.Buffer.AddJoints(joints);
        attributes["WEIGHTS_0"] = m_Scene.Buffer.AddQuadruples(weights, isVertexData: true);
    }

    private JsonObject Animation(BakedClip clip)
    {
        int times = m_Scene.Times(clip, clip.Frames.Count);
        JsonArray samplers = [], channels = [];
        for (int joint = 0; joint < m_NodeOf.Length; joint++)
        {
            var places = new List<float3>();
            var turns = new List<float4>();
            for (int key = 0; key <= clip.Frames.Count; key++)
            {
                (float3 place, quaternion turn) = Local(clip.Frames[key % clip.Frames.Count], joint);
                places.Add(place);
                turns.Add(turns.Count > 0 && math.dot(turns[^1], turn.value) < 0f ? -turn.value : turn.value);
            }

            Add("translation", m_Scene.Buffer.AddVectors(places, isVertexData: false), joint);
            Add("rotation", m_Scene.Buffer.AddQuadruples(turns), joint);
        }

        return new JsonObject { ["name"] = clip.Name, ["samplers"] = samplers, ["channels"] = channels };

        void Add(string path, int output, int joint)
        {
            samplers.Add(GlbScene.Sampler(times, output));
            channels.Add(GlbScene.Channel(samplers.Count - 1, m_NodeOf[joint], path));
        }
    }

    // A joint seen from the one before it on its chain.
    private (float3 Place, quaternion Turn) Local(BakedFrame frame, int joint)
    {
        float3 place = Place(frame.Joints[joint].position);
        quaternion turn = FileAxes.ToGltf(frame.Joints[joint].rotation);
        if (m_ParentOf[joint] < 0)
            return (place, turn);
        quaternion back = math.conjugate(FileAxes.ToGltf(frame.Joints[m_ParentOf[joint]].rotation));
        return (math.rotate(back, place - Place(frame.Joints[m_ParentOf[joint]].position)), math.normalize(math.mul(back, turn)));
    }

    private float3 Place(float3 insect) => FileAxes.ToGltf(insect) * m_Bake.MetresPerUnit;
}
