using System.Runtime.InteropServices;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Meshes of a sample that the page has, by numbers. Those that change are sent again.</summary>
internal sealed class SampleMeshes
{
    private const uint k_Whole = 1, k_Coordinates = 2, k_Colours = 4, k_Baked = 8, k_Joints = 16;

    private readonly Dictionary<Mesh, SentMesh> m_Sent = new(ReferenceEqualityComparer.Instance);
    private readonly List<(Mesh Mesh, SentMesh Sent, bool IsWhole)> m_Changed = [];
    private uint m_Count;

    /// <summary>Notes a mesh for the next state.</summary>
    /// <returns>Its number.</returns>
    public uint See(Mesh mesh)
    {
        if (!m_Sent.TryGetValue(mesh, out SentMesh sent))
            m_Sent.Add(mesh, sent = new SentMesh(++m_Count));
        if (sent.IsSeen)
            return sent.Number;
        sent.IsSeen = true;
        ReadOnlySpan<byte> now = mesh.PositionBuffer();
        bool isWhole = sent.Content == null || sent.Content.Length != now.Length || sent.Parts != PartsOf(mesh);
        if (!isWhole && now.SequenceEqual(sent.Content))
            return sent.Number;
        if (isWhole)
            sent.Content = new byte[now.Length];
        now.CopyTo(sent.Content);
        sent.Parts = PartsOf(mesh);
        m_Changed.Add((mesh, sent, isWhole));
        return sent.Number;
    }

    /// <summary>Writes the meshes that have changed and the numbers of those that are gone.</summary>
    public void Write(StateBuffer state)
    {
        state.Add((uint)m_Changed.Count);
        foreach ((Mesh mesh, SentMesh sent, bool isWhole) in m_Changed)
            Write(state, mesh, sent.Number, isWhole);
        Mesh[] gone = [.. m_Sent.Keys.Where(mesh => mesh == null)];
        state.Add((uint)gone.Length);
        foreach (Mesh mesh in gone)
        {
            state.Add(m_Sent[mesh].Number);
            m_Sent.Remove(mesh);
        }

        m_Changed.Clear();
        foreach (SentMesh sent in m_Sent.Values)
            sent.IsSeen = false;
    }

    // Submeshes that are made again have other lengths or places.
    private static int PartsOf(Mesh mesh)
    {
        var parts = new HashCode();
        for (int part = 0; part < mesh.subMeshCount; part++)
        {
            parts.Add(mesh.GetIndexStart(part));
            parts.Add(mesh.GetIndexCount(part));
        }

        return parts.ToHashCode();
    }

    private static void Write(StateBuffer state, Mesh mesh, uint number, bool isWhole)
    {
        bool isReadable = mesh.isReadable;
        mesh.SetReadable(true);
        try
        {
            Vector3[] places = mesh.vertices, normals = mesh.normals;
            MeshShape shape = isWhole ? MeshShape.Of(mesh, 0) : null;
            state.Add(number);
            state.Add(isWhole ? k_Whole | Flag(shape.Coordinates, k_Coordinates) | Flag(shape.Colours, k_Colours)
                | Flag(shape.Baked, k_Baked) | Flag(shape.Joints, k_Joints) : 0u);
            state.Add((uint)places.Length);
            state.Add(isWhole ? (uint)mesh.subMeshCount : 0u);
            state.Add(MemoryMarshal.AsBytes(places.AsSpan()));
            Span<sbyte> packed = state.Add<sbyte>(4 * places.Length);
            packed.Clear();
            for (int v = 0; v < normals.Length; v++)
            {
                float3 unit = 127f * math.normalizesafe(normals[v]);
                (packed[4 * v], packed[4 * v + 1], packed[4 * v + 2]) =
                    ((sbyte)math.round(unit.x), (sbyte)math.round(unit.y), (sbyte)math.round(unit.z));
            }

            if (isWhole)
                Write(state, mesh, shape);
        }
        finally
        {
            mesh.SetReadable(isReadable);
        }
    }

    private static void Write(StateBuffer state, Mesh mesh, MeshShape shape)
    {
        state.Add(MemoryMarshal.AsBytes(shape.Coordinates.AsSpan()));
        state.Add(MemoryMarshal.AsBytes(shape.Colours.AsSpan()));
        state.Add(MemoryMarshal.AsBytes(shape.Baked.AsSpan()));
        state.Add(MemoryMarshal.AsBytes(shape.Joints.AsSpan()));
        for (int part = 0; part < mesh.subMeshCount; part++)
        {
            int[] triangles = mesh.GetTriangles(part);
            state.Add((uint)triangles.Length);
            state.Add(MemoryMarshal.AsBytes(triangles.AsSpan()));
        }
    }

    private static uint Flag<T>(T[] values, uint flag) => values == null ? 0u : flag;

    /// <summary>Copy of a mesh that the page has.</summary>
    private sealed class SentMesh(uint number)
    {
        public uint Number { get; } = number;

        /// <summary>The buffer that holds the positions.</summary>
        public byte[] Content { get; set; }

        /// <summary>Hash of where its submeshes are.</summary>
        public int Parts { get; set; }

        /// <summary>True where the next state has it already.</summary>
        public bool IsSeen { get; set; }
    }
}
