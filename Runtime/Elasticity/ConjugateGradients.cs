using Unity.Mathematics;

namespace Alate
{
    /// <summary>Solves H · step = −gradient over the joints that are no roots, preconditioned by the joints' own 3×3 blocks.</summary>
    internal static unsafe class ConjugateGradients
    {
        /// <summary>
        /// A few iterations from step = 0. A wing whose residual has fallen to <paramref name="reduction"/> of its first value, in the
        /// norm of the preconditioner, stands still: what it gets does not depend on its neighbours.
        /// </summary>
        /// <returns>Wings whose Hessian, or one of its blocks, showed negative curvature: their step is not to be used.</returns>
        public static bool4 Solve(in WingPack pack, in StepScratch scratch, int iterations, float reduction)
        {
            float4 rz = Begin(pack, scratch);
            float4 enough = math.max(rz * (reduction * reduction), 1e-30f);
            bool4 negative = rz < 0f;
            for (int k = 0; k < iterations; k++)
            {
                bool4 active = rz > enough;
                if (!math.any(active))
                    break;
                SpringEnergy.Apply(pack, scratch, scratch.direction, scratch.image);
                float4 curvature = Curvature(pack, scratch);
                float4 alpha = math.select(0f, rz / math.max(curvature, 1e-30f), active & (curvature > 0f));
                float4 next = Advance(pack, scratch, alpha);
                negative |= active & ((curvature <= 0f) | (next < 0f));
                Turn(pack, scratch, next / math.max(rz, 1e-30f));
                rz = math.select(rz, next, active);
            }

            return negative;
        }

        private static float4 Begin(in WingPack pack, in StepScratch scratch)
        {
            float4 rz = default;
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                scratch.step[joint] = default;
                if (joint % joints == 0)
                {
                    scratch.direction[joint] = default;
                    continue;
                }

                SymmetricBlock.Invert(scratch.blocks + joint);
                SoaFloat3 residual = -scratch.gradient[joint];
                SoaFloat3 preconditioned = SymmetricBlock.Mul(scratch.blocks + joint, residual);
                scratch.residual[joint] = residual;
                scratch.direction[joint] = preconditioned;
                rz += SoaFloat3.Dot(residual, preconditioned);
            }

            return rz;
        }

        private static float4 Curvature(in WingPack pack, in StepScratch scratch)
        {
            float4 sum = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                sum += SoaFloat3.Dot(scratch.direction[joint], scratch.image[joint]);
            return sum;
        }

        private static float4 Advance(in WingPack pack, in StepScratch scratch, float4 alpha)
        {
            float4 rz = default;
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                if (joint % joints == 0)
                    continue;
                scratch.step[joint] += scratch.direction[joint] * alpha;
                SoaFloat3 residual = scratch.residual[joint] - scratch.image[joint] * alpha;
                SoaFloat3 preconditioned = SymmetricBlock.Mul(scratch.blocks + joint, residual);
                scratch.residual[joint] = residual;
                scratch.preconditioned[joint] = preconditioned;
                rz += SoaFloat3.Dot(residual, preconditioned);
            }

            return rz;
        }

        private static void Turn(in WingPack pack, in StepScratch scratch, float4 beta)
        {
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                if (joint % joints == 0)
                    continue;
                scratch.direction[joint] = scratch.preconditioned[joint] + scratch.direction[joint] * beta;
            }
        }
    }
}
