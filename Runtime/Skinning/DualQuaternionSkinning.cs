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
        /// <summary>Quads that pass from the first pass to the second at a time: 4 KB, well within the first cache.</summary>
        private const int k_BlockQuads = 32;

        /// <summary>A quad between the passes.</summary>
        private struct Blended
        {
            public SoaFloat3 q;
            public float4 w;
            public float4 scale;
            public SoaFloat3 position;
        }

        /// <summary>Skins the quads of one cell from <paramref name="first"/> up to <paramref name="end"/> and widens the bounds.</summary>
        public static void Cell(in CellBlend blend, in SkinTarget target, int first, int end, SoaBounds* bounds)
        {
            Blended* block = stackalloc Blended[k_BlockQuads];
            fixed (CellBlend* b = &blend)
            {
                for (; first < end; first += k_BlockQuads)
                {
                    int count = math.min(end - first, k_BlockQuads);
                    SkinQuad* quads = target.rig.skinQuads + first;
                    Positions(b, quads, count, block);
                    Widen(block, count, bounds);
                    Normals(quads, count, block, target.vertices);
                    if (target.tangents != null)
                        Tangents(quads, target.rig.skinTangents + first, count, block, target.tangents);
                }
            }
        }

        private static void Positions(CellBlend* b, SkinQuad* quads, int count, Blended* block)
        {
            for (int k = 0; k < count; k++)
            {
                SkinQuad* quad = quads + k;
                Blended* blended = block + k;
                float4 u = quad->u, v = quad->v;
                SoaFloat3 q = b->c.real + b->cu.real * u + (b->cv.real + b->cuv.real * u) * v;
                float4 w = b->c.realW + b->cu.realW * u + (b->cv.realW + b->cuv.realW * u) * v;
                SoaFloat3 e = b->c.dual + b->cu.dual * u + (b->cv.dual + b->cuv.dual * u) * v;
                float4 ew = b->c.dualW + b->cu.dualW * u + (b->cv.dualW + b->cuv.dualW * u) * v;
                float4 scale = 2f / (SoaFloat3.LengthSquared(q) + w * w);
                var p = new SoaFloat3(quad->px, quad->py, quad->pz);
                blended->q = q;
                blended->w = w;
                blended->scale = scale;
                blended->position = p + (SoaFloat3.Cross(q, SoaFloat3.Cross(q, p) + p * w + e) + e * w - q * ew) * scale;
            }
        }

        private static void Widen(Blended* block, int count, SoaBounds* bounds)
        {
            SoaBounds all = *bounds;
            for (int k = 0; k < count; k++)
                all.Encapsulate(block[k].position);
            *bounds = all;
        }

        // Turns the normals, and writes positions and normals interleaved: four components in one store, then the last two.
        private static void Normals(SkinQuad* quads, int count, Blended* block, SkinnedVertex* vertices)
        {
            for (int k = 0; k < count; k++)
            {
                SkinQuad* quad = quads + k;
                SoaFloat3 p = block[k].position;
                SoaFloat3 n = Turn(block + k, new SoaFloat3(quad->nx, quad->ny, quad->nz));
                float4x4 head = math.transpose(new float4x4(p.x, p.y, p.z, n.x));
                float4x4 tail = math.transpose(new float4x4(n.y, n.z, n.y, n.z));
                int4 target = quad->target;
                Store(vertices + target.x, head.c0, tail.c0);
                Store(vertices + target.y, head.c1, tail.c1);
                Store(vertices + target.z, head.c2, tail.c2);
                Store(vertices + target.w, head.c3, tail.c3);
            }
        }

        // The handedness in w stays.
        private static void Tangents(SkinQuad* quads, SkinTangentQuad* tangents, int count, Blended* block, float4* output)
        {
            for (int k = 0; k < count; k++)
            {
                SkinTangentQuad* rest = tangents + k;
                SoaFloat3 t = Turn(block + k, new SoaFloat3(rest->tx, rest->ty, rest->tz));
                float4x4 rows = math.transpose(new float4x4(t.x, t.y, t.z, rest->tw));
                int4 target = quads[k].target;
                output[target.x] = rows.c0;
                output[target.y] = rows.c1;
                output[target.z] = rows.c2;
                output[target.w] = rows.c3;
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 Turn(Blended* blended, SoaFloat3 n)
        {
            SoaFloat3 q = blended->q;
            return n + SoaFloat3.Cross(q, SoaFloat3.Cross(q, n) + n * blended->w) * blended->scale;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Store(SkinnedVertex* vertex, float4 head, float4 tail)
        {
            *(float4*)vertex = head;
            *(float2*)((float4*)vertex + 1) = tail.xy;
        }
    }
}
