using System.Runtime.CompilerServices;
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
        /// <returns>Newton iterations that each wing took.</returns>
        public static float4 Step(in WingPack pack, in StepScratch scratch, float dt)
        {
            Predict(pack, scratch, dt);
            float4 iterations = NewtonSolver.Minimise(pack, scratch, NewtonSolver.Limits.Default);
            Keep(pack, scratch, dt);
            return iterations;
        }

        /// <summary>Keeps a share of the deviation, turned with the driven motion, without regard to springs.</summary>
        public static void Relax(in WingPack pack, in StepScratch scratch, float4 kept)
        {
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                pack.offsets[joint] = SoaQuaternion.Rotate(Turned(pack, scratch, joint, joints), pack.offsets[joint]) * kept;
                pack.offsetRates[joint] = default;
                scratch.positions[joint] = scratch.targets[joint] + pack.offsets[joint];
            }
        }

        /// <summary>How much of ė a substep keeps, β = exp(−2 ζ_E Ω dt).</summary>
        public static float4 Retention(float4 springDamping, float4 anchorRate, float dt) =>
            math.exp(-2f * springDamping * anchorRate * dt);

        // Turns e and ė with the driven motion, and places start and anchor of every joint.
        private static void Predict(in WingPack pack, in StepScratch scratch, float dt)
        {
            ref readonly LaneParameters p = ref *pack.parameters;
            float4 reach = Retention(p.springDamping, p.anchorRate, dt) * dt;
            float inverse2 = 1f / (dt * dt);
            float4 pull = p.anchorRate * p.anchorRate;
            float4 total = inverse2 + pull;
            float4 share = inverse2 / total;
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaQuaternion turned = Turned(pack, scratch, joint, joints);
                SoaFloat3 offset = SoaQuaternion.Rotate(turned, pack.offsets[joint]);
                SoaFloat3 rate = SoaQuaternion.Rotate(turned, pack.offsetRates[joint]);
                pack.offsets[joint] = offset;
                scratch.positions[joint] = scratch.targets[joint] + offset + rate * dt;
                scratch.anchors[joint] = scratch.targets[joint] + (offset + rate * reach) * share;
                scratch.inertia[joint] = total * pack.rig.jointMasses[joint];
            }
        }

        // How the driven frame of a joint has turned since the last substep.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaQuaternion Turned(in WingPack pack, in StepScratch scratch, int joint, int joints)
        {
            int i = joint / joints, j = joint - i * joints;
            int bone = i * (joints - 1) + math.min(j, joints - 2);
            return scratch.drivenRotations[bone] * SoaQuaternion.Conjugate(pack.drivenRotations[bone]);
        }

        private static void Keep(in WingPack pack, in StepScratch scratch, float dt)
        {
            float inverse = 1f / dt;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 offset = scratch.positions[joint] - scratch.targets[joint];
                pack.offsetRates[joint] = (offset - pack.offsets[joint]) * inverse;
                pack.offsets[joint] = offset;
            }
        }
    }
}
