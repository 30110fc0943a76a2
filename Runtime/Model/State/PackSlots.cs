using Unity.Mathematics;

namespace Alate
{
    /// <summary>Resamples the poses of a step when a wing moves to a pack whose step has other substeps.</summary>
    internal static unsafe class PackSlots
    {
        /// <summary>Floats of a pose in one lane: rotation x y z w, position x y z.</summary>
        private const int k_Floats = 7;

        /// <summary>Writes a wing's poses at the times of the new pack's slots; without a step to read from, its current pose.</summary>
        public static void Resample(in WingPack from, int fromLane, in WingPack to, int lane)
        {
            int joints = to.rig.jointCount;
            if (to.substeps == 0 || from.substeps == 0)
            {
                for (int k = 0; k < joints * WingPack.PoseSlots; k++)
                    Mix((float*)(from.pose + k % joints) + fromLane, (float*)(from.pose + k % joints) + fromLane, 0f, (float*)(to.slots + k) + lane);
                return;
            }

            int last = LastSlot(to);
            for (int slot = 0; slot <= last; slot++)
            {
                float time = math.min(slot * to.slotStride, to.substeps) * (float)from.substeps / to.substeps;
                Span(from, time, out int before, out float blend);
                JointPose* a = from.slots + before * joints;
                for (int joint = 0; joint < joints; joint++)
                {
                    Mix((float*)(a + joint) + fromLane, (float*)(a + joints + joint) + fromLane, blend,
                        (float*)(to.slots + slot * joints + joint) + lane);
                }
            }
        }

        /// <summary>Finds the slots around a time, in substeps of the last step, and the share between them.</summary>
        public static void Span(in WingPack pack, float time, out int slot, out float blend)
        {
            slot = math.min((int)(time / pack.slotStride), LastSlot(pack) - 1);
            int start = slot * pack.slotStride;
            blend = (time - start) / (math.min(start + pack.slotStride, pack.substeps) - start);
        }

        private static int LastSlot(in WingPack pack) => (pack.substeps + pack.slotStride - 1) / pack.slotStride;

        private static void Mix(float* a, float* b, float blend, float* result)
        {
            float dot = 0f;
            for (int c = 0; c < 4; c++)
                dot += a[WingPack.Lanes * c] * b[WingPack.Lanes * c];
            float sign = dot < 0f ? -1f : 1f;
            for (int c = 0; c < k_Floats; c++)
            {
                int at = WingPack.Lanes * c;
                float other = c < 4 ? sign * b[at] : b[at];
                result[at] = a[at] + blend * (other - a[at]);
            }
        }
    }
}
