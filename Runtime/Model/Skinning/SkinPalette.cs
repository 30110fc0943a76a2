using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Joint transforms of one wing at a time within the last step, in mesh space, four joints at once: lane = joint.</summary>
    internal static unsafe class SkinPalette
    {
        private const int k_Lanes = 4;

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
            int count = pack.rig.jointCount;
            for (int first = 0; first < count; first += k_Lanes)
            {
                int4 joints = math.min(first + new int4(0, 1, 2, 3), count - 1);
                Pose(before, target.lane, joints, out SoaQuaternion rotation, out SoaFloat3 position);
                Pose(after, target.lane, joints, out SoaQuaternion end, out SoaFloat3 endPosition);
                rotation = Between(rotation, end, blend);
                position += (endPosition - position) * blend;
                basis.ToMesh(ref rotation, position, Rest(pack.rig.restJoints, joints), out SoaFloat3 translation);
                Write(rotation, translation, palette + first, math.min(count - first, k_Lanes));
            }
        }

        // A JointPose is seven float4: rotation x y z w, position x y z; one lane of each.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Pose(JointPose* poses, int lane, int4 joints, out SoaQuaternion rotation, out SoaFloat3 position)
        {
            float* a = (float*)(poses + joints.x) + lane, b = (float*)(poses + joints.y) + lane;
            float* c = (float*)(poses + joints.z) + lane, d = (float*)(poses + joints.w) + lane;
            rotation.v.x = new float4(a[0], b[0], c[0], d[0]);
            rotation.v.y = new float4(a[4], b[4], c[4], d[4]);
            rotation.v.z = new float4(a[8], b[8], c[8], d[8]);
            rotation.w = new float4(a[12], b[12], c[12], d[12]);
            position.x = new float4(a[16], b[16], c[16], d[16]);
            position.y = new float4(a[20], b[20], c[20], d[20]);
            position.z = new float4(a[24], b[24], c[24], d[24]);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 Rest(float3* joints, int4 at)
        {
            float3 a = joints[at.x], b = joints[at.y], c = joints[at.z], d = joints[at.w];
            return new SoaFloat3(new float4(a.x, b.x, c.x, d.x), new float4(a.y, b.y, c.y, d.y), new float4(a.z, b.z, c.z, d.z));
        }

        // The shortest way.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaQuaternion Between(SoaQuaternion a, SoaQuaternion b, float share)
        {
            float4 sign = SoaMath.Sign(SoaFloat3.Dot(a.v, b.v) + a.w * b.w);
            return SoaQuaternion.Normalize(new SoaQuaternion(a.v + (b.v * sign - a.v) * share, a.w + (b.w * sign - a.w) * share));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Write(SoaQuaternion rotation, SoaFloat3 translation, DualQuaternion* palette, int count)
        {
            SoaFloat3 dual = 0.5f * (translation * rotation.w + SoaFloat3.Cross(translation, rotation.v));
            float4 last = -0.5f * SoaFloat3.Dot(translation, rotation.v);
            float4x4 reals = math.transpose(new float4x4(rotation.v.x, rotation.v.y, rotation.v.z, rotation.w));
            float4x4 duals = math.transpose(new float4x4(dual.x, dual.y, dual.z, last));
            palette[0] = new DualQuaternion { real = reals.c0, dual = duals.c0 };
            if (count > 1)
                palette[1] = new DualQuaternion { real = reals.c1, dual = duals.c1 };
            if (count > 2)
                palette[2] = new DualQuaternion { real = reals.c2, dual = duals.c2 };
            if (count > 3)
                palette[3] = new DualQuaternion { real = reals.c3, dual = duals.c3 };
        }

        /// <summary>Takes transforms of the right-wing frame to mesh space, also where the mesh is a left wing.</summary>
        private readonly struct MeshBasis
        {
            private readonly float3 m_Origin;
            private readonly float3x3 m_Axes, m_Turn;

            public MeshBasis(in WingFrame frame)
            {
                m_Origin = frame.origin;
                m_Axes = frame.axes * frame.length;

                // Where the frame is a mirror image, axes of turning change their sense.
                m_Turn = frame.mirrored ? -frame.axes : frame.axes;
            }

            /// <summary>Turns a rotation into mesh space, and finds the translation that goes with it.</summary>
            /// <param name="rotation">Of the wing's frame; then of the mesh.</param>
            /// <param name="position">Joints, wing frame.</param>
            /// <param name="rest">Joints at rest, wing frame.</param>
            /// <param name="translation">Mesh space.</param>
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            public void ToMesh(ref SoaQuaternion rotation, SoaFloat3 position, SoaFloat3 rest, out SoaFloat3 translation)
            {
                rotation.v = Times(m_Turn, rotation.v);
                var origin = new SoaFloat3(m_Origin);
                translation = origin + Times(m_Axes, position) - SoaQuaternion.Rotate(rotation, origin + Times(m_Axes, rest));
            }

            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            private static SoaFloat3 Times(float3x3 m, SoaFloat3 v) => new SoaFloat3(
                m.c0.x * v.x + m.c1.x * v.y + m.c2.x * v.z,
                m.c0.y * v.x + m.c1.y * v.y + m.c2.y * v.z,
                m.c0.z * v.x + m.c1.z * v.y + m.c2.z * v.z);
        }
    }
}
