using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>A vector that varies bilinearly over a skeleton cell: f(u, v) = c + u·cu + v·(cv + u·cuv); u across chains, v along.</summary>
    internal unsafe struct BilinearField
    {
        public SoaFloat3 c;
        public SoaFloat3 cu;
        public SoaFloat3 cv;
        public SoaFloat3 cuv;

        /// <summary>From the values at the four joints of the cell.</summary>
        public void Set(SoaFloat3 at00, SoaFloat3 at01, SoaFloat3 at10, SoaFloat3 at11)
        {
            c = at00;
            cu = at10 - at00;
            cv = at01 - at00;
            cuv = at11 - at10 - cv;
        }

        /// <summary>The value at (u, v).</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 At(BilinearField* f, float4 u, float4 v) => f->c + f->cu * u + (f->cv + f->cuv * u) * v;
    }

    /// <summary>
    /// Velocity of the carried surface over one cell: that of the last substep, Σ w ẋ, plus the change of the driven velocity since,
    /// Σ w (ḋ_new − ḋ_old). At a point s along the cell's span and t along its chord: origin(u, v) + s·span(u, v) + t·chord(u, v).
    /// </summary>
    internal unsafe struct CellMotion
    {
        private BilinearField m_Origin;
        private BilinearField m_Span;
        private BilinearField m_Chord;

        /// <summary>Gathers the field from the motions of the cell's four joints.</summary>
        public static void Fill(CellMotion* field, in WingPack pack, in StepScratch scratch, in PatchCell cell, int joint)
        {
            int next = joint + pack.rig.jointsPerChain;
            JointMotion* m = pack.motions;
            field->m_Origin.Set(
                VelocityAt(pack, scratch, joint, cell.origin), VelocityAt(pack, scratch, joint + 1, cell.origin),
                VelocityAt(pack, scratch, next, cell.origin), VelocityAt(pack, scratch, next + 1, cell.origin));
            field->m_Span.Set(
                SoaFloat3x3.Mul(m[joint].rate, cell.span), SoaFloat3x3.Mul(m[joint + 1].rate, cell.span),
                SoaFloat3x3.Mul(m[next].rate, cell.span), SoaFloat3x3.Mul(m[next + 1].rate, cell.span));
            field->m_Chord.Set(
                SoaFloat3x3.Mul(m[joint].rate, cell.chord), SoaFloat3x3.Mul(m[joint + 1].rate, cell.chord),
                SoaFloat3x3.Mul(m[next].rate, cell.chord), SoaFloat3x3.Mul(m[next + 1].rate, cell.chord));
        }

        /// <summary>Velocity of a patch.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 At(CellMotion* field, float4 u, float4 v, float4 span, float4 chord) =>
            BilinearField.At(&field->m_Origin, u, v)
            + BilinearField.At(&field->m_Span, u, v) * span
            + BilinearField.At(&field->m_Chord, u, v) * chord;

        private static SoaFloat3 VelocityAt(in WingPack pack, in StepScratch scratch, int joint, float3 point)
        {
            JointMotion* motion = pack.motions + joint;
            SoaFloat3 carried = scratch.drivenVelocities[joint] - pack.drivenVelocities[joint];
            return motion->velocity + carried + SoaFloat3x3.Mul(motion->rate, point - pack.rig.restJoints[joint]);
        }
    }
}
