using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Dual-quaternion skinning of four vertices at a time (lane = vertex). With the blend q + ε e unnormalised and s = 2/|q|²:
    /// p' = p + s (q × (q × p + w p + e) + w e − e_w q), n' = n + s q × (q × n + w n): no square root, no division of components.
    /// </summary>
    internal static unsafe class DualQuaternionSkinning
    {
        /// <summary>Skins the quads of one cell from <paramref name="first"/> up to <paramref name="end"/> and widens the bounds.</summary>
        public static void Cell(
            in CellBlend blend, SkinQuad* quads, int first, int end, SkinnedVertex* vertices, ref SoaFloat3 min, ref SoaFloat3 max)
        {
            fixed (CellBlend* b = &blend)
            {
                SoaFloat3 low = min, high = max;
                for (int k = first; k < end; k++)
                {
                    SkinQuad* quad = quads + k;
                    Blend(b, quad->u, quad->v, out SoaFloat3 q, out float4 w, out SoaFloat3 e, out float4 ew);
                    float4 s = 2f / (SoaFloat3.LengthSquared(q) + w * w);
                    var p = new SoaFloat3(quad->px, quad->py, quad->pz);
                    p += (SoaFloat3.Cross(q, SoaFloat3.Cross(q, p) + p * w + e) + e * w - q * ew) * s;
                    low = new SoaFloat3(math.min(low.x, p.x), math.min(low.y, p.y), math.min(low.z, p.z));
                    high = new SoaFloat3(math.max(high.x, p.x), math.max(high.y, p.y), math.max(high.z, p.z));
                    var n = new SoaFloat3(quad->nx, quad->ny, quad->nz);
                    n += SoaFloat3.Cross(q, SoaFloat3.Cross(q, n) + n * w) * s;
                    Write(vertices, quad->target, p, n);
                }

                min = low;
                max = high;
            }
        }

        /// <summary>Turns the tangents of the same quads; their handedness w stays.</summary>
        public static void CellTangents(
            in CellBlend blend, SkinQuad* quads, SkinTangentQuad* tangents, int first, int end, float4* output)
        {
            fixed (CellBlend* b = &blend)
            {
                for (int k = first; k < end; k++)
                {
                    SkinQuad* quad = quads + k;
                    SkinTangentQuad* rest = tangents + k;
                    Blend(b, quad->u, quad->v, out SoaFloat3 q, out float4 w, out _, out _);
                    float4 s = 2f / (SoaFloat3.LengthSquared(q) + w * w);
                    var t = new SoaFloat3(rest->tx, rest->ty, rest->tz);
                    t += SoaFloat3.Cross(q, SoaFloat3.Cross(q, t) + t * w) * s;
                    float4x4 rows = math.transpose(new float4x4(t.x, t.y, t.z, rest->tw));
                    output[quad->target.x] = rows.c0;
                    output[quad->target.y] = rows.c1;
                    output[quad->target.z] = rows.c2;
                    output[quad->target.w] = rows.c3;
                }
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Blend(
            CellBlend* b, float4 u, float4 v, out SoaFloat3 real, out float4 realW, out SoaFloat3 dual, out float4 dualW)
        {
            real = b->c.real + b->cu.real * u + (b->cv.real + b->cuv.real * u) * v;
            realW = b->c.realW + b->cu.realW * u + (b->cv.realW + b->cuv.realW * u) * v;
            dual = b->c.dual + b->cu.dual * u + (b->cv.dual + b->cuv.dual * u) * v;
            dualW = b->c.dualW + b->cu.dualW * u + (b->cv.dualW + b->cuv.dualW * u) * v;
        }

        // Interleaves position and normal: four components in one store, then the last two.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Write(SkinnedVertex* vertices, int4 target, SoaFloat3 p, SoaFloat3 n)
        {
            float4x4 head = math.transpose(new float4x4(p.x, p.y, p.z, n.x));
            float4x4 tail = math.transpose(new float4x4(n.y, n.z, n.y, n.z));
            Store(vertices + target.x, head.c0, tail.c0);
            Store(vertices + target.y, head.c1, tail.c1);
            Store(vertices + target.z, head.c2, tail.c2);
            Store(vertices + target.w, head.c3, tail.c3);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Store(SkinnedVertex* vertex, float4 head, float4 tail)
        {
            *(float4*)vertex = head;
            *(float2*)((float4*)vertex + 1) = tail.xy;
        }
    }
}
