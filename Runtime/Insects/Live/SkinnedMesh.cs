using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Mesh whose vertices know the joints that move them: texture coordinates with the first joint of the cell among those of the mesh,
    /// the number of joints from there to the next chain's, and the place in the cell. A vertex of no wing has the joint −1.
    /// </summary>
    internal static class SkinnedMesh
    {
        /// <summary>Texture coordinates in which the shader looks for the joints.</summary>
        public const int Channel = 6;

        private static readonly Vector4 s_NoJoint = new Vector4(-1f, 0f, 0f, 0f);

        /// <summary>Makes the mesh, which is never saved.</summary>
        /// <param name="template">Source and wings.</param>
        /// <param name="order">[new vertex] The source's vertex; those of each wing in one piece, in the order of its rig.</param>
        public static Mesh Build(MeshTemplate template, int[] order)
        {
            Mesh mesh = DeformableMesh.Build(template.Source, order, packed: false, moves: false);
            mesh.name = template.Source.name + " (joints)";
            Vector3[] normals = mesh.normals;
            var joints = new List<Vector4>(order.Length);
            for (int vertex = 0; vertex < order.Length; vertex++)
                joints.Add(s_NoJoint);
            for (int wing = 0; wing < template.Shapes.Length; wing++)
                SkinnedCorners.Write(template.Shapes[wing].Rig, template.Starts[wing], template.FirstJoints[wing], normals, joints);
            mesh.normals = normals;
            mesh.SetUVs(Channel, joints);
            return mesh;
        }
    }
}
