using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Chord method for Eq. 14 on four wings at once: one Newton step with the Hessian kept convex, then steps with exact gradients and
    /// the same factors, mixed with the step before (Anderson's method of depth one). A wing whose steps do not shrink goes on with
    /// <see cref="NewtonSolver"/>, whatever the others of its pack do.
    /// </summary>
    internal static unsafe class ChordSolver
    {
        /// <summary>Most steps with the factors of the first one.</summary>
        private const int k_Chords = 4;

        /// <summary>Square of the movement of a joint in a step, wing lengths, below which a wing is done: 1e-4.</summary>
        private const float k_Done = 1e-8f;

        /// <summary>
        /// Square of the movement that the next step would make if it shrank as the last one did, below which a wing is done: 1e-5. With
        /// twice as much some wings end farther than 1e-4 from the minimum.
        /// </summary>
        private const float k_Next = 1e-10f;

        /// <summary>Square of the movement up to which a step is taken whatever the one before was: 1e-3.</summary>
        private const float k_Near = 1e-6f;

        /// <summary>Square of a longer step's largest length over the one before: 0.7.</summary>
        private const float k_Shrinking = 0.49f;

        /// <summary>Bounds of the mixing: steps that shrink alike are lengthened up to 2.5 times and shortened to half.</summary>
        private const float k_LeastMixing = -1.5f, k_MostMixing = 0.5f;

        /// <summary>Minimises from scratch.positions, in place, the roots fixed.</summary>
        /// <returns>Factorisations that each wing took.</returns>
        public static float4 Minimise(in WingPack pack, in StepScratch scratch)
        {
            SpringEnergy.Linearise(pack, scratch, scratch.positions, true);
            bool4 failed = BlockCholesky.Factorise(pack, scratch);
            BlockCholesky.Solve(pack, scratch);
            Take(pack, scratch, !failed);
            float4 before = NewtonSolver.LargestMove(pack, scratch);
            bool4 active = !failed & !(before < k_Done);
            for (int chord = 1; chord <= k_Chords && math.any(active); chord++)
            {
                SpringEnergy.Gradient(pack, scratch, scratch.positions);
                BlockCholesky.Solve(pack, scratch);
                float4 move = NewtonSolver.LargestMove(pack, scratch);
                bool4 shrinks = (move <= k_Near) | ((move <= k_Shrinking * before) & (chord < k_Chords));
                failed |= active & !shrinks;
                active &= shrinks;
                Mix(pack, scratch, active);
                active &= (move >= k_Done) & (move * move >= k_Next * before);
                before = move;
            }

            if (!math.any(failed))
                return 1f;
            return 1f + NewtonSolver.Minimise(pack, scratch, NewtonSolver.Limits.Default, failed);
        }

        // The first step, in full. candidate keeps the step that was taken last, mixing what a movement had beyond it.
        private static void Take(in WingPack pack, in StepScratch scratch, bool4 active)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 step = scratch.step[joint];
                scratch.positions[joint] = SoaFloat3.Select(scratch.positions[joint], scratch.positions[joint] + step, active);
                scratch.candidate[joint] = step;
                scratch.mixing[joint] = default;
            }
        }

        // x += f − γ (q + f), where q is what the last movement had beyond its step, and γ minimises |f − γ (f − f₋₁)|² by mass.
        private static void Mix(in WingPack pack, in StepScratch scratch, bool4 active)
        {
            float4 along = default, square = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 change = scratch.step[joint] - scratch.candidate[joint];
                float4 inertia = scratch.inertia[joint];
                along += inertia * SoaFloat3.Dot(change, scratch.step[joint]);
                square += inertia * SoaFloat3.LengthSquared(change);
            }

            float4 mixing = math.clamp(along * SoaMath.SafeReciprocal(square), k_LeastMixing, k_MostMixing);
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 step = scratch.step[joint];
                SoaFloat3 beyond = (scratch.mixing[joint] + step) * -mixing;
                scratch.mixing[joint] = beyond;
                scratch.candidate[joint] = step;
                scratch.positions[joint] = SoaFloat3.Select(scratch.positions[joint], scratch.positions[joint] + step + beyond, active);
            }
        }
    }
}
