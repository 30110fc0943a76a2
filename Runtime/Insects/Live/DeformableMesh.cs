using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate
{
    /// <summary>
    /// Copies a mesh so that each wing's vertices can be written in one piece: vertices in a given order; stream 0 position and normal,
    /// stream 1 tangents where there are any, the next one colours and texture coordinates, and the last one displacements where they are
    /// wanted. Normals and tangents are signed bytes where the device reads them. Bone weights and blend shapes are left out.
    /// </summary>
    internal static class DeformableMesh
    {
        /// <summary>Index of the stream of <see cref="PackedVertex"/>, or of <see cref="SkinnedVertex"/>.</summary>
        public const int VertexStream = 0;

        /// <summary>Index of the stream of tangents.</summary>
        public const int TangentStream = 1;

        /// <summary>
        /// Texture coordinates that hold the displacements: those in which the shaders of URP and HDRP look for precomputed velocities.
        /// </summary>
        public const VertexAttribute DisplacementAttribute = VertexAttribute.TexCoord5;

        private const int k_TexCoords = 8, k_MostOfSixteenBits = 65535;

        /// <summary>Flags of an upload: bounds are set by hand, indices do not change.</summary>
        public const MeshUpdateFlags UploadFlags = MeshUpdateFlags.DontRecalculateBounds | MeshUpdateFlags.DontValidateIndices
            | MeshUpdateFlags.DontNotifyMeshUsers | MeshUpdateFlags.DontResetBoneBounds;

        /// <summary>Returns true where the device reads signed bytes.</summary>
        public static bool CanPack => SystemInfo.SupportsVertexAttributeFormat(VertexAttributeFormat.SNorm8, 4);

        /// <summary>Returns true where the device reads displacements.</summary>
        public static bool CanMove => SystemInfo.SupportsVertexAttributeFormat(VertexAttributeFormat.Float16, 4);

        /// <summary>Makes a copy that is never saved.</summary>
        /// <param name="source">A readable mesh.</param>
        /// <param name="order">[new vertex] The source's vertex; each one once.</param>
        /// <param name="packed">Whether normals and tangents are signed bytes, or floats.</param>
        /// <param name="moves">Whether the vertices have displacements, in place of what the source has there.</param>
        /// <param name="smaller">[submesh] Other triangles, vertices of the source: they follow in the index buffer; or null.</param>
        public static Mesh Build(Mesh source, int[] order, bool packed, bool moves, int[][] smaller = null)
        {
            // Submeshes with base vertices may have more vertices than their indices count to.
            IndexFormat indices = order.Length > k_MostOfSixteenBits ? IndexFormat.UInt32 : source.indexFormat;
            var mesh = new Mesh { name = source.name + " (living)", hideFlags = HideFlags.HideAndDontSave, indexFormat = indices };
            Vector3[] positions = source.vertices;
            Vector3[] normals = source.normals;
            Vector4[] tangents = source.tangents;
            var others = new OtherAttributes(source, tangents.Length > 0 ? TangentStream + 1 : TangentStream, moves);
            List<VertexAttributeDescriptor> layout = Layout(packed, tangents.Length > 0, others.Descriptors);
            int last = others.Words > 0 ? others.Stream + 1 : others.Stream;
            if (moves)
                layout.Add(new VertexAttributeDescriptor(DisplacementAttribute, VertexAttributeFormat.Float16, 4, last));
            mesh.SetVertexBufferParams(order.Length, layout.ToArray());
            if (moves)
                mesh.SetVertexBufferData(new VertexDisplacement[order.Length], 0, 0, order.Length, last, UploadFlags);
            if (packed)
                mesh.SetVertexBufferData(PackedVertices(order, positions, normals), 0, 0, order.Length, VertexStream, UploadFlags);
            else
                mesh.SetVertexBufferData(Vertices(order, positions, normals), 0, 0, order.Length, VertexStream, UploadFlags);
            if (tangents.Length > 0 && packed)
            {
                mesh.SetVertexBufferData(
                    Array.ConvertAll(order, v => Packed(tangents[v], tangents[v].w)), 0, 0, order.Length, TangentStream, UploadFlags);
            }
            else if (tangents.Length > 0)
            {
                mesh.SetVertexBufferData(Array.ConvertAll(order, v => tangents[v]), 0, 0, order.Length, TangentStream, UploadFlags);
            }

            if (others.Words > 0)
                mesh.SetVertexBufferData(others.Pick(order), 0, 0, order.Length * others.Words, others.Stream, UploadFlags);
            CopyTriangles(source, order, mesh, smaller ?? Array.Empty<int[]>());
            mesh.bounds = source.bounds;
            return mesh;
        }

        private static List<VertexAttributeDescriptor> Layout(bool packed, bool tangents, IReadOnlyList<VertexAttributeDescriptor> others)
        {
            var layout = new List<VertexAttributeDescriptor>
            {
                new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3, VertexStream),
                packed
                    ? new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.SNorm8, 4, VertexStream)
                    : new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3, VertexStream),
            };
            if (tangents)
            {
                VertexAttributeFormat format = packed ? VertexAttributeFormat.SNorm8 : VertexAttributeFormat.Float32;
                layout.Add(new VertexAttributeDescriptor(VertexAttribute.Tangent, format, 4, TangentStream));
            }

            layout.AddRange(others);
            return layout;
        }

        private static SkinnedVertex[] Vertices(int[] order, Vector3[] positions, Vector3[] normals)
        {
            var vertices = new SkinnedVertex[order.Length];
            for (int v = 0; v < order.Length; v++)
            {
                vertices[v].position = positions[order[v]];
                if (normals.Length > 0)
                    vertices[v].normal = normals[order[v]];
            }

            return vertices;
        }

        private static PackedVertex[] PackedVertices(int[] order, Vector3[] positions, Vector3[] normals)
        {
            return Array.ConvertAll(
                order, v => new PackedVertex { position = positions[v], normal = normals.Length > 0 ? Packed(normals[v], 0f) : 0 });
        }

        private static int Packed(Vector3 direction, float w) => SignedBytes.Pack(new SoaFloat3(direction.normalized), w).x;

        private static void CopyTriangles(Mesh source, int[] order, Mesh mesh, int[][] smaller)
        {
            int[] place = new int[order.Length];
            for (int v = 0; v < order.Length; v++)
                place[order[v]] = v;
            var indices = new List<int>();
            var parts = new SubMeshDescriptor[source.subMeshCount];
            for (int s = 0; s < parts.Length; s++)
            {
                int[] own = source.GetIndices(s, true);
                parts[s] = new SubMeshDescriptor(indices.Count, own.Length, source.GetTopology(s));
                indices.AddRange(Array.ConvertAll(own, vertex => place[vertex]));
            }

            foreach (int[] own in smaller)
                indices.AddRange(Array.ConvertAll(own, vertex => place[vertex]));
            SetIndices(mesh, indices);
            mesh.subMeshCount = parts.Length;
            for (int s = 0; s < parts.Length; s++)
                mesh.SetSubMesh(s, parts[s]);
        }

        private static void SetIndices(Mesh mesh, List<int> indices)
        {
            mesh.SetIndexBufferParams(indices.Count, mesh.indexFormat);
            if (mesh.indexFormat == IndexFormat.UInt16)
                mesh.SetIndexBufferData(indices.ConvertAll(index => (ushort)index).ToArray(), 0, 0, indices.Count, UploadFlags);
            else
                mesh.SetIndexBufferData(indices.ToArray(), 0, 0, indices.Count, UploadFlags);
        }

        /// <summary>Colours and texture coordinates of a mesh, as 32-bit words side by side.</summary>
        private sealed class OtherAttributes
        {
            private readonly List<Func<int, int, uint>> m_Read = new List<Func<int, int, uint>>();
            private readonly List<int> m_Counts = new List<int>();
            private readonly List<VertexAttributeDescriptor> m_Descriptors = new List<VertexAttributeDescriptor>();

            public OtherAttributes(Mesh source, int stream, bool moves)
            {
                Stream = stream;
                AddColours(source);
                for (int channel = 0; channel < k_TexCoords; channel++)
                {
                    if (!moves || VertexAttribute.TexCoord0 + channel != DisplacementAttribute)
                        AddTexCoords(source, channel);
                }
            }

            public int Stream { get; }

            public int Words { get; private set; }

            public IReadOnlyList<VertexAttributeDescriptor> Descriptors => m_Descriptors;

            public uint[] Pick(int[] order)
            {
                uint[] words = new uint[order.Length * Words];
                int next = 0;
                foreach (int vertex in order)
                {
                    for (int a = 0; a < m_Read.Count; a++)
                    {
                        for (int c = 0; c < m_Counts[a]; c++)
                            words[next++] = m_Read[a](vertex, c);
                    }
                }

                return words;
            }

            private void AddColours(Mesh source)
            {
                if (!source.HasVertexAttribute(VertexAttribute.Color))
                    return;
                if (source.GetVertexAttributeFormat(VertexAttribute.Color) == VertexAttributeFormat.UNorm8)
                {
                    Color32[] bytes = source.colors32;
                    Add(VertexAttribute.Color, VertexAttributeFormat.UNorm8, 4, 1,
                        (v, _) => (uint)(bytes[v].r | bytes[v].g << 8 | bytes[v].b << 16) | (uint)bytes[v].a << 24);
                    return;
                }

                Color[] colours = source.colors;
                Add(VertexAttribute.Color, VertexAttributeFormat.Float32, 4, 4, (v, c) => math.asuint(colours[v][c]));
            }

            private void AddTexCoords(Mesh source, int channel)
            {
                VertexAttribute attribute = VertexAttribute.TexCoord0 + channel;
                if (!source.HasVertexAttribute(attribute))
                    return;
                var coordinates = new List<Vector4>();
                source.GetUVs(channel, coordinates);
                int dimension = source.GetVertexAttributeDimension(attribute);
                Add(attribute, VertexAttributeFormat.Float32, dimension, dimension, (v, c) => math.asuint(coordinates[v][c]));
            }

            private void Add(
                VertexAttribute attribute, VertexAttributeFormat format, int dimension, int words, Func<int, int, uint> read)
            {
                m_Descriptors.Add(new VertexAttributeDescriptor(attribute, format, dimension, Stream));
                m_Read.Add(read);
                m_Counts.Add(words);
                Words += words;
            }
        }
    }
}
