using System.Text.Json.Nodes;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>
/// A baked insect whose key frames are morph targets: the mesh is the first frame of the first clip, each other frame one target, each clip
/// an animation of weights.
/// </summary>
internal sealed class MorphGlb
{
    private readonly BakeScene m_Scene;
    private readonly JsonArray m_Targets = [];
    private readonly float3[] m_Rest, m_RestNormals;

    private MorphGlb(InsectBake bake, BakePictures pictures)
    {
        m_Scene = new BakeScene(bake, pictures);
        m_Rest = m_Scene.Positions(bake.Clips[0].Frames[0].Positions);
        m_RestNormals = Normals(bake.Clips[0].Frames[0]);
    }

    public static void Write(InsectBake bake, BakePictures pictures, Stream stream) =>
        new MorphGlb(bake, pictures).WriteFile(bake, stream);

    private void WriteFile(InsectBake bake, Stream stream)
    {
        JsonObject attributes = m_Scene.Attributes(m_Rest, m_RestNormals);
        int[] firsts = bake.Clips.Select(AddTargets).ToArray();
        // An insect at rest alone has one frame: a mesh without shapes, that nothing moves.
        bool moves = m_Targets.Count > 0;
        JsonObject mesh = m_Scene.Mesh(attributes, moves ? m_Targets : null);
        if (moves)
            mesh["weights"] = GlbScene.NoWeights(m_Targets.Count);
        int node = m_Scene.AddMeshNode(mesh);
        for (int clip = 0; moves && clip < firsts.Length; clip++)
            m_Scene.Animations.Add(Animation(bake.Clips[clip], firsts[clip], node));
        m_Scene.Write([node], null, stream);
    }

    // Its first target; −1 and the following ones where the first frame is the mesh itself.
    private int AddTargets(BakedClip clip)
    {
        int first = m_Targets.Count == 0 ? -1 : m_Targets.Count;
        foreach (BakedFrame frame in clip.Frames.Skip(first < 0 ? 1 : 0))
        {
            m_Targets.Add(new JsonObject
            {
                ["POSITION"] = m_Scene.Buffer.AddVectors(Difference(m_Scene.Positions(frame.Positions), m_Rest)),
                ["NORMAL"] = m_Scene.Buffer.AddVectors(Difference(Normals(frame), m_RestNormals)),
            });
        }

        return first;
    }

    // Between two key frames the weight passes from one target to the next.
    private JsonObject Animation(BakedClip clip, int first, int node)
    {
        int frames = clip.Frames.Count;
        float[] weights = new float[(frames + 1) * m_Targets.Count];
        for (int key = 0; key <= frames; key++)
        {
            int target = first + key % frames;
            if (target >= 0)
                weights[key * m_Targets.Count + target] = 1f;
        }

        return new JsonObject
        {
            ["name"] = clip.Name,
            ["samplers"] = new JsonArray(GlbScene.Sampler(m_Scene.Times(clip), m_Scene.Buffer.AddScalars(weights))),
            ["channels"] = new JsonArray(GlbScene.Channel(0, node, "weights")),
        };
    }

    private static float3[] Normals(BakedFrame frame) => frame.Normals.Select(FileAxes.Unit).ToArray();

    private static List<float3> Difference(float3[] one, float3[] other) => one.Zip(other, (a, b) => a - b).ToList();
}
