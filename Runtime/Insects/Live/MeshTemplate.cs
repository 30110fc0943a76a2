using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Content made once for a mesh and the wings on it, and shared by all insects that have them: the deformable copy, in which the
    /// vertices of each wing lie in one piece, and a rig for each wing.
    /// </summary>
    internal sealed class MeshTemplate
    {
        /// <summary>Reach of a wing from the hinge over its rest length, at most: stretch is below a tenth.</summary>
        private const float k_Reach = 1.1f;

        private readonly Mesh m_Mesh;
        private readonly int[][] m_Fewer;
        private Mesh m_Moving, m_Skinned;

        /// <summary>Makes a template of shapes that do not overlap; it takes over the shapes.</summary>
        public MeshTemplate(Mesh source, RiggedPart[] shapes)
        {
            Source = source;
            Shapes = shapes;
            Starts = new int[shapes.Length];
            FirstJoints = new int[shapes.Length];
            for (int s = 0; s < shapes.Length; s++)
            {
                FirstJoints[s] = JointCount;
                JointCount += shapes[s].Rig.JointCount;
            }

            IsPacked = DeformableMesh.CanPack;
            m_Fewer = MeshSizes.FewerOf(source, shapes);
            m_Mesh = Build(moves: false);
        }

        /// <summary>Mesh that the template was made of.</summary>
        public Mesh Source { get; }

        /// <summary>[wing] Vertices and rig.</summary>
        public RiggedPart[] Shapes { get; }

        /// <summary>[wing] Index of its first vertex in the copies.</summary>
        public int[] Starts { get; }

        /// <summary>[wing] Its first joint among those of the mesh.</summary>
        public int[] FirstJoints { get; }

        /// <summary>Whole and smaller triangles of the copies; null where no wing has a smaller part.</summary>
        public MeshSizes Sizes { get; private set; }

        /// <summary>Joints of all wings.</summary>
        public int JointCount { get; }

        /// <summary>
        /// Mesh that the graphics card deforms, the same for all insects: at rest, with the joints of each vertex. Its bounds hold every
        /// pose that the wings can take.
        /// </summary>
        public Mesh Skinned
        {
            get
            {
                if (m_Skinned == null)
                {
                    m_Skinned = SkinnedMesh.Build(this, Order(Source.vertexCount));
                    m_Skinned.bounds = m_Mesh.bounds;
                }

                return m_Skinned;
            }
        }

        /// <summary>True where normals and tangents of the copies are signed bytes.</summary>
        public bool IsPacked { get; }

        /// <summary>Vertices of the mesh.</summary>
        public int VertexCount => m_Mesh.vertexCount;

        /// <summary>Number of insects that use the template.</summary>
        public int Users { get; set; }

        /// <summary>Time at which the last user left, seconds of real time.</summary>
        public double UnusedSince { get; set; }

        /// <summary>True where the authored mesh has changed since: users of the template need another.</summary>
        public bool IsOutdated { get; set; }

        /// <summary>Makes a mesh for one insect. Its bounds hold every pose the wings can take.</summary>
        /// <param name="moves">Whether its vertices have displacements, for motion vectors.</param>
        public Mesh CreateCopy(bool moves)
        {
            if (moves && m_Moving == null)
                m_Moving = Build(moves: true);
            Mesh copy = Object.Instantiate(moves ? m_Moving : m_Mesh);
            copy.name = m_Mesh.name;
            copy.hideFlags = HideFlags.HideAndDontSave;
            copy.MarkDynamic();
            return copy;
        }

        /// <summary>Frees mesh and rigs.</summary>
        public void Destroy()
        {
            foreach (RiggedPart shape in Shapes)
                shape.Rig.Release();
            ObjectEnd.Destroy(m_Mesh);
            ObjectEnd.Destroy(m_Moving);
            ObjectEnd.Destroy(m_Skinned);
        }

        private Mesh Build(bool moves)
        {
            Mesh mesh = DeformableMesh.Build(Source, Order(Source.vertexCount), IsPacked, moves, m_Fewer);
            if (m_Fewer != null)
                Sizes ??= new MeshSizes(mesh, m_Fewer);
            mesh.bounds = Reach(Source.bounds);
            return mesh;
        }

        // The vertices of each wing in the order of its rig, then all others.
        private int[] Order(int count)
        {
            var order = new List<int>(count);
            bool[] taken = new bool[count];
            for (int s = 0; s < Shapes.Length; s++)
            {
                Starts[s] = order.Count;
                foreach (int vertex in Shapes[s].Selection.vertices)
                {
                    order.Add(vertex);
                    taken[vertex] = true;
                }
            }

            for (int vertex = 0; vertex < count; vertex++)
            {
                if (!taken[vertex])
                    order.Add(vertex);
            }

            return order.ToArray();
        }

        private Bounds Reach(Bounds bounds)
        {
            Vector3[] positions = Source.vertices;
            foreach (RiggedPart shape in Shapes)
            {
                float3 hinge = shape.Rig.Frame.origin;
                float farthest = 0f;
                foreach (int vertex in shape.Selection.vertices)
                    farthest = math.max(farthest, math.distance(hinge, positions[vertex]));
                bounds.Encapsulate(new Bounds(hinge, Vector3.one * (2f * k_Reach * farthest)));
            }

            return bounds;
        }
    }
}
