using Unity.Mathematics;

namespace Alate
{
    /// <summary>Puts wings of a pack back into the driven pose: on request, or because their state is not finite.</summary>
    internal static unsafe class PackReset
    {
        /// <summary>Restarts the chosen wings: first cycle, phase 0, driven pose, no bend, no velocity.</summary>
        public static void Restart(in WingPack pack, in StepScratch scratch, bool4 lanes)
        {
            BeatClock.Reset(ref *pack.beat, *pack.parameters, *pack.surroundings, lanes);
            DelayedWaves.Evaluate(pack, scratch);
            DrivenPose.Evaluate(pack, scratch);
            ToDrivenPose(pack, scratch, lanes);
        }

        /// <summary>
        /// Advances the beat of the chosen wings by a time in which they were not computed, with frequency and amplitude unchanged: driven
        /// pose, no bend, no velocity.
        /// </summary>
        public static void Resume(in WingPack pack, in StepScratch scratch, bool4 lanes, float seconds)
        {
            ref BeatState beat = ref *pack.beat;
            float4 beats = beat.phase / (2f * math.PI) + beat.frequency * seconds;
            float4 whole = math.floor(beats);
            beat.phase = math.select(beat.phase, 2f * math.PI * (beats - whole), lanes);
            beat.cycles += math.select(0f, whole, lanes);
            beat.previousFrequency = math.select(beat.previousFrequency, beat.frequency, lanes);
            beat.amplitude1 = SoaFloat3.Select(beat.amplitude1, beat.amplitude, lanes);
            beat.amplitude2 = SoaFloat3.Select(beat.amplitude2, beat.amplitude, lanes);
            beat.amplitude3 = SoaFloat3.Select(beat.amplitude3, beat.amplitude, lanes);
            beat.amplitude4 = SoaFloat3.Select(beat.amplitude4, beat.amplitude, lanes);
            beat.means1 = SoaFloat3.Select(beat.means1, beat.means, lanes);
            beat.meanFlap1 = math.select(beat.meanFlap1, beat.meanFlap, lanes);
            beat.rate = math.select(beat.rate, 2f * math.PI * beat.frequency, lanes);
            DelayedWaves.Evaluate(pack, scratch);
            DrivenPose.Evaluate(pack, scratch);
            ToDrivenPose(pack, scratch, lanes);
        }

        /// <summary>
        /// Puts wings whose state is not finite back into the driven pose of this substep, in phase, and counts the recovery.
        /// </summary>
        public static void Recover(in WingPack pack, in StepScratch scratch, bool4 lanes)
        {
            ToDrivenPose(pack, scratch, lanes);
            pack.readings->resets += math.select(0f, 1f, lanes);
            Clear(&pack.readings->airForce, lanes);
            Clear(&pack.readings->airMoment, lanes);
            pack.readings->airPower = math.select(pack.readings->airPower, 0f, lanes);
            pack.readings->inertialPower = math.select(pack.readings->inertialPower, 0f, lanes);
            pack.readings->positivePower = math.select(pack.readings->positivePower, 0f, lanes);
        }

        /// <summary>Finds the wings with a joint, deviation or bend rate that is not a number or infinite.</summary>
        public static bool4 NotFinite(in WingPack pack)
        {
            // Finite times zero is zero; anything else is not a number.
            float4 sum = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 all = pack.pose[joint].position * 0f + pack.offsetRates[joint] * 0f;
                sum += all.x + all.y + all.z + pack.pose[joint].rotation.w * 0f;
            }

            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                SoaFloat3 all = pack.bendRates[bone] * 0f;
                sum += all.x + all.y + all.z;
            }

            return sum != 0f;
        }

        private static void ToDrivenPose(in WingPack pack, in StepScratch scratch, bool4 lanes)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                SoaQuaternion driven = scratch.drivenRotations[bone];
                Clear(pack.bendAngles + bone, lanes);
                Clear(pack.bendRates + bone, lanes);
                Clear(pack.earlierAngles + bone, lanes);
                Clear(pack.earlierRates + bone, lanes);
                pack.bentRotations[bone] = SoaQuaternion.Select(pack.bentRotations[bone], driven, lanes);
                pack.drivenRotations[bone] = SoaQuaternion.Select(pack.drivenRotations[bone], driven, lanes);
            }

            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                scratch.positions[joint] = SoaFloat3.Select(pack.pose[joint].position, scratch.drivenPositions[joint], lanes);
                pack.drivenPositions[joint] =
                    SoaFloat3.Select(pack.drivenPositions[joint], scratch.drivenPositions[joint], lanes);
                SoaFloat3 lag = pack.options.timeScheme == TimeScheme.BackwardEuler ? scratch.drivenVelocities[joint] : default;
                pack.drivenLags[joint] = SoaFloat3.Select(pack.drivenLags[joint], lag, lanes);
                Clear(pack.offsets + joint, lanes);
                Clear(pack.offsetRates + joint, lanes);
                Clear(pack.earlierOffsets + joint, lanes);
                Clear(pack.earlierOffsetRates + joint, lanes);
                JointMotion* motion = pack.motions + joint;
                Clear(&motion->velocity, lanes);
                motion->turning = SoaQuaternion.Select(motion->turning, default, lanes);
            }

            *pack.lastSubstep = math.select(*pack.lastSubstep, 0f, lanes);
            WakeInflow.Reset(pack, lanes);

            JointFrames.Evaluate(pack, scratch, scratch.pose);
            int slots = WingPack.PoseSlots * pack.rig.jointCount;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                JointPose pose = scratch.pose[joint];
                pack.pose[joint] = Select(pack.pose[joint], pose, lanes);
                for (int slot = joint; slot < slots; slot += pack.rig.jointCount)
                    pack.slots[slot] = Select(pack.slots[slot], pose, lanes);
            }
        }

        private static void Clear(SoaFloat3* vector, bool4 lanes) => *vector = SoaFloat3.Select(*vector, default, lanes);

        private static JointPose Select(JointPose a, JointPose b, bool4 lanes) => new JointPose
        {
            rotation = SoaQuaternion.Select(a.rotation, b.rotation, lanes),
            position = SoaFloat3.Select(a.position, b.position, lanes),
        };
    }
}
