using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Eq. 13–15, resolved: an implicit step on the deviation e of the joints from their posed positions r̂, with an anchor that draws
    /// them back. Minimising over r: Σ m/(2dt²)|r − pred|² + Σ ½ m Ω²|r − r̂|² + springs; the two mass terms are one, about one point.
    /// </summary>
    internal static unsafe class ElasticStep
    {
        /// <summary>Solves for the joint positions; keeps the new deviation and its rate.</summary>
        /// <returns>Factorisations of the springs' Hessian that each wing took.</returns>
        public static float4 Step(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            Turn(pack, scratch);
            Predict(pack, scratch, step);
            float4 iterations = pack.options.timeScheme == TimeScheme.BackwardEuler
                ? NewtonSolver.Minimise(pack, scratch, NewtonSolver.Limits.Default)
                : ChordSolver.Minimise(pack, scratch);
            Keep(pack, scratch, step);
            return iterations;
        }

        /// <summary>Keeps a share of the deviation, turned with the driven motion; ignores the springs.</summary>
        public static void Relax(in WingPack pack, in StepScratch scratch, float4 kept)
        {
            Turn(pack, scratch);
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                pack.offsets[joint] = SoaMath.Faded(pack.offsets[joint], kept);
                pack.offsetRates[joint] = default;
                pack.earlierOffsets[joint] = pack.offsets[joint];
                pack.earlierOffsetRates[joint] = default;
                scratch.positions[joint] = scratch.targets[joint] + pack.offsets[joint];
            }
        }

        /// <summary>Share of ė that a substep of backward Euler keeps, β = exp(−2 ζ_E Ω dt).</summary>
        public static float4 Retention(float4 springDamping, float4 anchorRate, float4 dt) =>
            SoaMath.Exp(-2f * springDamping * anchorRate * dt);

        // Turns e and ė, of now and of one substep earlier, with the driven motion.
        private static void Turn(in WingPack pack, in StepScratch scratch)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                var turned = new SoaFloat3x3(scratch.turns[pack.rig.BoneOf(joint)]);
                pack.offsets[joint] = SoaFloat3x3.Mul(turned, pack.offsets[joint]);
                pack.offsetRates[joint] = SoaFloat3x3.Mul(turned, pack.offsetRates[joint]);
                pack.earlierOffsets[joint] = SoaFloat3x3.Mul(turned, pack.earlierOffsets[joint]);
                pack.earlierOffsetRates[joint] = SoaFloat3x3.Mul(turned, pack.earlierOffsetRates[joint]);
            }
        }

        // Places start and anchor of every joint. Damping is part of the mass in the second-order step; the printed scheme lets ė fade.
        private static void Predict(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            ref readonly LaneParameters p = ref *pack.parameters;
            bool euler = pack.options.timeScheme == TimeScheme.BackwardEuler;
            float4 damped = euler ? 1f : 1f + 2f * p.numbers.springDamping * p.anchorRate * step.length;
            float4 reach = euler ? Retention(p.numbers.springDamping, p.anchorRate, step.dt) * step.dt : step.length / damped;
            float4 mass = damped / (step.length * step.length);
            float4 total = mass + p.anchorRate * p.anchorRate;
            float4 share = mass / total;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 offset = pack.offsets[joint];
                SoaFloat3 start = euler
                    ? offset + pack.offsetRates[joint] * step.dt
                    : offset + (offset - pack.earlierOffsets[joint]) * step.ratio;
                SoaFloat3 past = step.Past(offset, pack.earlierOffsets[joint])
                    + step.Past(pack.offsetRates[joint], pack.earlierOffsetRates[joint]) * reach;
                scratch.positions[joint] = scratch.targets[joint] + start;
                scratch.anchors[joint] = scratch.targets[joint] + past * share;
                scratch.inertia[joint] = total * pack.rig.jointMasses[joint];
            }
        }

        private static void Keep(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            float4 inverse = 1f / step.length;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 offset = scratch.positions[joint] - scratch.targets[joint];
                SoaFloat3 rate = (offset - step.Past(pack.offsets[joint], pack.earlierOffsets[joint])) * inverse;
                pack.earlierOffsets[joint] = pack.offsets[joint];
                pack.earlierOffsetRates[joint] = pack.offsetRates[joint];
                pack.offsets[joint] = offset;
                pack.offsetRates[joint] = rate;
            }
        }
    }
}
