using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Velocity of the carried surface over one cell: that of the last substep, Σ w ẋ, plus the change of the driven velocity since,
    /// Σ w (ḋ_new − ḋ_old). Each joint's frame moves a rest point (x, z), taken at the joint's height, with
    /// hinge + x·span + z·chord; the cell blends four of them.
    /// </summary>
    internal unsafe struct CellMotion
    {
        private BilinearField m_Hinge, m_Span, m_Chord;

        /// <summary>The three vectors of every joint.</summary>
        public static void Carry(in WingPack pack, in StepScratch scratch)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                JointMotion* motion = pack.motions + joint;
                float3 rest = pack.rig.restJoints[joint];
                SoaFloat3 carried = scratch.drivenVelocities[joint] - pack.drivenVelocities[joint];
                scratch.hingeVelocities[joint] =
                    motion->velocity + carried - motion->rate.c0 * rest.x - motion->rate.c2 * rest.z;
                scratch.spanRates[joint] = motion->rate.c0;
                scratch.chordRates[joint] = motion->rate.c2;
            }
        }

        /// <summary>The field of one cell.</summary>
        public static void Gather(CellMotion* field, in StepScratch scratch, int joint, int next)
        {
            BilinearField.Gather(&field->m_Hinge, scratch.hingeVelocities, joint, next);
            BilinearField.Gather(&field->m_Span, scratch.spanRates, joint, next);
            BilinearField.Gather(&field->m_Chord, scratch.chordRates, joint, next);
        }

        /// <summary>Velocity of the surface at (u, v) of the cell, rest point (x, z).</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 At(CellMotion* field, float4 u, float4 v, float4 x, float4 z) =>
            BilinearField.At(&field->m_Hinge, u, v) + BilinearField.At(&field->m_Span, u, v) * x + BilinearField.At(&field->m_Chord, u, v) * z;
    }
}
