using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Joint transforms of one wing at a time within the last step, in mesh space.</summary>
    internal static unsafe class SkinPalette
    {
        /// <summary>Fills one dual quaternion per joint.</summary>
        /// <param name="pack">The wing's pack.</param>
        /// <param name="target">Lane, rig and frame.</param>
        /// <param name="alpha">Time within the last step, 0 its start, 1 its end.</param>
        /// <param name="palette">[jointCount].</param>
        public static void Evaluate(in WingPack pack, in SkinTarget target, float alpha, DualQuaternion* palette)
        {
            JointPose* before = pack.pose, after = pack.pose;
            if (PackSlots.Span(pack, target.lane, alpha, out int slot, out float blend))
            {
                before = pack.slots + slot * pack.rig.jointCount;
                after = before + pack.rig.jointCount;
            }

            var basis = new MeshBasis(target.frame);
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                float* from = (float*)(before + joint) + target.lane;
                float* to = (float*)(after + joint) + target.lane;
                float4 q0 = Rotation(from), q1 = Rotation(to);
                q1 = math.dot(q0, q1) < 0f ? -q1 : q1;
                var rotation = new quaternion(math.normalize(math.lerp(q0, q1, blend)));
                float3 position = math.lerp(Position(from), Position(to), blend);
                float3 translation = position - math.rotate(rotation, pack.rig.restJoints[joint]);
                palette[joint] = basis.ToMesh(rotation, translation);
            }
        }

        // A JointPose is seven float4: rotation x y z w, position x y z; one lane of each.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Rotation(float* pose) => new float4(pose[0], pose[4], pose[8], pose[12]);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float3 Position(float* pose) => new float3(pose[16], pose[20], pose[24]);

        /// <summary>Takes transforms of the right-wing frame to mesh space, also where the mesh is a left wing.</summary>
        private readonly struct MeshBasis
        {
            private readonly WingFrame m_Frame;
            private readonly quaternion m_Turn;
            private readonly float m_Side;

            public MeshBasis(in WingFrame frame)
            {
                m_Frame = frame;
                m_Side = frame.mirrored ? -1f : 1f;
                m_Turn = new quaternion(new float3x3(frame.axes.c0 * m_Side, frame.axes.c1, frame.axes.c2));
            }

            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            public DualQuaternion ToMesh(quaternion rotation, float3 translation)
            {
                // Mirrored at x = 0 first where the frame is: the vector part is axial, so y and z change sign.
                float4 q = rotation.value * new float4(1f, m_Side, m_Side, 1f);
                quaternion turned = math.mul(math.mul(m_Turn, new quaternion(q)), math.conjugate(m_Turn));
                float3 moved = m_Frame.origin - math.rotate(turned, m_Frame.origin)
                    + m_Frame.length * math.mul(m_Frame.axes, translation);
                return new DualQuaternion(turned, moved);
            }
        }
    }
}
