using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The Hessian H of Eq. 14 over the joints that are no roots, factorised in 3×3 blocks as L D Lᵀ. Joints are taken chain by chain, so
    /// that no spring reaches further than a chain is long, and nothing is filled in beyond that band.
    /// </summary>
    internal static unsafe class BlockCholesky
    {
        /// <summary>Factorises the Hessian of the last linearisation; the diagonal blocks become the inverse of D.</summary>
        /// <returns>Wings whose Hessian is not positive definite: their steps are not to be used.</returns>
        public static bool4 Factorise(in WingPack pack, in StepScratch scratch)
        {
            Gather(pack, scratch);
            bool4 definite = true;
            int free = pack.rig.jointsPerChain - 1, band = pack.rig.jointsPerChain, count = pack.rig.chainCount * free;
            for (int k = 0; k < count; k++)
            {
                SymmetricBlock* diagonal = scratch.blocks + Joint(k, free);
                SoaFloat3x3* column = scratch.band + k * band - 1, lower = scratch.lower + k * band - 1;
                int reach = math.min(band, count - 1 - k);
                definite &= SymmetricBlock.InvertDefinite(diagonal);
                Scale(lower, column, diagonal, reach);
                EliminateBelow(scratch.band + k * band, lower, column, reach, band);
                for (int r = 1; r <= reach; r++)
                    SubtractSymmetric(scratch.blocks + Joint(k + r, free), lower + r, column + r);
            }

            return !definite;
        }

        /// <summary>step = −H⁻¹ · gradient by the factors, roots zero.</summary>
        public static void Solve(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                scratch.step[joint] = joint % joints == 0 ? default : -scratch.gradient[joint];
            Forward(pack, scratch);
            Backward(pack, scratch);
        }

        // The joint of row k.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static int Joint(int k, int free) => k + (int)((uint)k / (uint)free) + 1;

        // Off-diagonal blocks of H from the springs: −(axial d dᵀ + transversal I).
        private static void Gather(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain, blocks = pack.rig.BandBlocks;
            UnsafeUtility.MemClear(scratch.band, (long)blocks * sizeof(SoaFloat3x3));
            for (int s = 0; s < pack.rig.springCount; s++)
            {
                Spring spring = pack.rig.springs[s];
                int a = math.min(spring.a, spring.b), b = math.max(spring.a, spring.b);
                int i = a / joints, k = b / joints;
                if (a == i * joints || b == k * joints)
                    continue;
                SetSpring(scratch.band + (a - i - 1) * joints + b - k - (a - i) - 1, scratch.springs + s);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void SetSpring(SoaFloat3x3* block, SpringLinearisation* spring)
        {
            SoaFloat3 axis = spring->axis, pull = axis * -spring->axial;
            block->c0 = pull * axis.x;
            block->c1 = pull * axis.y;
            block->c2 = pull * axis.z;
            block->c0.x -= spring->transversal;
            block->c1.y -= spring->transversal;
            block->c2.z -= spring->transversal;
        }

        // A column of L: the blocks below the diagonal times the inverse of D.
        private static void Scale(SoaFloat3x3* lower, SoaFloat3x3* column, SymmetricBlock* d, int reach)
        {
            for (int r = 1; r <= reach; r++)
            {
                SoaFloat3x3* a = column + r;
                lower[r].c0 = a->c0 * d->xx + a->c1 * d->xy + a->c2 * d->xz;
                lower[r].c1 = a->c0 * d->xy + a->c1 * d->yy + a->c2 * d->yz;
                lower[r].c2 = a->c0 * d->xz + a->c1 * d->yz + a->c2 * d->zz;
            }
        }

        // Row r of the columns c < r below: −= L_r A_cᵀ.
        private static void EliminateBelow(SoaFloat3x3* first, SoaFloat3x3* lower, SoaFloat3x3* column, int reach, int band)
        {
            for (int r = 2; r <= reach; r++)
            {
                SoaFloat3 a0 = lower[r].c0, a1 = lower[r].c1, a2 = lower[r].c2;
                SoaFloat3x3* target = first + band + r - 2;
                for (int c = 1; c < r; c++, target += band - 1)
                {
                    SoaFloat3x3* b = column + c;
                    target->c0 -= a0 * b->c0.x + a1 * b->c1.x + a2 * b->c2.x;
                    target->c1 -= a0 * b->c0.y + a1 * b->c1.y + a2 * b->c2.y;
                    target->c2 -= a0 * b->c0.z + a1 * b->c1.z + a2 * b->c2.z;
                }
            }
        }

        // target −= a bᵀ, which is symmetric.
        private static void SubtractSymmetric(SymmetricBlock* target, SoaFloat3x3* a, SoaFloat3x3* b)
        {
            target->xx -= a->c0.x * b->c0.x + a->c1.x * b->c1.x + a->c2.x * b->c2.x;
            target->yy -= a->c0.y * b->c0.y + a->c1.y * b->c1.y + a->c2.y * b->c2.y;
            target->zz -= a->c0.z * b->c0.z + a->c1.z * b->c1.z + a->c2.z * b->c2.z;
            target->xy -= a->c0.x * b->c0.y + a->c1.x * b->c1.y + a->c2.x * b->c2.y;
            target->xz -= a->c0.x * b->c0.z + a->c1.x * b->c1.z + a->c2.x * b->c2.z;
            target->yz -= a->c0.y * b->c0.z + a->c1.y * b->c1.z + a->c2.y * b->c2.z;
        }

        private static void Forward(in WingPack pack, in StepScratch scratch)
        {
            int free = pack.rig.jointsPerChain - 1, band = free + 1, count = pack.rig.chainCount * free;
            for (int k = 0; k < count; k++)
            {
                SoaFloat3x3* lower = scratch.lower + k * band - 1;
                SoaFloat3 known = scratch.step[Joint(k, free)];
                int reach = math.min(band, count - 1 - k);
                for (int r = 1; r <= reach; r++)
                    scratch.step[Joint(k + r, free)] -= lower[r].c0 * known.x + lower[r].c1 * known.y + lower[r].c2 * known.z;
            }
        }

        private static void Backward(in WingPack pack, in StepScratch scratch)
        {
            int free = pack.rig.jointsPerChain - 1, band = free + 1, count = pack.rig.chainCount * free;
            for (int k = count - 1; k >= 0; k--)
            {
                SoaFloat3x3* lower = scratch.lower + k * band - 1;
                SoaFloat3* step = scratch.step + Joint(k, free);
                SoaFloat3 sum = SymmetricBlock.Mul(scratch.blocks + Joint(k, free), *step);
                int reach = math.min(band, count - 1 - k);
                for (int r = 1; r <= reach; r++)
                {
                    SoaFloat3 known = scratch.step[Joint(k + r, free)];
                    sum.x -= SoaFloat3.Dot(lower[r].c0, known);
                    sum.y -= SoaFloat3.Dot(lower[r].c1, known);
                    sum.z -= SoaFloat3.Dot(lower[r].c2, known);
                }

                *step = sum;
            }
        }
    }
}
