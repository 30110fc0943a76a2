using System.Runtime.CompilerServices;
using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Dual-quaternion skinning of four vertices at a time (lane = vertex). With the blend q + ε e unnormalised and s = 2/|q|²:
    /// p' = p + s (q × (q × p + w p + e) + w e − e_w q), n' = n + s q × (q × n + w n): no square root, no division of components.
    /// </summary>
    internal static unsafe class DualQuaternionSkinning
    {
        private const float k_LeastSquare = 1e-30f;

        /// <summary>Skins the quads of one cell and widens the bounds.</summary>
        /// <param name="blend">The cell's.</param>
        /// <param name="eight">Memory for eight vertices at a time and their bounds, or null for four at a time.</param>
        /// <param name="target">Rig and vertices.</param>
        /// <param name="first">First quad.</param>
        /// <param name="end">Quad after the last.</param>
        /// <param name="bounds">Of the vertices that were skinned four at a time.</param>
        public static void Cell(CellBlend* blend, EightVertices* eight, in SkinTarget target, int first, int end, SoaBounds* bounds)
        {
            if (target.displacements != null)
                Displacements.Cell(blend, target, first, end);
            int next = X86.Avx2.IsAvx2Supported && eight != null ? EightVertices.Skin(eight, blend, target, first, end) : first;
            Vertices(blend, target.rig.skinQuads, next, end, target.vertices, target.packedVertices, bounds);
            if (target.tangents != null || target.packedTangents != null)
                Tangents(blend, target.rig.skinQuads, target.rig.skinTangents, first, end, target.tangents, target.packedTangents);
        }

        /// <summary>Deformed positions of four vertices, mesh space.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Position(CellBlend* blend, SkinQuad* quad)
        {
            float4 u = quad->u, v = quad->v;
            SoaFloat3 q = BlendReal(blend, u, v), e = BlendDual(blend, u, v);
            float4 w = blend->c.realW + blend->cu.realW * u + (blend->cv.realW + blend->cuv.realW * u) * v;
            float4 ew = blend->c.dualW + blend->cu.dualW * u + (blend->cv.dualW + blend->cuv.dualW * u) * v;
            float4 scale = 2f / (SoaFloat3.LengthSquared(q) + w * w);
            var p = new SoaFloat3(quad->px, quad->py, quad->pz);
            return p + (SoaFloat3.Cross(q, SoaFloat3.Cross(q, p) + p * w + e) + (e * w - q * ew)) * scale;
        }

        private static void Vertices(
            CellBlend* blend, SkinQuad* quads, int first, int end, SkinnedVertex* vertices, PackedVertex* packed, SoaBounds* bounds)
        {
            SoaBounds all = *bounds;
            for (SkinQuad* quad = quads + first; quad < quads + end; quad++)
            {
                float4 u = quad->u, v = quad->v;
                SoaFloat3 q = BlendReal(blend, u, v), e = BlendDual(blend, u, v);
                float4 w = blend->c.realW + blend->cu.realW * u + (blend->cv.realW + blend->cuv.realW * u) * v;
                float4 ew = blend->c.dualW + blend->cu.dualW * u + (blend->cv.dualW + blend->cuv.dualW * u) * v;
                float4 scale = 2f / (SoaFloat3.LengthSquared(q) + w * w);
                var p = new SoaFloat3(quad->px, quad->py, quad->pz);
                var n = new SoaFloat3(quad->nx, quad->ny, quad->nz);

                // Position and normal side by side: a processor finds work in one while it waits for the other.
                SoaFloat3 innerP = SoaFloat3.Cross(q, p) + p * w + e, innerN = SoaFloat3.Cross(q, n) + n * w;
                SoaFloat3 slide = e * w - q * ew;
                p += (SoaFloat3.Cross(q, innerP) + slide) * scale;
                n += SoaFloat3.Cross(q, innerN) * scale;
                if (packed != null)
                    Write(packed, quad->target, p, n);
                else
                    Write(vertices, quad->target, p, n);
                all.Encapsulate(p);
            }

            *bounds = all;
        }

        // The handedness in w stays.
        private static void Tangents(
            CellBlend* blend, SkinQuad* quads, SkinTangentQuad* tangents, int first, int end, float4* output, int* packed)
        {
            for (int k = first; k < end; k++)
            {
                float4 u = quads[k].u, v = quads[k].v;
                SoaFloat3 q = BlendReal(blend, u, v);
                float4 w = blend->c.realW + blend->cu.realW * u + (blend->cv.realW + blend->cuv.realW * u) * v;
                float4 scale = 2f / (SoaFloat3.LengthSquared(q) + w * w);
                SkinTangentQuad* rest = tangents + k;
                var t = new SoaFloat3(rest->tx, rest->ty, rest->tz);
                t += SoaFloat3.Cross(q, SoaFloat3.Cross(q, t) + t * w) * scale;
                int4 target = quads[k].target;
                if (packed != null)
                {
                    // Bytes are spent on the direction alone, whatever the length that a mesh gives it.
                    int4 bytes = SignedBytes.Pack(t * math.rsqrt(math.max(SoaFloat3.LengthSquared(t), k_LeastSquare)), rest->tw);
                    packed[target.x] = bytes.x;
                    packed[target.y] = bytes.y;
                    packed[target.z] = bytes.z;
                    packed[target.w] = bytes.w;
                    continue;
                }

                float4x4 rows = math.transpose(new float4x4(t.x, t.y, t.z, rest->tw));
                output[target.x] = rows.c0;
                output[target.y] = rows.c1;
                output[target.z] = rows.c2;
                output[target.w] = rows.c3;
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 BlendReal(CellBlend* b, float4 u, float4 v) =>
            b->c.real + b->cu.real * u + (b->cv.real + b->cuv.real * u) * v;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 BlendDual(CellBlend* b, float4 u, float4 v) =>
            b->c.dual + b->cu.dual * u + (b->cv.dual + b->cuv.dual * u) * v;

        /// <summary>Interleaves position and normal: two overlapping stores of four components make the six of a vertex.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Write(SkinnedVertex* vertices, int4 target, in SoaFloat3 p, in SoaFloat3 n)
        {
            float4x4 head = math.transpose(new float4x4(p.x, p.y, p.z, n.x));
            float4x4 tail = math.transpose(new float4x4(p.z, n.x, n.y, n.z));
            Store(vertices + target.x, head.c0, tail.c0);
            Store(vertices + target.y, head.c1, tail.c1);
            Store(vertices + target.z, head.c2, tail.c2);
            Store(vertices + target.w, head.c3, tail.c3);
        }

        // The packed normal goes through the transposition as the bits of a float: its highest byte is zero, so no processor takes it for a
        // number it would change.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Write(PackedVertex* vertices, int4 target, in SoaFloat3 p, in SoaFloat3 n)
        {
            float4x4 rows = math.transpose(new float4x4(p.x, p.y, p.z, math.asfloat(SignedBytes.Pack(n))));
            *(float4*)(vertices + target.x) = rows.c0;
            *(float4*)(vertices + target.y) = rows.c1;
            *(float4*)(vertices + target.z) = rows.c2;
            *(float4*)(vertices + target.w) = rows.c3;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Store(SkinnedVertex* vertex, float4 head, float4 tail)
        {
            *(float4*)vertex = head;
            *(float4*)((float*)vertex + 2) = tail;
        }
    }
}
