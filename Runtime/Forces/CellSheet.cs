using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The carried surface over one cell of the skeleton, as the joints' frames blend it: x(u, v) = Σ w_j(u, v) (r_j + S_j (c(u, v) − p_j)),
    /// where c is the bilinear rest cell. That is a polynomial of second degree in u and in v; its coefficients follow from nine
    /// points, and its tangents give the normals of the patches.
    /// </summary>
    internal unsafe struct CellSheet
    {
        /// <summary>Span direction of the blended frames.</summary>
        public BilinearField span;

        // Coefficients of u^p v^q; that of u^0 v^0 has no part in the tangents.
        private SoaFloat3 m_U, m_V, m_UV, m_UU, m_VV, m_UUV, m_UVV, m_UUVV;

        /// <summary>Gathers the sheet from the carried frames and positions of the cell's four joints.</summary>
        public static void Fill(CellSheet* sheet, in WingPack pack, in StepScratch scratch, int joint)
        {
            int next = joint + pack.rig.jointsPerChain;
            SoaFloat3x3* f = scratch.carriedFrames;
            SoaFloat3* r = scratch.carriedPositions;
            sheet->span.Set(f[joint].c0, f[joint + 1].c0, f[next].c0, f[next + 1].c0);

            // Rows of constant u = 0, ½, 1, each by its values at v = 0, ½, 1.
            SoaFloat3 front = Halfway(pack, scratch, joint, joint + 1);
            SoaFloat3 back = Halfway(pack, scratch, next, next + 1);
            SoaFloat3 inner = Halfway(pack, scratch, joint, next);
            SoaFloat3 outer = Halfway(pack, scratch, joint + 1, next + 1);
            Row(r[joint], front, r[joint + 1], out SoaFloat3 front1, out SoaFloat3 front2);
            Row(inner, Middle(pack, scratch, joint), outer, out SoaFloat3 middle1, out SoaFloat3 middle2);
            Row(r[next], back, r[next + 1], out SoaFloat3 back1, out SoaFloat3 back2);

            Row(r[joint], inner, r[next], out sheet->m_U, out sheet->m_UU);
            Row(front1, middle1, back1, out sheet->m_UV, out sheet->m_UUV);
            Row(front2, middle2, back2, out sheet->m_UVV, out sheet->m_UUVV);
            sheet->m_V = front1;
            sheet->m_VV = front2;
        }

        /// <summary>x_v × x_u: up where the rest normal is up; not of unit length.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 NormalAt(CellSheet* s, float4 u, float4 v)
        {
            float4 u2 = u + u, v2 = v + v;
            SoaFloat3 alongU = s->m_U + s->m_UU * u2 + (s->m_UV + s->m_UUV * u2 + (s->m_UVV + s->m_UUVV * u2) * v) * v;
            SoaFloat3 alongV = s->m_V + (s->m_UV + s->m_UUV * u) * u + (s->m_VV + (s->m_UVV + s->m_UUVV * u) * u) * v2;
            return SoaFloat3.Cross(alongV, alongU);
        }

        // Slope and curvature of the parabola through values at 0, ½ and 1.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Row(SoaFloat3 at0, SoaFloat3 atHalf, SoaFloat3 at1, out SoaFloat3 slope, out SoaFloat3 curvature)
        {
            curvature = (at0 + at1) * 2f - atHalf * 4f;
            slope = at1 - at0 - curvature;
        }

        // The sheet halfway along an edge of the cell.
        private static SoaFloat3 Halfway(in WingPack pack, in StepScratch scratch, int a, int b)
        {
            float3 half = 0.5f * (pack.rig.restJoints[b] - pack.rig.restJoints[a]);
            return (Image(scratch, a, half) + Image(scratch, b, -half)) * 0.5f;
        }

        // The sheet in the middle of the cell.
        private static SoaFloat3 Middle(in WingPack pack, in StepScratch scratch, int joint)
        {
            int next = joint + pack.rig.jointsPerChain;
            float3* p = pack.rig.restJoints;
            float3 middle = 0.25f * (p[joint] + p[joint + 1] + p[next] + p[next + 1]);
            return (Image(scratch, joint, middle - p[joint]) + Image(scratch, joint + 1, middle - p[joint + 1])
                + Image(scratch, next, middle - p[next]) + Image(scratch, next + 1, middle - p[next + 1])) * 0.25f;
        }

        private static SoaFloat3 Image(in StepScratch scratch, int joint, float3 offset) =>
            scratch.carriedPositions[joint] + SoaFloat3x3.Mul(scratch.carriedFrames[joint], offset);
    }
}
