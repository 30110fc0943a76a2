using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Frames that carry the skin: bone rotations swung onto the elastic bones and rolled after the neighbouring chains, joint rotations
    /// halfway between the bones that meet; with their motion in the substep.
    /// </summary>
    internal static unsafe class JointFrames
    {
        /// <summary>Cosine and sine of the largest roll, 60°.</summary>
        private const float k_RollCos = 0.5f, k_RollSin = 0.8660254f;

        /// <summary>Writes poses of the positions in scratch.positions.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch, JointPose* poses)
        {
            Bones(pack, scratch);
            CrossDirections(pack, scratch);
            Roll(pack, scratch);
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                int i = joint / joints, j = joint - i * joints;
                int bone = joint - i;
                poses[joint].position = scratch.positions[joint];
                poses[joint].rotation = j == 0 ? scratch.boneRotations[bone]
                    : j == joints - 1 ? scratch.boneRotations[bone - 1]
                    : SoaQuaternion.Halfway(scratch.boneRotations[bone - 1], scratch.boneRotations[bone]);
            }
        }

        /// <summary>
        /// Evaluates the mean rates of the deformation from the last pose to the new one, for the surface that the next substep carries on;
        /// after <see cref="CarriedSurface"/>, which keeps the deformations of the last pose.
        /// </summary>
        public static void Motions(in WingPack pack, in StepScratch scratch, float4 dt)
        {
            float4 inverse = 1f / dt;
            bool euler = pack.options.timeScheme == TimeScheme.BackwardEuler;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                int bone = pack.rig.BoneOf(joint);
                SoaFloat3 driven = scratch.drivenPositions[joint] - pack.drivenPositions[joint];
                SoaFloat3 moved = scratch.pose[joint].position - pack.pose[joint].position;
                SoaQuaternion to = SoaQuaternion.Conjugate(scratch.drivenRotations[bone]) * scratch.pose[joint].rotation;
                pack.motions[joint].velocity = (moved - driven) * inverse;
                pack.motions[joint].turning = SoaQuaternion.Difference(scratch.deformations[joint], to) * inverse;
                pack.drivenLags[joint] = euler ? scratch.drivenVelocities[joint] - driven * inverse : default;
            }
        }

        private static void Bones(in WingPack pack, in StepScratch scratch)
        {
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                int joint = bone + bone / bonesPerChain;
                SoaQuaternion bent = pack.bentRotations[bone];
                var along = SoaFloat3.NormalizeSafe(scratch.positions[joint + 1] - scratch.positions[joint]);
                SoaFloat3 posed = SoaQuaternion.Rotate(bent, new SoaFloat3(pack.rig.boneDirections[bone]));
                scratch.boneRotations[bone] = SoaQuaternion.Swing(posed, along, bent);
                scratch.boneAxes[bone] = along;
            }
        }

        // The rest cross-chain direction and the deformed one, both seen along the bone.
        private static void CrossDirections(in WingPack pack, in StepScratch scratch)
        {
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            SoaFloat3* r = scratch.positions;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                int i = bone / bonesPerChain;
                int joint = bone + i;
                int before = i > 0 ? joint - pack.rig.jointsPerChain : joint;
                int after = i < pack.rig.chainCount - 1 ? joint + pack.rig.jointsPerChain : joint;
                SoaFloat3 along = scratch.boneAxes[bone];
                SoaFloat3 to = r[after] + r[after + 1] - r[before] - r[before + 1];
                SoaFloat3 from = SoaQuaternion.Rotate(scratch.boneRotations[bone], new SoaFloat3(pack.rig.crossDirections[bone]));
                scratch.rollFrom[bone] = from - along * SoaFloat3.Dot(along, from);
                scratch.rollTo[bone] = to - along * SoaFloat3.Dot(along, to);
            }
        }

        // The turn about each bone, at most 60°, that brings one direction onto the other.
        private static void Roll(in WingPack pack, in StepScratch scratch)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                SoaFloat3 from = scratch.rollFrom[bone], to = scratch.rollTo[bone];
                float4 scale2 = SoaFloat3.LengthSquared(from) * SoaFloat3.LengthSquared(to);
                float4 inverse = SoaMath.SafeReciprocal(math.sqrt(scale2));
                float4 cos = math.select(SoaFloat3.Dot(from, to) * inverse, 1f, scale2 < 1e-20f);
                SoaFloat3 turn = SoaFloat3.Cross(from, to) * inverse;
                bool4 tooFar = cos < k_RollCos;
                if (math.any(tooFar))
                {
                    float4 sin2 = math.max(SoaFloat3.LengthSquared(turn), 1e-12f);
                    turn *= math.select(1f, k_RollSin / math.sqrt(sin2), tooFar);
                    cos = math.select(cos, k_RollCos, tooFar);
                }

                var roll = new SoaQuaternion(turn, 1f + cos);
                scratch.boneRotations[bone] = SoaQuaternion.Normalize(roll * scratch.boneRotations[bone]);
            }
        }
    }
}
