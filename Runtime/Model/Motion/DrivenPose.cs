using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Pose that the muscles drive: rotations G = R_X(−tilt) R_Z(flap) R_−Y(sweep) R_LE(feather) along each chain, with the positions,
    /// velocities and accelerations of the joints that follow.
    /// </summary>
    internal static unsafe class DrivenPose
    {
        /// <summary>Converts the angles of <see cref="DelayedWaves"/> to positions, velocities and accelerations of the joints.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            Flap(pack, scratch);
            Sweep(pack, scratch);
            Feather(pack, scratch);
            Rates(pack, scratch);
            Chains(pack, scratch);
        }

        // R_X(−tilt) R_Z(flap); the means hold sine and cosine of half of −tilt. Those of the whole flap, which its axes need, follow.
        private static void Flap(in WingPack pack, in StepScratch scratch)
        {
            float4 tiltSin = scratch.means->tiltHalfSin, tiltCos = scratch.means->tiltHalfCos;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                SoaMath.SinCos(scratch.angle[bone].x * 0.5f, out float4 sin, out float4 cos);
                scratch.flapSin[bone] = 2f * sin * cos;
                scratch.flapCos[bone] = 1f - 2f * sin * sin;
                scratch.drivenRotations[bone] = new SoaQuaternion(
                    new SoaFloat3(tiltSin * cos, -tiltSin * sin, tiltCos * sin), tiltCos * cos);
            }
        }

        // Chains that sweep together have the sweep of the leading one, whose sine and cosine are made once.
        private static void Sweep(in WingPack pack, in StepScratch scratch)
        {
            int own = DelayedWaves.SweepCount(pack);
            for (int bone = 0; bone < own; bone++)
            {
                SoaMath.SinCos(scratch.angle[bone].y * 0.5f, out float4 sin, out float4 cos);
                for (int same = bone; same < pack.rig.boneCount; same += own)
                    scratch.drivenRotations[same] = TurnBackY(scratch.drivenRotations[same], sin, cos);
            }
        }

        private static void Feather(in WingPack pack, in StepScratch scratch)
        {
            float3 edge = pack.rig.leadingEdge;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                SoaMath.SinCos(scratch.angle[bone].z * 0.5f, out float4 sin, out float4 cos);
                var feather = new SoaQuaternion(new SoaFloat3(edge.x * sin, edge.y * sin, edge.z * sin), cos);
                scratch.drivenRotations[bone] = scratch.drivenRotations[bone] * feather;
            }
        }

        // q · R_−Y, given sine and cosine of half the angle.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaQuaternion TurnBackY(SoaQuaternion q, float4 sin, float4 cos) => new SoaQuaternion(
            new SoaFloat3(q.v.x * cos + q.v.z * sin, q.v.y * cos - q.w * sin, q.v.z * cos - q.v.x * sin),
            q.w * cos + q.v.y * sin);

        // The axes of the three turns in the wing's frame: R_tilt Z; R_tilt R_Z (−Y); R_tilt R_Z R_−Y e_LE, which is G e_LE.
        private static void Rates(in WingPack pack, in StepScratch scratch)
        {
            float4 rate = pack.beat->rate;
            float4 rate2 = rate * rate;
            float4 tiltSin = scratch.means->tiltSin, tiltCos = scratch.means->tiltCos;
            float4 tilting = scratch.means->tiltRate * rate, tiltingUp = scratch.means->tiltCurvature * rate2;
            var edge = new SoaFloat3(pack.rig.leadingEdge);
            var flapAxis = new SoaFloat3(0f, -tiltSin, tiltCos);
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                float4 sin = scratch.flapSin[bone], cos = scratch.flapCos[bone];
                var sweepAxis = new SoaFloat3(sin, -tiltCos * cos, -tiltSin * cos);
                SoaFloat3 featherAxis = SoaQuaternion.Rotate(scratch.drivenRotations[bone], edge);
                SoaFloat3 turning = scratch.angleRate[bone] * rate;
                SoaFloat3 accelerating = scratch.angleCurvature[bone] * rate2;
                scratch.angularVelocity[bone] = flapAxis * turning.x + sweepAxis * turning.y + featherAxis * turning.z;
                scratch.angularAcceleration[bone] =
                    flapAxis * accelerating.x + sweepAxis * accelerating.y + featherAxis * accelerating.z;
                scratch.angularVelocity[bone].x += tilting;
                scratch.angularAcceleration[bone].x += tiltingUp;
            }
        }

        // Every root turns with the first bone of the principal chain (a rigid wing base); the chains follow bone by bone.
        // Centripetal terms are left out, as in Eq. 5.
        private static void Chains(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain;
            SoaQuaternion baseRotation = scratch.drivenRotations[0];
            SoaFloat3 baseVelocity = scratch.angularVelocity[0];
            SoaFloat3 baseAcceleration = scratch.angularAcceleration[0];
            for (int i = 0, bone = 0, joint = 0; i < pack.rig.chainCount; i++)
            {
                SoaFloat3 position = SoaQuaternion.Rotate(baseRotation, new SoaFloat3(pack.rig.restJoints[joint]));
                var velocity = SoaFloat3.Cross(baseVelocity, position);
                var acceleration = SoaFloat3.Cross(baseAcceleration, position);
                Store(scratch, joint++, position, velocity, acceleration);
                for (int j = 1; j < joints; j++, bone++)
                {
                    SoaFloat3 arm = SoaQuaternion.Rotate(scratch.drivenRotations[bone], new SoaFloat3(pack.rig.bones[bone]));
                    position += arm;
                    velocity += SoaFloat3.Cross(scratch.angularVelocity[bone], arm);
                    acceleration += SoaFloat3.Cross(scratch.angularAcceleration[bone], arm);
                    Store(scratch, joint++, position, velocity, acceleration);
                }
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Store(in StepScratch scratch, int joint, SoaFloat3 position, SoaFloat3 velocity, SoaFloat3 acceleration)
        {
            scratch.drivenPositions[joint] = position;
            scratch.drivenVelocities[joint] = velocity;
            scratch.drivenAccelerations[joint] = acceleration;
        }
    }
}
