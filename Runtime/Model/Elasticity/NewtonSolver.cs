using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Newton's method for Eq. 14 on four wings at once: exact Hessian, exact steps, Armijo halving per wing. A wing whose Hessian is not
    /// positive definite repeats the iteration with its Hessian kept convex; one that has converged stands still while the others go on.
    /// </summary>
    internal static unsafe class NewtonSolver
    {
        /// <summary>Limits of the solver's work.</summary>
        public struct Limits
        {
            /// <summary>Largest number of Newton iterations of a wing that is near the minimum.</summary>
            public int newton;

            /// <summary>Number of further iterations of a wing that is far from it even then.</summary>
            public int rescue;

            /// <summary>
            /// Movement of a joint in an iteration, wing lengths, from which on a wing is far from the minimum: stopped there, a cell of
            /// the lattice may stay inside out for a substep.
            /// </summary>
            public float far;

            /// <summary>
            /// Movement of a joint in an iteration, wing lengths, below which the solver is done. The remaining error is at most some
            /// hundred times its square.
            /// </summary>
            public float tolerance;

            /// <summary>
            /// Limits of a substep: four iterations, the minimum to 1e-4 L; a wing that still moves by a hundredth of its length, which
            /// happens in gales, goes on to twelve.
            /// </summary>
            public static Limits Default => new Limits { newton = 4, rescue = 8, far = 1e-2f, tolerance = 7e-4f };
        }

        /// <summary>Share of the predicted decrease that a step must bring (Armijo).</summary>
        private const float k_Decrease = 1e-4f;

        /// <summary>Relative rounding of the energy sum; smaller rises are ignored.</summary>
        private const float k_Rounding = 1e-6f;

        private const int k_MaxHalvings = 10;

        /// <summary>Minimises from scratch.positions, in place, the roots fixed.</summary>
        /// <returns>Iterations that each wing took.</returns>
        public static float4 Minimise(in WingPack pack, in StepScratch scratch, in Limits limits) =>
            Minimise(pack, scratch, limits, true);

        /// <summary>Minimises from scratch.positions for the wings of <paramref name="active"/>; the others keep their positions.</summary>
        /// <returns>Iterations that each wing took.</returns>
        public static float4 Minimise(in WingPack pack, in StepScratch scratch, in Limits limits, bool4 active)
        {
            float4 iterations = default;
            float4 value = SpringEnergy.Value(pack, scratch, scratch.positions);
            SpringEnergy.Linearise(pack, scratch, scratch.positions, false);
            for (int k = 0; k < limits.newton + limits.rescue && math.any(active); k++)
            {
                bool4 negative = BlockCholesky.Factorise(pack, scratch) & active;
                if (math.any(negative))
                {
                    SpringEnergy.Linearise(pack, scratch, scratch.positions, negative);
                    BlockCholesky.Factorise(pack, scratch);
                }

                BlockCholesky.Solve(pack, scratch);
                iterations += math.select(0f, 1f, active);
                float4 move = LargestMove(pack, scratch);
                bool4 moved = active & (move >= limits.tolerance * limits.tolerance);
                if (!math.any(moved))
                {
                    Finish(pack, scratch, active);
                    break;
                }

                value = LineSearch(pack, scratch, value, active, moved);
                active = k + 1 < limits.newton ? moved : moved & (move >= limits.far * limits.far);
            }

            return iterations;
        }

        // The last step of a wing is a full one: it is shorter than the tolerance, and nobody asks for the energy that it leads to.
        private static void Finish(in WingPack pack, in StepScratch scratch, bool4 active)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                scratch.positions[joint] = SoaFloat3.Select(
                    scratch.positions[joint], scratch.positions[joint] + scratch.step[joint], active);
            }
        }

        // Halves the step of each wing that goes on until its energy falls; linearises at the accepted positions.
        private static float4 LineSearch(in WingPack pack, in StepScratch scratch, float4 value, bool4 active, bool4 goesOn)
        {
            float4 slope = Slope(pack, scratch);
            float4 length = math.select(0f, 1f, active);
            float4 found = value;
            for (int halving = 0; ; halving++)
            {
                bool4 moving = length > 0f;
                for (int joint = 0; joint < pack.rig.jointCount; joint++)
                {
                    scratch.candidate[joint] = SoaFloat3.Select(
                        scratch.positions[joint], scratch.positions[joint] + scratch.step[joint] * length, moving);
                }
                found = SpringEnergy.Value(pack, scratch, scratch.candidate);
                bool4 tooHigh = !(found <= value + k_Decrease * length * slope + k_Rounding * math.abs(value)) & moving & goesOn;
                if (!math.any(tooHigh))
                    break;
                length = math.select(length, halving < k_MaxHalvings ? 0.5f * length : 0f, tooHigh);
            }

            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                scratch.positions[joint] = scratch.candidate[joint];
            SpringEnergy.Linearise(pack, scratch, scratch.positions, false);
            return found;
        }

        private static float4 Slope(in WingPack pack, in StepScratch scratch)
        {
            float4 slope = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                slope += SoaFloat3.Dot(scratch.gradient[joint], scratch.step[joint]);
            return slope;
        }

        /// <summary>Square of the largest movement of a joint in scratch.step, wing lengths².</summary>
        public static float4 LargestMove(in WingPack pack, in StepScratch scratch)
        {
            float4 largest = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                largest = math.max(largest, SoaFloat3.LengthSquared(scratch.step[joint]));
            return largest;
        }
    }
}
