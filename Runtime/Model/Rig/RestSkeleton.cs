using Unity.Mathematics;

namespace Alate
{
    /// <summary>Skeleton at rest in the wing frame, with the quantities that follow from its joints alone (Sec. 4.1).</summary>
    internal sealed class RestSkeleton
    {
        public readonly int chainCount;
        public readonly int jointsPerChain;
        public readonly float3[] joints;
        public readonly float3[] bones;
        public readonly float3[] boneDirections;
        public readonly float3[] bendAxes;
        public readonly float3[] crossDirections;
        public readonly float[] chainRatio;
        public readonly float[] jointRatio;
        public readonly float3 leadingEdge;

        /// <param name="skeleton">A valid one.</param>
        /// <param name="frame">Its wing frame.</param>
        public RestSkeleton(WingSkeleton skeleton, in WingFrame frame)
        {
            chainCount = skeleton.ChainCount;
            jointsPerChain = skeleton.JointsPerChain;
            joints = new float3[chainCount * jointsPerChain];
            for (int i = 0; i < chainCount; i++)
            {
                for (int j = 0; j < jointsPerChain; j++)
                    joints[i * jointsPerChain + j] = frame.ToWing(skeleton.GetJoint(i, j));
            }

            leadingEdge = math.normalize(joints[jointsPerChain - 1] - joints[0]);
            chainRatio = ChainRatios();
            jointRatio = new float[jointsPerChain];
            for (int j = 0; j < jointsPerChain; j++)
                jointRatio[j] = (float)j / (jointsPerChain - 1);

            bones = new float3[BoneCount];
            boneDirections = new float3[BoneCount];
            bendAxes = new float3[BoneCount];
            crossDirections = new float3[BoneCount];
            for (int bone = 0; bone < BoneCount; bone++)
            {
                int inner = InnerJoint(bone);
                bones[bone] = joints[inner + 1] - joints[inner];
                boneDirections[bone] = math.normalize(bones[bone]);
                bendAxes[bone] = math.normalize(math.cross(boneDirections[bone], new float3(0f, 1f, 0f)));
                crossDirections[bone] = CrossDirection(bone);
            }
        }

        public int BoneCount => chainCount * (jointsPerChain - 1);

        public int CellCount => (chainCount - 1) * (jointsPerChain - 1);

        /// <summary>Index of the joint from which a bone goes out.</summary>
        public int InnerJoint(int bone) => bone / (jointsPerChain - 1) * jointsPerChain + bone % (jointsPerChain - 1);

        /// <summary>A cell's inner joint on its forward chain; cells are numbered like the bones of their forward chains.</summary>
        public int FirstJoint(int cell) => InnerJoint(cell);

        // Eq. 2. Where all chains share one root the distances vanish, and the chains count evenly instead.
        private float[] ChainRatios()
        {
            float[] ratios = new float[chainCount];
            float3 first = joints[0];
            float whole = math.distance(joints[(chainCount - 1) * jointsPerChain], first);
            for (int i = 0; i < chainCount; i++)
            {
                float distance = math.distance(joints[i * jointsPerChain], first);
                ratios[i] = whole > 0f ? distance / whole : (float)i / (chainCount - 1);
            }

            return ratios;
        }

        private float3 CrossDirection(int bone)
        {
            int perChain = jointsPerChain - 1, chain = bone / perChain;
            int before = chain > 0 ? bone - perChain : bone, after = chain < chainCount - 1 ? bone + perChain : bone;
            return Middle(after) - Middle(before);
        }

        private float3 Middle(int bone) => 0.5f * (joints[InnerJoint(bone)] + joints[InnerJoint(bone) + 1]);
    }
}
