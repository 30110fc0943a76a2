using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Runs one fixed step of a pack: the number of substeps, and the order of the work in each.</summary>
    internal static unsafe class PackStep
    {
        /// <summary>Tolerance for steps that are a whole number of substeps, which must not round up to one more.</summary>
        private const float k_CountRounding = 1e-3f;

        /// <summary>
        /// Largest number of beats in one step: a mosquito at 600 Hz beats twelve times in a fiftieth of a second; more is a spike of the
        /// frame rate.
        /// </summary>
        private const float k_MostBeats = 16f;

        /// <summary>
        /// Largest distance that the air passes in a substep, wing lengths: its loads are made before the wing has answered them.
        /// </summary>
        private const float k_AirPerSubstep = 0.6f;

        /// <summary>Largest number of substeps that a beat takes for the speed of the air.</summary>
        private const float k_MostPerBeat = 192f;

        /// <summary>Frequencies up to so many times the wing's own are flown with the same substeps.</summary>
        private const float k_FlightFrequency = 1.3f;

        /// <summary>
        /// Number of times per beat that bends fade by e with waves alone: within a quarter of a beat, which is seen as a settling, not as
        /// a jump.
        /// </summary>
        private const float k_Fading = 4f;

        /// <summary>Derives what depends on parameters and rig, stiffnesses, dampings and delays, and bounds the wind.</summary>
        public static void Derive(in WingPack pack)
        {
            Bending.Derive(pack);
            ChainDelays.Derive(pack);
            StrongestWind.Derive(pack);
        }

        /// <summary>
        /// Advances the pack by <paramref name="dt"/> seconds; does nothing where dt is not positive or the pack is frozen.
        /// </summary>
        public static void Run(ref WingPack pack, in StepScratch scratch, float dt)
        {
            if (!(dt > 0f) || pack.detail == WingDetail.Frozen)
                return;

            StrongestWind.Derive(pack);
            Plan(ref pack, dt);
            BeginStep(ref pack);
            int most = MostSubsteps(pack);
            for (int k = 1; k <= most; k++)
                Substep(ref pack, scratch, k);
            EndStep(pack);
        }

        /// <summary>
        /// Chooses number and whole length of each wing's substeps by its own beat and air: no wing's motion depends on which others share
        /// its pack.
        /// </summary>
        public static void Plan(ref WingPack pack, float dt)
        {
            float4 time = dt;
            pack.substeps = SubstepCounts(pack, ref time);
            pack.substepLength = time;
        }

        /// <summary>Largest number of substeps of a wing of the pack.</summary>
        public static int MostSubsteps(in WingPack pack) => (int)math.cmax(pack.substeps);

        /// <summary>Runs substep k of a step, from 1, for the wings that have as many; the others wait.</summary>
        public static void Substep(ref WingPack pack, in StepScratch scratch, int k)
        {
            bool4 waits = pack.substeps < k;
            bool some = math.any(waits);
            if (some)
                SetAside(pack, scratch);
            if (pack.carries)
                StrongestWind.Derive(pack);
            if (pack.detail == WingDetail.WavesOnly)
                WavesSubstep(pack, scratch, pack.substepLength);
            else
                Substep(pack, scratch, pack.substepLength);
            if (some)
                PutBack(pack, scratch, waits);
            PackSlots.Keep(pack, k);
        }

        /// <summary>
        /// Number of substeps of each wing for its beat and for the fastest air; shortens <paramref name="dt"/> where a step would span
        /// more than 16 beats.
        /// </summary>
        public static float4 SubstepCounts(in WingPack pack, ref float4 dt)
        {
            float4 frequency = math.max(pack.beat->frequency, pack.beat->previousFrequency);
            // What a controller commands changes from beat to beat, and with it the count must not.
            bool4 commanded = pack.parameters->drive.commanded > 0f;
            float4 perBeat = SubstepsPerBeat(pack, commanded);
            float4 rate = math.select(
                frequency, math.max(frequency, k_FlightFrequency * pack.parameters->numbers.maxFrequency), commanded) * perBeat;
            if (pack.detail != WingDetail.WavesOnly)
            {
                rate = math.max(
                    rate, math.min(AirSpeed(pack) * (1f / k_AirPerSubstep), k_MostPerBeat * pack.parameters->numbers.maxFrequency));
            }
            dt = math.min(dt, k_MostBeats / frequency);
            return math.max(math.ceil(dt * rate - k_CountRounding), 1f);
        }

        /// <summary>Runs one substep: the model, in the order of its equations.</summary>
        public static void Substep(in WingPack pack, in StepScratch scratch, float4 h)
        {
            BeatClock.Advance(ref *pack.beat, *pack.parameters, *pack.surroundings, pack.options.cycleChange, h);
            WakeInflow.Advance(pack, h);
            DelayedWaves.Evaluate(pack, scratch);
            DrivenPose.Evaluate(pack, scratch);
            var step = ImplicitStep.Of(pack, h);
            CarriedSurface.Evaluate(pack, scratch, h);
            JointLoads.Evaluate(pack, scratch, step);
            if (pack.carries)
                AirDamping.Evaluate(pack, scratch);
            Bending.Step(pack, scratch, step);
            Bending.Pose(pack, scratch);
            float4 iterations = ElasticStep.Step(pack, scratch, step);
            JointFrames.Evaluate(pack, scratch, scratch.pose);
            AirReadings.Evaluate(pack, scratch, step);
            if (pack.carries && pack.options.bodyReaction)
                WingMomentum.Evaluate(pack, scratch, h);
            JointFrames.Motions(pack, scratch, h);
            Keep(pack, scratch, h);
            pack.readings->newtonIterations += iterations;
            RecoverBroken(pack, scratch);
        }

        /// <summary>Runs one substep of the beat and its waves alone; bends and stretches fade.</summary>
        public static void WavesSubstep(in WingPack pack, in StepScratch scratch, float4 h)
        {
            BeatClock.Advance(ref *pack.beat, *pack.parameters, *pack.surroundings, pack.options.cycleChange, h);
            DelayedWaves.Evaluate(pack, scratch);
            DrivenPose.Evaluate(pack, scratch);
            float4 kept = SoaMath.Exp(-k_Fading * pack.beat->frequency * h);
            CarriedSurface.Turn(pack, scratch);
            CarriedSurface.Deformations(pack, scratch);
            Bending.Relax(pack, scratch, kept);
            Bending.Pose(pack, scratch);
            ElasticStep.Relax(pack, scratch, kept);
            JointFrames.Evaluate(pack, scratch, scratch.pose);
            JointFrames.Motions(pack, scratch, h);
            Keep(pack, scratch, 0f);
            RecoverBroken(pack, scratch);
        }

        // Of what the tip of a wing at rest meets, L/s: the wind, and the air through which the body turns it.
        private static float4 AirSpeed(in WingPack pack)
        {
            float4 reach = 1f + math.sqrt(SoaFloat3.LengthSquared(pack.surroundings->hinge));
            return StrongestWind.Speed(pack) + math.sqrt(SoaFloat3.LengthSquared(pack.inflow->velocity))
                + math.sqrt(SoaFloat3.LengthSquared(pack.surroundings->angularVelocity)) * reach;
        }

        // Wings that a controller commands keep all that meet the air: its gains were found for them, and what brakes with fewer tumbles.
        private static float4 SubstepsPerBeat(in WingPack pack, bool4 commanded)
        {
            float4 perBeat = pack.parameters->numbers.substepsPerBeat;
            if (pack.detail == WingDetail.Full)
                return perBeat;
            float4 fewer = math.max(0.5f * perBeat, WingParameters.MinSubsteps);
            return pack.detail == WingDetail.WavesOnly ? fewer : math.select(fewer, perBeat, commanded);
        }

        private static void RecoverBroken(in WingPack pack, in StepScratch scratch)
        {
            bool4 broken = PackReset.NotFinite(pack);
            if (math.any(broken))
                PackReset.Recover(pack, scratch, broken);
        }

        /// <summary>Starts the poses and readings of a step.</summary>
        public static void BeginStep(ref WingPack pack)
        {
            pack.substepLength /= pack.substeps;
            PackSlots.Begin(ref pack);
            pack.readings->airForce = default;
            pack.readings->airMoment = default;
            pack.readings->airPower = default;
            pack.readings->inertialPower = default;
            pack.readings->positivePower = default;
            pack.readings->newtonIterations = default;
        }

        /// <summary>Ends the readings of a step.</summary>
        public static void EndStep(in WingPack pack)
        {
            float4 mean = 1f / pack.substeps;
            pack.readings->airForce *= mean;
            pack.readings->airMoment *= mean;
            pack.readings->airPower *= mean;
            pack.readings->inertialPower *= mean;
            pack.readings->positivePower *= mean;
            pack.readings->newtonIterations *= mean;
            pack.readings->springEnergy = SpringEnergy.Elastic(pack, pack.pose, out pack.readings->stretch);
        }

        /// <summary>Makes the substep's end the start of the next.</summary>
        public static void Keep(in WingPack pack, in StepScratch scratch, float4 substep)
        {
            int joints = pack.rig.jointCount, bones = pack.rig.boneCount;
            *pack.lastSubstep = substep;
            UnsafeUtility.MemCpy(pack.pose, scratch.pose, (long)joints * sizeof(JointPose));
            UnsafeUtility.MemCpy(pack.drivenPositions, scratch.drivenPositions, (long)joints * sizeof(SoaFloat3));
            UnsafeUtility.MemCpy(pack.drivenRotations, scratch.drivenRotations, (long)bones * sizeof(SoaQuaternion));
        }

        private static void SetAside(in WingPack pack, in StepScratch scratch)
        {
            UnsafeUtility.MemCpy(scratch.waiting, pack.state, (long)pack.stateCount * sizeof(float4));
            if (pack.recordedLoads != null)
                UnsafeUtility.MemCpy(scratch.waitingLoads, pack.recordedLoads, (long)pack.RecordedCount * sizeof(float4));
        }

        private static void PutBack(in WingPack pack, in StepScratch scratch, bool4 lanes)
        {
            PutBack(pack.state, scratch.waiting, pack.stateCount, lanes);
            if (pack.recordedLoads != null)
                PutBack((float4*)pack.recordedLoads, scratch.waitingLoads, pack.RecordedCount, lanes);
        }

        private static void PutBack(float4* state, float4* waiting, int count, bool4 lanes)
        {
            for (int k = 0; k < count; k++)
                state[k] = math.select(state[k], waiting[k], lanes);
        }
    }
}
