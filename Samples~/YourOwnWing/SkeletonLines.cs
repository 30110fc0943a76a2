using System.Collections.Generic;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>Skeletons drawn as lines: each chain from its root to its tip, and a cross at each joint.</summary>
    internal static class SkeletonLines
    {
        private const float k_Lift = 0.01f, k_Cross = 0.012f;

        private static readonly Color32 s_Leading = new Color32(220, 60, 40, 255), s_Others = new Color32(40, 70, 160, 255);

        /// <summary>All in one mesh, a little above the wings.</summary>
        public static Mesh Create(IEnumerable<WingSkeleton> skeletons)
        {
            var points = new List<Vector3>();
            var colours = new List<Color32>();
            foreach (WingSkeleton skeleton in skeletons)
            {
                for (int chain = 0; chain < skeleton.ChainCount; chain++)
                {
                    Add(points, skeleton, chain);
                    while (colours.Count < points.Count)
                        colours.Add(chain == 0 ? s_Leading : s_Others);
                }
            }

            int[] indices = new int[points.Count];
            for (int k = 0; k < indices.Length; k++)
                indices[k] = k;
            var mesh = new Mesh { name = "Skeletons", vertices = points.ToArray(), normals = points.ConvertAll(_ => Vector3.up).ToArray() };
            mesh.colors32 = colours.ToArray();
            mesh.SetIndices(indices, MeshTopology.Lines, 0);
            mesh.RecalculateBounds();
            return mesh;
        }

        private static void Add(List<Vector3> points, WingSkeleton skeleton, int chain)
        {
            Vector3 lift = k_Lift * skeleton.UpAxis;
            for (int joint = 0; joint < skeleton.JointsPerChain; joint++)
            {
                Vector3 place = skeleton.GetJoint(chain, joint) + lift;
                if (joint > 0)
                    points.AddRange(new[] { skeleton.GetJoint(chain, joint - 1) + lift, place });
                points.AddRange(new[] { place - k_Cross * Vector3.right, place + k_Cross * Vector3.right });
                points.AddRange(new[] { place - k_Cross * Vector3.forward, place + k_Cross * Vector3.forward });
            }
        }
    }
}
