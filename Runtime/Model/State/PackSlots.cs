using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Poses of a wing within its last step: slot 0 is the start, then every <see cref="WingPack.slotStride"/> substeps, and the end.
    /// </summary>
    internal static unsafe class PackSlots
    {
        /// <summary>Floats of a pose in one lane: rotation x y z w, position x y z.</summary>
        private const int k_Floats = 7;

        /// <summary>
        /// Finds the slots around a time of a wing's last step, 0 its start, 1 its end, and the share between them; false before the first
        /// step.
        /// </summary>
        public static bool Span(in WingPack pack, int lane, float alpha, out int slot, out float blend)
        {
            float4 substeps = pack.substeps, strides = pack.slotStride;
            int count = (int)substeps[lane], stride = (int)strides[lane];
            slot = 0;
            blend = 0f;
            if (count == 0)
                return false;
            float time = math.saturate(alpha) * count;
            slot = math.min((int)(time / stride), (count + stride - 1) / stride - 1);
            int start = slot * stride;
            blend = (time - start) / (math.min(start + stride, count) - start);
            return true;
        }

        /// <summary>Keeps the pose at the start of a step, and lays out the slots of its substeps.</summary>
        public static void Begin(ref WingPack pack)
        {
            pack.slotStride = math.floor((pack.substeps + (WingPack.PoseSlots - 2)) / (WingPack.PoseSlots - 1));
            KeepAll(pack, 0);
        }

        /// <summary>Keeps the pose after substep k of the wings that have a slot for it.</summary>
        public static void Keep(in WingPack pack, int k)
        {
            float4 substeps = pack.substeps, strides = pack.slotStride;
            if (math.all(substeps == substeps.x))
            {
                int stride = (int)strides.x;
                if (k % stride == 0 || k == (int)substeps.x)
                    KeepAll(pack, (k + stride - 1) / stride);
                return;
            }

            for (int lane = 0; lane < WingPack.Lanes; lane++)
            {
                int count = (int)substeps[lane], stride = (int)strides[lane];
                if (k <= count && (k % stride == 0 || k == count))
                    KeepLane(pack, (k + stride - 1) / stride, lane);
            }
        }

        private static void KeepAll(in WingPack pack, int slot)
        {
            int joints = pack.rig.jointCount;
            UnsafeUtility.MemCpy(pack.slots + slot * joints, pack.pose, (long)joints * sizeof(JointPose));
        }

        private static void KeepLane(in WingPack pack, int slot, int lane)
        {
            int count = k_Floats * pack.rig.jointCount;
            float* from = (float*)pack.pose + lane, to = (float*)(pack.slots + slot * pack.rig.jointCount) + lane;
            for (int k = 0; k < count; k++)
                to[WingPack.Lanes * k] = from[WingPack.Lanes * k];
        }
    }
}
