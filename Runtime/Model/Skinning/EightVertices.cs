using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Skinning of eight vertices at a time, two quads side by side, where <see cref="X86.Avx2.IsAvx2Supported"/> holds: as
    /// <see cref="DualQuaternionSkinning"/>, to the same bits. Parts of a pair's work are methods of their own, because RyuJIT inlines no
    /// more once a method has 512 locals.
    /// </summary>
    internal unsafe struct EightVertices
    {
        /// <summary>Bytes of a cache line: a register that lies across two is read and written more slowly.</summary>
        private const int k_Line = 64;

        // Of the cell.
        private Coefficients m_C, m_U, m_V, m_UV;

        // Of the pair of quads.
        private TwoFloat3 m_Q, m_E, m_Slide, m_Position, m_Normal;
        private TwoFloat4 m_W, m_Scale;

        // Of all.
        private TwoFloat3 m_Min, m_Max;

        /// <summary>Bytes that <see cref="Place"/> needs.</summary>
        public static int Room => sizeof(EightVertices) + k_Line - 1;

        /// <summary>Makes one with the given bounds, which are empty.</summary>
        public static EightVertices* Place(byte* memory, SoaBounds* empty)
        {
            var eight = (EightVertices*)(((ulong)memory + (k_Line - 1)) & ~(ulong)(k_Line - 1));
            eight->m_Min = TwoFloat3.Both(&empty->min);
            eight->m_Max = TwoFloat3.Both(&empty->max);
            return eight;
        }

        /// <summary>Skins pairs of quads of one cell from <paramref name="first"/> on.</summary>
        /// <returns>The first quad that is left: the last of an odd number.</returns>
        public static int Skin(EightVertices* eight, CellBlend* blend, in SkinTarget target, int first, int end)
        {
            eight->m_C.Set(&blend->c);
            eight->m_U.Set(&blend->cu);
            eight->m_V.Set(&blend->cv);
            eight->m_UV.Set(&blend->cuv);
            for (; first + 1 < end; first += 2)
            {
                SkinQuad* pair = target.rig.skinQuads + first;
                Blend(eight, pair);
                Move(eight, pair);
                if (target.packedVertices != null)
                    Write(eight, pair, target.packedVertices);
                else
                    Write(eight, pair, target.vertices);
            }

            return first;
        }

        /// <summary>Widens bounds by all vertices that were skinned.</summary>
        public static void Bound(EightVertices* eight, SoaBounds* bounds)
        {
            SoaBounds first, second;
            eight->m_Min.Store(&first.min, &second.min);
            eight->m_Max.Store(&first.max, &second.max);
            bounds->Encapsulate(first.min, first.max);
            bounds->Encapsulate(second.min, second.max);
        }

        private static void Blend(EightVertices* b, SkinQuad* pair)
        {
            var u = TwoFloat4.Load(&pair[0].u, &pair[1].u);
            var v = TwoFloat4.Load(&pair[0].v, &pair[1].v);
            TwoFloat3 q = b->m_C.real + b->m_U.real * u + (b->m_V.real + b->m_UV.real * u) * v;
            TwoFloat4 w = b->m_C.realW + b->m_U.realW * u + (b->m_V.realW + b->m_UV.realW * u) * v;
            b->m_Q = q;
            b->m_W = w;
            b->m_Scale = TwoFloat4.All(2f) / (TwoFloat3.LengthSquared(q) + w * w);
            TwoFloat3 e = b->m_C.dual + b->m_U.dual * u + (b->m_V.dual + b->m_UV.dual * u) * v;
            TwoFloat4 ew = b->m_C.dualW + b->m_U.dualW * u + (b->m_V.dualW + b->m_UV.dualW * u) * v;
            b->m_E = e;
            b->m_Slide = e * w - q * ew;
        }

        private static void Move(EightVertices* b, SkinQuad* pair)
        {
            TwoFloat3 q = b->m_Q;
            TwoFloat4 w = b->m_W, scale = b->m_Scale;
            var p = TwoFloat3.Load((SoaFloat3*)&pair[0].px, (SoaFloat3*)&pair[1].px);
            TwoFloat3 inner = TwoFloat3.Cross(q, p) + p * w + b->m_E;
            p += (TwoFloat3.Cross(q, inner) + b->m_Slide) * scale;
            b->m_Position = p;
            b->m_Min = TwoFloat3.Lower(p, b->m_Min);
            b->m_Max = TwoFloat3.Higher(p, b->m_Max);
            var n = TwoFloat3.Load((SoaFloat3*)&pair[0].nx, (SoaFloat3*)&pair[1].nx);
            inner = TwoFloat3.Cross(q, n) + n * w;
            b->m_Normal = n + TwoFloat3.Cross(q, inner) * scale;
        }

        private static void Write(EightVertices* b, SkinQuad* pair, PackedVertex* packed)
        {
            TwoFloat3 p = b->m_Position;
            TwoFloat4 n = SignedBytes.Pack(b->m_Normal);
            TwoFloat4.Transpose(ref p.x, ref p.y, ref p.z, ref n);
            int4* first = &pair[0].target, second = &pair[1].target;
            p.x.Store((float4*)(packed + first->x), (float4*)(packed + second->x));
            p.y.Store((float4*)(packed + first->y), (float4*)(packed + second->y));
            p.z.Store((float4*)(packed + first->z), (float4*)(packed + second->z));
            n.Store((float4*)(packed + first->w), (float4*)(packed + second->w));
        }

        private static void Write(EightVertices* b, SkinQuad* pair, SkinnedVertex* vertices)
        {
            SoaFloat3 p, n, nextP, nextN;
            b->m_Position.Store(&p, &nextP);
            b->m_Normal.Store(&n, &nextN);
            DualQuaternionSkinning.Write(vertices, pair[0].target, p, n);
            DualQuaternionSkinning.Write(vertices, pair[1].target, nextP, nextN);
        }

        // As CellBlend's, twice.
        private struct Coefficients
        {
            public TwoFloat3 real, dual;
            public TwoFloat4 realW, dualW;

            public void Set(CellBlend.Coefficients8* from)
            {
                real = TwoFloat3.Both(&from->real);
                realW = TwoFloat4.Both(&from->realW);
                dual = TwoFloat3.Both(&from->dual);
                dualW = TwoFloat4.Both(&from->dualW);
            }
        }
    }
}
