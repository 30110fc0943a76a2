using System.Text.Json.Nodes;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Sheets of a wake in a glTF file: a mesh each, one morph target a key frame of the wake's loop.</summary>
/// <param name="loop">The wake.</param>
internal sealed class WakeGlb(WakeLoop loop) : IGlbLoop
{
    private readonly List<int> m_Nodes = [];
    private GlbScene m_Scene;

    /// <inheritdoc/>
    public int Beats => loop.Beats;

    /// <inheritdoc/>
    public void AddTo(GlbScene scene, GlbLooks looks)
    {
        m_Scene = scene;
        int material = looks.Unlit("vortex rings");
        for (int sheet = 0; sheet < loop.SheetCount; sheet++)
            m_Nodes.Add(AddSheet(sheet, material));
    }

    /// <inheritdoc/>
    public void Animate(JsonObject animation, double period)
    {
        JsonArray samplers = animation["samplers"].AsArray(), channels = animation["channels"].AsArray();
        samplers.Add(m_Scene.Cycle(loop.Keys, 1, loop.Beats * period));
        foreach (int node in m_Nodes)
            channels.Add(GlbScene.Channel(samplers.Count - 1, node, "weights"));
    }

    private int AddSheet(int sheet, int material)
    {
        float3[] first = Places(sheet, 0);
        var attributes = new JsonObject
        {
            ["POSITION"] = m_Scene.Buffer.AddVectors(first),
            ["COLOR_0"] = m_Scene.Buffer.AddColours(Array.ConvertAll(loop.Colours(sheet), colour => (Color32)(Color)(Vector4)colour)),
        };
        JsonObject primitive = m_Scene.Primitive(attributes, loop.Triangles(sheet), first.Length, material);
        var targets = new JsonArray();
        for (int key = 1; key < loop.Keys; key++)
        {
            List<float3> moved = [.. Places(sheet, key).Zip(first, (one, other) => one - other)];
            targets.Add(new JsonObject { ["POSITION"] = m_Scene.Buffer.AddVectors(moved) });
        }

        primitive["targets"] = targets;
        string name = $"wake {sheet + 1}";
        return m_Scene.AddNode(name, new JsonObject
        {
            ["name"] = name,
            ["primitives"] = new JsonArray(primitive),
            ["weights"] = GlbScene.NoWeights(loop.Keys - 1),
        });
    }

    private float3[] Places(int sheet, int key) => Array.ConvertAll(loop.Places(sheet, key), FileAxes.ToGltf);
}
