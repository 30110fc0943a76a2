using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Torques turn the joints: three damped hinges a bone (bend, in-plane, torsion), each by one implicit step. The paper leaves
    /// this step open; the form is that of Ju et al. 2013.
    /// </summary>
    internal static unsafe class Bending
    {
        /// <summary>Bending stiffness of every bone, k_e I (2π f_ref N)² e^(−σ/decay), from parameters and rig.</summary>
        public static void DeriveStiffness(in WingPack pack)
        {
            ref readonly LaneParameters p = ref *pack.parameters;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int i = 0, bone = 0; i < pack.rig.chainCount; i++)
            {
                float4 factor = p.stiffnessRoot * math.pow(p.stiffnessTip / p.stiffnessRoot, pack.rig.chainRatio[i]);
                float4 atRoot = p.bendScale * factor * factor * pack.rig.jointInertias[bone];
                for (int j = 0; j < bonesPerChain; j++, bone++)
                    pack.bendStiffness[bone] = atRoot * math.exp(-pack.rig.jointRatio[j] / p.stiffnessDecay);
            }
        }

        /// <summary>Turns the joints by one substep, and the chain with them: new bend angles, rates and rotations H.</summary>
        public static void Step(in WingPack pack, in StepScratch scratch, float dt)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
                TurnJoint(pack, scratch, bone, dt);
            Compose(pack, scratch);
        }

        /// <summary>Keeps a share of every bend, without regard to loads, and turns the chains.</summary>
        public static void Relax(in WingPack pack, in StepScratch scratch, float4 kept)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                pack.bendAngles[bone] = pack.bendAngles[bone] * kept;
                pack.bendRates[bone] = default;
            }

            Compose(pack, scratch);
        }

        /// <summary>One hinge, one implicit step: the new rate, and the angle held within ±limit.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Hinge(
            float4 inertia, float4 damping, float4 airDamping, float4 stiffness, float4 torque, float4 limit, float dt,
            float4 angle, ref float4 rate)
        {
            rate = ((inertia + airDamping * dt) * rate + dt * (torque - stiffness * angle))
                / (inertia + (damping + airDamping) * dt + stiffness * (dt * dt));
            float4 moved = angle + rate * dt;
            float4 held = math.min(math.max(moved, -limit), limit);
            rate = math.select(rate, 0f, ((moved > limit) & (rate > 0f)) | ((moved < -limit) & (rate < 0f)));
            return held;
        }

        private static void TurnJoint(in WingPack pack, in StepScratch scratch, int bone, float dt)
        {
            ref readonly LaneParameters p = ref *pack.parameters;
            SoaFloat3 torque = SoaQuaternion.Rotate(SoaQuaternion.Conjugate(pack.bentRotations[bone]), scratch.torques[bone]);
            float3 axis = pack.rig.bendAxes[bone], along = pack.rig.boneDirections[bone];
            float4 inertia = pack.rig.jointInertias[bone];
            float4 stiffness = pack.bendStiffness[bone];
            float4 damping = 2f * p.bendDamping * math.sqrt(stiffness * inertia);
            float4 airDamping = AirDamping(pack, scratch, bone);
            SoaFloat3 angles = pack.bendAngles[bone], rates = pack.bendRates[bone];

            float4 bend = torque.x * axis.x + torque.y * axis.y + torque.z * axis.z;
            float4 dorsal = math.select(1f, p.dorsalAsymmetry, angles.x > 0f);
            angles.x = Hinge(inertia, damping * math.sqrt(dorsal), airDamping, stiffness * dorsal, bend, p.jointLimit, dt,
                angles.x, ref rates.x);

            float4 inPlane = stiffness * p.inPlaneFactor;
            angles.y = Hinge(inertia, damping * math.sqrt(p.inPlaneFactor), airDamping, inPlane, torque.y, p.jointLimit, dt,
                angles.y, ref rates.y);

            float4 twist = torque.x * along.x + torque.y * along.y + torque.z * along.z;
            angles.z = Hinge(inertia, damping * math.sqrt(p.torsionFactor), 0f, stiffness * p.torsionFactor, twist, p.jointLimit, dt,
                angles.z, ref rates.z);

            pack.bendAngles[bone] = angles;
            pack.bendRates[bone] = rates;
        }

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

        // H along each chain: the driven turn from bone to bone, then the joint's own bend.
        private static void Compose(in WingPack pack, in StepScratch scratch)
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
