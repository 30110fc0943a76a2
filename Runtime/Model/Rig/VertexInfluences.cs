using Unity.Mathematics;

namespace Alate
{
    /// <summary>Joints that move each vertex, and vertices that each joint moves (Sec. 4.1).</summary>
    internal sealed class VertexInfluences
    {
        /// <summary>[vertex] The four joints of its cell.</summary>
        public readonly int4[] joints;

        /// <summary>[vertex] Weights of those joints; sum 1.</summary>
        public readonly float4[] weights;

        /// <summary>[joint] Index of its first vertex in <see cref="jointVertices"/>; one more entry holds the end.</summary>
        public readonly int[] jointVertexStarts;

        /// <summary>The vertices of weight ≠ 0, joint by joint, ascending.</summary>
        public readonly int[] jointVertices;

        public VertexInfluences(RestSkeleton rest, CellPoint[] points)
        {
            joints = new int4[points.Length];
            weights = new float4[points.Length];
            jointVertexStarts = new int[rest.joints.Length + 1];
            for (int k = 0; k < points.Length; k++)
            {
                int joint = rest.FirstJoint(points[k].cell), next = joint + rest.jointsPerChain;
                joints[k] = new int4(joint, joint + 1, next, next + 1);
                weights[k] = points[k].Weights;
                for (int c = 0; c < 4; c++)
                    jointVertexStarts[joints[k][c] + 1] += weights[k][c] != 0f ? 1 : 0;
            }

            for (int joint = 0; joint < rest.joints.Length; joint++)
                jointVertexStarts[joint + 1] += jointVertexStarts[joint];
            jointVertices = new int[jointVertexStarts[rest.joints.Length]];
            Fill();
        }

        private void Fill()
        {
            int[] next = (int[])jointVertexStarts.Clone();
            for (int k = 0; k < joints.Length; k++)
            {
                for (int c = 0; c < 4; c++)
                {
                    if (weights[k][c] != 0f)
                        jointVertices[next[joints[k][c]]++] = k;
                }
            }
        }
    }
}
