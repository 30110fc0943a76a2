using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Turns the joints by their torques: three damped hinges a bone (bend, in-plane, torsion), each by one implicit step. The paper leaves
    /// this step open; the form is that of Ju et al. 2013.
    /// </summary>
    internal static unsafe class Bending
    {
        /// <summary>
        /// Factor on the estimate of the air's damping in the second-order hinge: makes up for the lag of the loads, and keeps soft wings
        /// stable.
        /// </summary>
        private const float k_AirShare = 1.5f;

        /// <summary>
        /// Bend at which a joint has become twice as stiff, radians (7°); it rises with the fourth power, so that ordinary bends do not
        /// feel it.
        /// </summary>
        private const float k_StiffeningAngle = 0.12f;

        /// <summary>
        /// Stiffness of every bone and its damping, from parameters and rig: k_e I (2π f_ref N)² e^(−σ/decay), by veins where they are
        /// known, or what was measured, which is linear up to the joint's limit.
        /// </summary>
        public static void Derive(in WingPack pack)
        {
            const float k_Stiffening = 1f / (k_StiffeningAngle * k_StiffeningAngle);
            bool stiffens = pack.options.coupling == MembraneCoupling.TwoWay;
            float4 share = VeinShare(pack);
            ref readonly LaneParameters p = ref *pack.parameters;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                float inertia = pack.rig.jointInertias[bone], measured = pack.rig.beamStiffness[bone], torsion = pack.rig.beamTorsion[bone];
                float4 stiffness = measured > 0f
                    ? p.numbers.stiffnessUnit * measured
                    : FactorStiffness(pack, bone) * pack.rig.veinFactors[bone] * share;
                float4 damping = 2f * p.numbers.bendDamping * math.sqrt(stiffness * inertia);
                float4 twist = p.numbers.stiffnessUnit * torsion;
                pack.bendStiffness[bone] = stiffness;
                pack.bendDamping[bone] = damping;
                pack.torsionStiffness[bone] = torsion > 0f ? twist : stiffness * p.numbers.torsionFactor;
                pack.torsionDamping[bone] = torsion > 0f
                    ? 2f * p.numbers.bendDamping * math.sqrt(twist * inertia)
                    : damping * p.torsionDamping;
                pack.bendStiffening[bone] = stiffens && measured == 0f ? k_Stiffening : 0f;
            }
        }

        private static float4 FactorStiffness(in WingPack pack, int bone)
        {
            ref readonly LaneParameters p = ref *pack.parameters;
            int perChain = pack.rig.jointsPerChain - 1, chain = bone / perChain;
            float4 factor =
                p.numbers.stiffnessRoot * SoaMath.Pow(p.numbers.stiffnessTip / p.numbers.stiffnessRoot, pack.rig.chainRatio[chain]);
            float4 atRoot = p.bendScale * factor * factor * pack.rig.jointInertias[chain * perChain];
            return atRoot * SoaMath.Exp(-pack.rig.jointRatio[bone - chain * perChain] / p.numbers.stiffnessDecay);
        }

        // Keeps the mean stiffness of the joints that veins stiffen and membrane softens.
        private static float4 VeinShare(in WingPack pack)
        {
            if (!pack.rig.hasVeins)
                return 1f;
            float4 plain = 1e-20f, veined = 1e-20f;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                float4 stiffness = pack.rig.beamStiffness[bone] > 0f ? 0f : FactorStiffness(pack, bone);
                plain += stiffness;
                veined += stiffness * pack.rig.veinFactors[bone];
            }

            return plain / veined;
        }

        /// <summary>Turns the joints by one substep, and the chain with them: new bend angles, rates and rotations H.</summary>
        public static void Step(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            Turn(pack, scratch, step);
            if (pack.options.coupling == MembraneCoupling.TwoWay)
                ChainCoupling.Apply(pack, scratch, step);
            Compose(pack, scratch);
        }

        /// <summary>First part of <see cref="Step"/>: turns every hinge independently.</summary>
        public static void Turn(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
                TurnJoint(pack, scratch, bone, step);
        }

        /// <summary>Keeps a share of every bend, and turns the chains; ignores the loads.</summary>
        public static void Relax(in WingPack pack, in StepScratch scratch, float4 kept)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                pack.bendAngles[bone] = SoaMath.Faded(pack.bendAngles[bone], kept);
                pack.bendRates[bone] = default;
                pack.earlierAngles[bone] = pack.bendAngles[bone];
                pack.earlierRates[bone] = default;
            }

            Compose(pack, scratch);
        }

        /// <summary>
        /// Advances one hinge by one implicit step of the given length: the new rate, and the angle held within ±limit. Takes angle and
        /// rate as the step's past (<see cref="ImplicitStep"/>); the given rate is the one that the loads were made with.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Hinge(
            float4 inertia, float4 damping, float4 airDamping, float4 stiffness, float4 torque, float4 limit, float4 length,
            float4 seen, float4 angle, ref float4 rate)
        {
            rate = (inertia * rate + length * (torque - stiffness * angle + airDamping * seen))
                / (inertia + (damping + airDamping) * length + stiffness * (length * length));
            float4 moved = angle + rate * length;
            float4 held = math.min(math.max(moved, -limit), limit);
            rate = math.select(rate, 0f, ((moved > limit) & (rate > 0f)) | ((moved < -limit) & (rate < 0f)));
            return held;
        }

        private static void TurnJoint(in WingPack pack, in StepScratch scratch, int bone, in ImplicitStep step)
        {
            ref readonly LaneParameters p = ref *pack.parameters;
            bool euler = pack.options.timeScheme == TimeScheme.BackwardEuler;
            SoaQuaternion bent = euler ? pack.bentRotations[bone] : scratch.turns[bone] * pack.bentRotations[bone];
            SoaFloat3 torque = SoaQuaternion.Rotate(SoaQuaternion.Conjugate(bent), scratch.torques[bone]);
            float3 axis = pack.rig.bendAxes[bone], along = pack.rig.boneDirections[bone];
            float4 inertia = pack.rig.jointInertias[bone];
            float4 across = pack.options.addedMass ? inertia + pack.parameters->numbers.airDensity * pack.rig.addedInertias[bone] : inertia;
            float4 stiffness = pack.bendStiffness[bone];
            float4 damping = pack.bendDamping[bone];
            float4 airDamping = AirDamping(pack, scratch, bone) * (euler ? 1f : k_AirShare);
            SoaFloat3 seen = euler ? pack.bendRates[bone]
                : (pack.bendAngles[bone] - pack.earlierAngles[bone]) * SoaMath.SafeReciprocal(*pack.lastSubstep);
            SoaFloat3 angles = step.Past(pack.bendAngles[bone], pack.earlierAngles[bone]);
            SoaFloat3 rates = step.Past(pack.bendRates[bone], pack.earlierRates[bone]);
            bool4 up = pack.bendAngles[bone].x > 0f;
            float4 bendDamping = damping * math.select(1f, p.dorsalDamping, up), inPlaneDamping = damping * p.inPlaneDamping;
            float4 bendStiffness =
                stiffness * math.select(1f, p.numbers.dorsalAsymmetry, up) * Stiffening(pack.bendStiffening[bone], pack.bendAngles[bone].x);
            float4 twistStiffness = pack.torsionStiffness[bone] * Stiffening(pack.bendStiffening[bone], pack.bendAngles[bone].z);
            pack.earlierAngles[bone] = pack.bendAngles[bone];
            pack.earlierRates[bone] = pack.bendRates[bone];

            float4 bend = torque.x * axis.x + torque.y * axis.y + torque.z * axis.z;
            angles.x = Hinge(across, bendDamping, airDamping, bendStiffness, bend, p.numbers.jointLimit, step.length,
                seen.x, angles.x, ref rates.x);

            float4 inPlane = stiffness * p.numbers.inPlaneFactor;
            angles.y = Hinge(inertia, inPlaneDamping, airDamping, inPlane, torque.y, p.numbers.jointLimit, step.length,
                seen.y, angles.y, ref rates.y);

            float4 twist = torque.x * along.x + torque.y * along.y + torque.z * along.z;
            angles.z = Hinge(across, pack.torsionDamping[bone], 0f, twistStiffness, twist, p.numbers.jointLimit, step.length,
                seen.z, angles.z, ref rates.z);

            pack.bendAngles[bone] = angles;
            pack.bendRates[bone] = rates;
            scratch.compliances[bone].x = Compliance(across, bendDamping + airDamping, bendStiffness, step.length);
            scratch.compliances[bone].y = Compliance(inertia, inPlaneDamping + airDamping, inPlane, step.length);
        }

        // A joint bends less and less easily on its way to the limit.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Stiffening(float4 scale, float4 angle)
        {
            float4 square = angle * angle * scale;
            return 1f + square * square;
        }

        // How far a unit of torque turns a hinge in an implicit step.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Compliance(float4 inertia, float4 damping, float4 stiffness, float4 length) =>
            length * length / (inertia + damping * length + stiffness * (length * length));

        // What the air damps about this joint: the patches' damping of all joints further out, on their levers.
        private static float4 AirDamping(in WingPack pack, in StepScratch scratch, int bone)
        {
            int joints = pack.rig.jointsPerChain;
            int i = bone / (joints - 1);
            int joint = bone + i;
            float* levers = pack.rig.leverDamping + joint * joints;
            float4 sum = default;
            for (int j = joint - i * joints + 1; j < joints; j++)
                sum += scratch.airDamping[i * joints + j] * levers[j];
            return sum;
        }

        /// <summary>
        /// Last part of <see cref="Step"/>: H along each chain, the driven turn from bone to bone, then the joint's own bend.
        /// </summary>
        public static void Compose(in WingPack pack, in StepScratch scratch)
        {
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                SoaFloat3 angles = pack.bendAngles[bone];
                float3 axis = pack.rig.bendAxes[bone], along = pack.rig.boneDirections[bone];
                var bend = new SoaFloat3(
                    angles.x * axis.x + angles.z * along.x,
                    angles.x * axis.y + angles.y + angles.z * along.y,
                    angles.x * axis.z + angles.z * along.z);
                SoaQuaternion driven = scratch.drivenRotations[bone];
                SoaQuaternion rotation = bone % bonesPerChain == 0
                    ? driven
                    : pack.bentRotations[bone - 1] * (SoaQuaternion.Conjugate(scratch.drivenRotations[bone - 1]) * driven);
                pack.bentRotations[bone] = SoaQuaternion.Normalize(rotation * SoaQuaternion.Exp(bend));
            }
        }

        /// <summary>Posed positions r̂ of the joints: driven roots, then bone by bone along H.</summary>
        public static void Pose(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain;
            for (int i = 0, bone = 0; i < pack.rig.chainCount; i++)
            {
                int joint = i * joints;
                SoaFloat3 position = scratch.drivenPositions[joint];
                scratch.targets[joint] = position;
                for (int j = 1; j < joints; j++, bone++)
                {
                    position += SoaQuaternion.Rotate(pack.bentRotations[bone], new SoaFloat3(pack.rig.bones[bone]));
                    scratch.targets[joint + j] = position;
                }
            }
        }
    }
}
