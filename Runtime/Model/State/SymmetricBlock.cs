using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>A symmetric 3×3 matrix of four wings.</summary>
    internal unsafe struct SymmetricBlock
    {
        public float4 xx;
        public float4 yy;
        public float4 zz;
        public float4 xy;
        public float4 xz;
        public float4 yz;

        /// <summary>Makes diagonal·I.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SymmetricBlock Diagonal(float4 diagonal)
        {
            SymmetricBlock m = default;
            m.xx = diagonal;
            m.yy = diagonal;
            m.zz = diagonal;
            return m;
        }

        /// <summary>Adds a symmetric matrix.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(SymmetricBlock* m, float4 xx, float4 yy, float4 zz, float4 xy, float4 xz, float4 yz)
        {
            m->xx += xx;
            m->yy += yy;
            m->zz += zz;
            m->xy += xy;
            m->xz += xz;
            m->yz += yz;
        }

        /// <summary>Writes a symmetric matrix with its sign changed into a full one.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Negate(SoaFloat3x3* m, float4 xx, float4 yy, float4 zz, float4 xy, float4 xz, float4 yz)
        {
            m->c0 = new SoaFloat3(-xx, -xy, -xz);
            m->c1 = new SoaFloat3(-xy, -yy, -yz);
            m->c2 = new SoaFloat3(-xz, -yz, -zz);
        }

        /// <summary>Matrix times vector.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Mul(SymmetricBlock* m, SoaFloat3 v) => new SoaFloat3(
            m->xx * v.x + m->xy * v.y + m->xz * v.z,
            m->xy * v.x + m->yy * v.y + m->yz * v.z,
            m->xz * v.x + m->yz * v.y + m->zz * v.z);

        /// <summary>Replaces the matrix by its inverse.</summary>
        /// <returns>Wings where it was positive definite.</returns>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool4 InvertDefinite(SymmetricBlock* m)
        {
            // In units of its diagonal: the determinant of a block of a very stiff wing would overflow.
            float4 unit = 1f / math.max(math.abs(m->xx) + math.abs(m->yy) + math.abs(m->zz), 1e-30f);
            Scale(m, unit);
            float4 first = m->xx, second = m->xx * m->yy - m->xy * m->xy;
            float4 third = Invert(m);
            Scale(m, unit);
            return (first > 0f) & (second > 0f) & (third > 0f);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Scale(SymmetricBlock* m, float4 by)
        {
            m->xx *= by;
            m->yy *= by;
            m->zz *= by;
            m->xy *= by;
            m->xz *= by;
            m->yz *= by;
        }

        /// <summary>Replaces the matrix by its inverse; the determinant of a positive definite block is not zero.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Invert(SymmetricBlock* m)
        {
            float4 cxx = m->yy * m->zz - m->yz * m->yz;
            float4 cxy = m->xz * m->yz - m->xy * m->zz;
            float4 cxz = m->xy * m->yz - m->xz * m->yy;
            float4 determinant = m->xx * cxx + m->xy * cxy + m->xz * cxz;
            float4 inverse = 1f / determinant;
            float4 cyy = m->xx * m->zz - m->xz * m->xz;
            float4 cyz = m->xy * m->xz - m->xx * m->yz;
            float4 czz = m->xx * m->yy - m->xy * m->xy;
            m->xx = cxx * inverse;
            m->xy = cxy * inverse;
            m->xz = cxz * inverse;
            m->yy = cyy * inverse;
            m->yz = cyz * inverse;
            m->zz = czz * inverse;
            return determinant;
        }
    }
}
