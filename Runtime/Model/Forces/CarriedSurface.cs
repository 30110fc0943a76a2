using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Joints carried to the end of the substep, before its loads are known: the driven motion moves them exactly, and their deformation
    /// continues as in the last substep (backward Euler holds it).
    /// </summary>
    internal static unsafe class CarriedSurface
    {
        /// <summary>Fills turns, carriedPositions, carriedFrames, carriedSpans and carriedTurning.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch, float4 dt)
        {
            Turn(pack, scratch);
            float4 ahead = pack.options.timeScheme == TimeScheme.BackwardEuler ? 0f : dt;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                CarryJoint(pack, scratch, joint, pack.rig.BoneOf(joint), ahead);
        }

        /// <summary>Fills turns: the rotation of each driven frame since the last substep.</summary>
        public static void Turn(in WingPack pack, in StepScratch scratch)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
                scratch.turns[bone] = scratch.drivenRotations[bone] * SoaQuaternion.Conjugate(pack.drivenRotations[bone]);
        }

        /// <summary>Fills deformations: each joint's rotation in its driven frame at the start of the substep.</summary>
        public static void Deformations(in WingPack pack, in StepScratch scratch)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                scratch.deformations[joint] = Deformation(pack, joint, pack.rig.BoneOf(joint));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaQuaternion Deformation(in WingPack pack, int joint, int bone) =>
            SoaQuaternion.Conjugate(pack.drivenRotations[bone]) * pack.pose[joint].rotation;

        private static void CarryJoint(in WingPack pack, in StepScratch scratch, int joint, int bone, float4 ahead)
        {
            JointMotion* motion = pack.motions + joint;
            SoaQuaternion deformed = Deformation(pack, joint, bone);
            scratch.deformations[joint] = deformed;
            deformed = SoaQuaternion.Normalize(deformed + motion->turning * ahead);
            SoaQuaternion driven = scratch.drivenRotations[bone];
            var frame = new SoaFloat3x3(driven * deformed);
            scratch.carriedFrames[joint] = frame;
            scratch.carriedSpans[joint] = frame.c0;
            scratch.carriedTurning[joint] = scratch.angularVelocity[bone]
                + SoaQuaternion.Rotate(driven, Turning(motion->turning, deformed));
            scratch.carriedPositions[joint] = pack.pose[joint].position + scratch.drivenPositions[joint] - pack.drivenPositions[joint]
                + motion->velocity * ahead;
        }

        // The angular velocity of a rotation q with rate q̇: the vector part of 2 q̇ q*.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 Turning(SoaQuaternion rate, SoaQuaternion q)
        {
            SoaFloat3 half = rate.v * q.w - q.v * rate.w - SoaFloat3.Cross(rate.v, q.v);
            return half + half;
        }
    }
}
