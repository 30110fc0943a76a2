using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Velocity of the carried surface over one cell against a body at rest: of the driven motion at the end of the substep, of the
    /// deformation in the last one, and of the body's turning. Each joint's frame moves a rest point (x, z), taken at the joint's height,
    /// with hinge + x·span + z·chord; the cell blends four of them.
    /// </summary>
    internal unsafe struct CellMotion
    {
        private BilinearField m_Hinge, m_Span, m_Chord;

        /// <summary>Evaluates the three vectors of every joint; call after <see cref="CarriedSurface"/>.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 body = pack.surroundings->angularVelocity, hinge = pack.surroundings->hinge;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                float3 rest = pack.rig.restJoints[joint];
                SoaFloat3 turning = scratch.carriedTurning[joint] + body;
                var span = SoaFloat3.Cross(turning, scratch.carriedFrames[joint].c0);
                var chord = SoaFloat3.Cross(turning, scratch.carriedFrames[joint].c2);
                SoaFloat3 velocity = scratch.drivenVelocities[joint] - pack.drivenLags[joint] + pack.motions[joint].velocity
                    + SoaFloat3.Cross(body, scratch.carriedPositions[joint] + hinge);
                scratch.hingeVelocities[joint] = velocity - span * rest.x - chord * rest.z;
                scratch.spanRates[joint] = span;
                scratch.chordRates[joint] = chord;
            }
        }

        /// <summary>Gathers the field of one cell.</summary>
        public static void Gather(CellMotion* field, in StepScratch scratch, int joint, int next)
        {
            BilinearField.Gather(&field->m_Hinge, scratch.hingeVelocities, joint, next);
            BilinearField.Gather(&field->m_Span, scratch.spanRates, joint, next);
            BilinearField.Gather(&field->m_Chord, scratch.chordRates, joint, next);
        }

        /// <summary>Rate of the direction of the chord, ahead, at (u, v) of the cell, 1/s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 ChordRateAt(CellMotion* field, float4 u, float4 v) => BilinearField.At(&field->m_Chord, u, v);

        /// <summary>Velocity of the surface at (u, v) of the cell, rest point (x, z).</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 At(CellMotion* field, float4 u, float4 v, float4 x, float4 z) =>
            BilinearField.At(&field->m_Hinge, u, v) + BilinearField.At(&field->m_Span, u, v) * x
            + BilinearField.At(&field->m_Chord, u, v) * z;
    }
}
