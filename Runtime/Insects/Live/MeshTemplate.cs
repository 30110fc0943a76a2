using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// What is made once for a mesh and the wings on it, and shared by all insects that have them: the deformable copy, in which the vertices of each wing lie in one
    /// piece, and a rig a wing.
    /// </summary>
    internal sealed class MeshTemplate
    {
        /// <summary>How far beyond its rest length from the hinge a wing may reach: stretch is below a tenth.</summary>
        private const float k_Reach = 1.1f;

        private readonly Mesh m_Mesh;

        private MeshTemplate(Mesh source, RiggedPart[] shapes)
        {
            Source = source;
            Shapes = shapes;
            Starts = new int[shapes.Length];
            m_Mesh = DeformableMesh.Build(source, Order(source.vertexCount));
            m_Mesh.bounds = Reach(source.bounds);
        }

        /// <summary>The mesh as it was found.</summary>
        public Mesh Source { get; }

        /// <summary>[wing]</summary>
        public RiggedPart[] Shapes { get; }

        /// <summary>[wing] Its first vertex in the copies.</summary>
        public int[] Starts { get; }

        /// <summary>Vertices of the mesh.</summary>
        public int VertexCount => m_Mesh.vertexCount;

        /// <summary>Insects that use it.</summary>
        public int Users { get; set; }

        /// <summary>When the last of them left, seconds of real time.</summary>
        public double UnusedSince { get; set; }

        /// <summary>The authored mesh was changed since: whoever uses the template needs another.</summary>
        public bool IsOutdated { get; set; }

        /// <summary>Makes a template of shapes that do not overlap; it takes over the shapes.</summary>
        public static MeshTemplate Build(Mesh source, RiggedPart[] shapes) => new MeshTemplate(source, shapes);

        /// <summary>A mesh for one insect. Its bounds hold every pose the wings can take.</summary>
        public Mesh CreateCopy()
        {
            Mesh copy = Object.Instantiate(m_Mesh);
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
        }

        // The vertices of each wing in the order of its rig, then all others.
        private int[] Order(int count)
        {
            var order = new List<int>(count);
            var taken = new bool[count];
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
