using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The carried surface over one cell of the skeleton, as the joints' frames blend it: x(u, v) = Σ w_j(u, v) (r_j + S_j (c(u, v) −
    /// p_j)), where c is the bilinear rest cell. That is a polynomial of second degree in u and in v; its coefficients follow from nine
    /// points, and its tangents give the normals of the patches.
    /// </summary>
    internal unsafe struct CellSheet
    {
        private BilinearField m_Span;

        // Coefficients of u^p v^q; that of u^0 v^0 has no part in the tangents.
        private SoaFloat3 m_U, m_V, m_UV, m_UU, m_VV, m_UUV, m_UVV, m_UUVV;

        /// <summary>Evaluates the sheet halfway along every edge; call after <see cref="CarriedSurface"/>.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            AlongChains(pack, scratch);
            AcrossChains(pack, scratch);
        }

        /// <summary>Gathers the sheet over one cell.</summary>
        public static void Gather(CellSheet* sheet, in WingPack pack, in StepScratch scratch, int joint, int next)
        {
            BilinearField.Gather(&sheet->m_Span, scratch.carriedSpans, joint, next);
            SoaFloat3* r = scratch.carriedPositions;
            SoaFloat3* across = scratch.acrossEdges;
            SoaFloat3 middle = Middle(pack, scratch, joint, next);

            // Rows of constant u = 0, ½, 1 by their values at v = 0, ½, 1; then their coefficients as functions of u.
            SoaFloat3* rows = stackalloc SoaFloat3[6];
            Row(r[joint], scratch.alongEdges[joint], r[joint + 1], rows, rows + 3);
            Row(across[joint], middle, across[joint + 1], rows + 1, rows + 4);
            Row(r[next], scratch.alongEdges[next], r[next + 1], rows + 2, rows + 5);
            Row(r[joint], across[joint], r[next], &sheet->m_U, &sheet->m_UU);
            Row(rows[0], rows[1], rows[2], &sheet->m_UV, &sheet->m_UUV);
            Row(rows[3], rows[4], rows[5], &sheet->m_UVV, &sheet->m_UUVV);
            sheet->m_V = rows[0];
            sheet->m_VV = rows[3];
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

        /// <summary>Span direction of the blended frames; not of unit length.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 SpanAt(CellSheet* s, float4 u, float4 v) => BilinearField.At(&s->m_Span, u, v);

        private static void AlongChains(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                if (joint % joints < joints - 1)
                    scratch.alongEdges[joint] = Halfway(pack, scratch, joint, joint + 1);
            }
        }

        private static void AcrossChains(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint + joints < pack.rig.jointCount; joint++)
                scratch.acrossEdges[joint] = Halfway(pack, scratch, joint, joint + joints);
        }

        // Slope and curvature of the parabola through values at 0, ½ and 1.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Row(in SoaFloat3 at0, in SoaFloat3 atHalf, in SoaFloat3 at1, SoaFloat3* slope, SoaFloat3* curvature)
        {
            SoaFloat3 bend = (at0 + at1) * 2f - atHalf * 4f;
            *curvature = bend;
            *slope = at1 - at0 - bend;
        }

        // The sheet halfway along an edge of a cell.
        private static SoaFloat3 Halfway(in WingPack pack, in StepScratch scratch, int a, int b)
        {
            float3 half = 0.5f * (pack.rig.restJoints[b] - pack.rig.restJoints[a]);
            return (Image(scratch, a, half) + Image(scratch, b, -half)) * 0.5f;
        }

        // The sheet in the middle of a cell.
        private static SoaFloat3 Middle(in WingPack pack, in StepScratch scratch, int joint, int next)
        {
            float3* p = pack.rig.restJoints;
            float3 middle = 0.25f * (p[joint] + p[joint + 1] + p[next] + p[next + 1]);
            return (Image(scratch, joint, middle - p[joint]) + Image(scratch, joint + 1, middle - p[joint + 1])
                + Image(scratch, next, middle - p[next]) + Image(scratch, next + 1, middle - p[next + 1])) * 0.25f;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 Image(in StepScratch scratch, int joint, float3 offset) =>
            scratch.carriedPositions[joint] + SoaFloat3x3.Mul(scratch.carriedFrames[joint], offset);
    }
}
