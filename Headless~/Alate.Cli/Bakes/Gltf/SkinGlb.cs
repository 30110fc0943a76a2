using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>A baked insect with joints: each chain of a wing is a chain of nodes that turn and move.</summary>
internal sealed class SkinGlb
{
    private readonly InsectBake m_Bake;
    private readonly BakedJoints m_Joints;
    private readonly BakeScene m_Scene;
    private readonly int[] m_NodeOf;
    private int m_Root;

    private SkinGlb(InsectBake bake, BakePictures pictures)
    {
        m_Bake = bake;
        m_Joints = new BakedJoints(bake);
        m_Scene = new BakeScene(bake, pictures);
        m_NodeOf = new int[bake.JointCount];
    }

    public static void Write(InsectBake bake, BakePictures pictures, Stream stream) => new SkinGlb(bake, pictures).WriteFile(stream);

    private void WriteFile(Stream stream)
    {
        AddJoints();
        JsonObject attributes = m_Scene.RestAttributes();
        (int4[] joints, float4[] weights) = m_Joints.Influences();
        attributes["JOINTS_0"] = m_Scene.Buffer.AddJoints(joints);
        attributes["WEIGHTS_0"] = m_Scene.Buffer.AddQuadruples(weights, isVertexData: true);
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
            for (int joint = wing.FirstJoint; joint < wing.FirstJoint + wing.RestJoints.Length; joint++)
            {
                var below = new JsonArray();
                int node = AddNode(m_Joints.Names[joint], m_Joints.RestBehind(joint), below);
                (m_Joints.Parents[joint] < 0 ? chains : children).Add(node);
                children = below;
                m_NodeOf[joint] = node;
            }
        }

        foreach (BakedAbdomen abdomen in m_Bake.Abdomens)
        {
            m_NodeOf[abdomen.Joint] = AddNode(abdomen.Name, m_Joints.Rest[abdomen.Joint], []);
            wings.Add(m_NodeOf[abdomen.Joint]);
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

    // The joints of the skin are the root and then all joints of the bake, as they are counted.
    private JsonObject Skin() => new()
    {
        ["name"] = m_Bake.Name,
        ["skeleton"] = m_Root,
        ["inverseBindMatrices"] = m_Scene.Buffer.AddTranslations([0f, .. m_Joints.Rest.Select(rest => -rest)]),
        ["joints"] = new JsonArray(m_NodeOf.Prepend(m_Root).Select(node => (JsonNode)node).ToArray()),
    };

    private JsonObject Animation(BakedClip clip)
    {
        int times = m_Scene.Times(clip);
        JsonArray samplers = [], channels = [];
        for (int joint = 0; joint < m_NodeOf.Length; joint++)
            Move(m_NodeOf[joint], m_Joints.Keys(clip, joint));
        if (clip.Path != null)
            Move(m_Root, m_Joints.RootKeys(clip));

        return new JsonObject { ["name"] = clip.Name, ["samplers"] = samplers, ["channels"] = channels };

        void Move(int node, (List<float3> Places, List<float4> Turns) keys)
        {
            Add("translation", m_Scene.Buffer.AddVectors(keys.Places, isVertexData: false), node);
            Add("rotation", m_Scene.Buffer.AddQuadruples(keys.Turns), node);
        }

        void Add(string path, int output, int node)
        {
            samplers.Add(GlbScene.Sampler(times, output));
            channels.Add(GlbScene.Channel(samplers.Count - 1, node, path));
        }
    }
}
