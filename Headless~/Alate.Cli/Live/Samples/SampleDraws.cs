using System.Runtime.InteropServices;

namespace Alate.Cli;

/// <summary>
/// Draws of a state: instances of parts of meshes, gathered by what they share. An instance has 24 numbers: three rows of its matrix,
/// its tint, and the rows of its baked loops, or the first of its joints.
/// </summary>
internal sealed class SampleDraws
{
    private const uint k_Skinned = 1, k_Baked = 2, k_Colours = 4, k_TwoSided = 8, k_Translucent = 16,
        k_Shadowless = 32, k_Cut = 64;

    private readonly Dictionary<Draw, List<float4>> m_Draws = [];

    /// <summary>Forgets the instances of the last state.</summary>
    public void Clear()
    {
        foreach (List<float4> instances in m_Draws.Values)
            instances.Clear();
    }

    /// <summary>Adds what a scene draws.</summary>
    /// <param name="item">The item.</param>
    /// <param name="mesh">Number of its mesh.</param>
    /// <param name="maps">Textures that the page has.</param>
    public void Add(SceneItem item, uint mesh, SampleMaps maps)
    {
        SceneLook look = SceneLooks.Plain(item.Material, item.Colour);
        bool isBaked = item.Rows != null, isSkinned = item.SkinStart != null;
        var draw = new Draw
        {
            Mesh = mesh,
            Part = (uint)item.Part,
            Picture = maps.SeePicture(SceneLooks.PictureOf(item.Material)),
            Map = maps.SeeNumbers(item.Map, isSkinned),
            Flags = (isSkinned ? k_Skinned : 0) | (isBaked ? k_Baked : 0) | (look.ShowsColours ? k_Colours : 0)
                | (look.IsTwoSided ? k_TwoSided : 0) | (look.IsTranslucent ? k_Translucent : 0)
                | (item.CastsShadow ? 0 : k_Shadowless) | (look.IsCut ? k_Cut : 0),
            Through = look.Through,
            Gloss = look.Gloss,
            Shine = look.Shine,
            Underside = look.Underside,
        };
        if (!m_Draws.TryGetValue(draw, out List<float4> instances))
            m_Draws.Add(draw, instances = []);
        for (int k = 0; k < item.Places.Length; k++)
        {
            float4x4 rows = math.transpose(item.Places[k]);
            instances.Add(rows.c0);
            instances.Add(rows.c1);
            instances.Add(rows.c2);
            instances.Add(look.Tint * item.TintOf(k));
            instances.Add(isBaked ? item.Rows[k] : new float4(item.SkinStart ?? 0f, 0f, 0f, 0f));
            instances.Add(isBaked ? item.NextRows[k] : default(float4));
        }
    }

    /// <summary>Writes all draws, each with its instances.</summary>
    public void Write(StateBuffer state)
    {
        foreach (Draw unused in m_Draws.Where(pair => pair.Value.Count == 0).Select(pair => pair.Key).ToArray())
            m_Draws.Remove(unused);
        state.Add((uint)m_Draws.Count);
        foreach ((Draw draw, List<float4> instances) in m_Draws)
        {
            state.Add(MemoryMarshal.AsBytes([draw]));
            state.Add((uint)(instances.Count / 6));
            state.Add(MemoryMarshal.AsBytes(CollectionsMarshal.AsSpan(instances)));
        }
    }

    /// <summary>Properties that instances share, as the page reads them.</summary>
    private readonly record struct Draw
    {
        public uint Mesh { get; init; }

        public uint Part { get; init; }

        /// <summary>Texture of its colours; 0 for none.</summary>
        public uint Picture { get; init; }

        /// <summary>Texture of joints or baked loops; 0 for none.</summary>
        public uint Map { get; init; }

        public uint Flags { get; init; }

        public float Through { get; init; }

        public float Gloss { get; init; }

        public float Shine { get; init; }

        public float4 Underside { get; init; }
    }
}
