using System.Runtime.CompilerServices;
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
            bool4 definite = true;
            int free = pack.rig.jointsPerChain - 1, band = free + 1, count = pack.rig.chainCount * free;
            for (int k = 0, left = free; k < count; k++, left = left > 1 ? left - 1 : free)
            {
                SymmetricBlock* diagonal = scratch.blocks + k;
                SoaFloat3x3* column = scratch.band + k * band - 1, lower = scratch.lower + k * band - 1;
                int reach = Reach(count - 1 - k, band, left);
                definite &= SymmetricBlock.InvertDefinite(diagonal);
                Scale(lower, column, diagonal, reach);
                EliminateBelow(scratch.band + k * band, lower, column, reach, band);
            }

            return !definite;
        }

        /// <summary>step = −H⁻¹ · gradient by the factors, roots zero.</summary>
        public static void Solve(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain, free = joints - 1;
            for (int i = 0; i < pack.rig.chainCount; i++)
            {
                SoaFloat3* step = scratch.step + i * free, gradient = scratch.gradient + i * joints + 1;
                for (int j = 0; j < free; j++)
                    step[j] = -gradient[j];
            }

            Forward(pack, scratch);
            Backward(pack, scratch);

            // From the rows of the free joints to all joints, from the last to the first, in place.
            for (int i = pack.rig.chainCount - 1; i >= 0; i--)
            {
                SoaFloat3* step = scratch.step + i * free, all = scratch.step + i * joints;
                for (int j = free - 1; j >= 0; j--)
                    all[j + 1] = step[j];
                all[0] = default;
            }
        }

        // Rows below row k within its column: the last joint of a chain, the only one that is left of it, has no spring to the first of
        // the chain after the next.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static int Reach(int below, int band, int left) => math.min(left == 1 ? band - 1 : band, below);

        // A column of L: the blocks A below the diagonal times the inverse of D. And what it takes from the diagonal blocks below: L Aᵀ.
        private static void Scale(SoaFloat3x3* lower, SoaFloat3x3* column, SymmetricBlock* d, int reach)
        {
            for (int r = 1; r <= reach; r++)
            {
                SoaFloat3 a0 = column[r].c0, a1 = column[r].c1, a2 = column[r].c2;
                SoaFloat3 l0 = a0 * d->xx + a1 * d->xy + a2 * d->xz;
                SoaFloat3 l1 = a0 * d->xy + a1 * d->yy + a2 * d->yz;
                SoaFloat3 l2 = a0 * d->xz + a1 * d->yz + a2 * d->zz;
                lower[r].c0 = l0;
                lower[r].c1 = l1;
                lower[r].c2 = l2;
                SymmetricBlock* below = d + r;
                below->xx -= l0.x * a0.x + l1.x * a1.x + l2.x * a2.x;
                below->yy -= l0.y * a0.y + l1.y * a1.y + l2.y * a2.y;
                below->zz -= l0.z * a0.z + l1.z * a1.z + l2.z * a2.z;
                below->xy -= l0.x * a0.y + l1.x * a1.y + l2.x * a2.y;
                below->xz -= l0.x * a0.z + l1.x * a1.z + l2.x * a2.z;
                below->yz -= l0.y * a0.z + l1.y * a1.z + l2.y * a2.z;
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

        private static void Forward(in WingPack pack, in StepScratch scratch)
        {
            int free = pack.rig.jointsPerChain - 1, band = free + 1, count = pack.rig.chainCount * free;
            for (int k = 0, left = free; k < count; k++, left = left > 1 ? left - 1 : free)
            {
                SoaFloat3x3* lower = scratch.lower + k * band - 1;
                SoaFloat3* step = scratch.step + k;
                SoaFloat3 known = *step;
                int reach = Reach(count - 1 - k, band, left);
                for (int r = 1; r <= reach; r++)
                    step[r] -= lower[r].c0 * known.x + lower[r].c1 * known.y + lower[r].c2 * known.z;
            }
        }

        private static void Backward(in WingPack pack, in StepScratch scratch)
        {
            int free = pack.rig.jointsPerChain - 1, band = free + 1, count = pack.rig.chainCount * free;
            for (int k = count - 1, left = 1; k >= 0; k--, left = left < free ? left + 1 : 1)
            {
                SoaFloat3x3* lower = scratch.lower + k * band - 1;
                SoaFloat3* step = scratch.step + k;
                SoaFloat3 sum = SymmetricBlock.Mul(scratch.blocks + k, *step);
                int reach = Reach(count - 1 - k, band, left);
                for (int r = 1; r <= reach; r++)
                {
                    SoaFloat3 known = step[r];
                    sum.x -= SoaFloat3.Dot(lower[r].c0, known);
                    sum.y -= SoaFloat3.Dot(lower[r].c1, known);
                    sum.z -= SoaFloat3.Dot(lower[r].c2, known);
                }

                *step = sum;
            }
        }
    }
}
