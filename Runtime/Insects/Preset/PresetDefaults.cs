namespace Alate
{
    /// <summary>Numbers every preset starts from, and those in which the two readings of the paper differ.</summary>
    internal static class PresetDefaults
    {
        /// <summary>λ of a monarch: the trailing edge of a measured butterfly lags by 10 to 40°, not by Eq. 2's half beat.</summary>
        public const float k_MonarchChordDelay = 0.15f;

        /// <summary>Strongest wind, over v_ref: up to it wings bend freely; chosen so that no edge tears in ten times that wind.</summary>
        public const float k_StrongestWind = 0.65f;

        public static PresetSize MonarchSize => new PresetSize
        {
            wingLength = 0.061f,
            wingMass = 25.1e-6f,
            insectMass = 0.428e-3f,
            fluidDensity = 1.225f,
            gravityShare = 1f,
        };

        public static PresetBeat MonarchBeat
        {
            get
            {
                var beat = new PresetBeat
                {
                    maxFrequency = 11f,
                    maxSpeed = 2f,
                    flapRange = 120f,
                    featherRange = 24f,
                    sweepRange = 36f,
                    meanFlap = 10f,
                };
                var wave = default(PresetWave);
                MakePhysical(ref beat, ref wave, k_MonarchChordDelay);
                return beat;
            }
        }

        public static PresetWave PhysicalWave
        {
            get
            {
                var beat = default(PresetBeat);
                var wave = new PresetWave { rootShare = 0.8f };
                MakePhysical(ref beat, ref wave, k_MonarchChordDelay);
                return wave;
            }
        }

        public static PresetStiffness Stiffness => new PresetStiffness
        {
            elasticity = 1f,
            leadingEdge = 5f,
            trailingEdge = 3.5f,
            decay = 1f,
            damping = 0.7f,
            dorsalAsymmetry = 1.4f,
            inPlaneFactor = 25f,
            torsionFactor = 1f,
            jointLimit = 30f,
            springScale = 10f,
            anchor = 2f,
            springDamping = 0.3f,
            strongestWind = k_StrongestWind,
        };

        public static void MakePhysical(ref PresetBeat beat, ref PresetWave wave, float chordDelay)
        {
            beat.frequencyFloor = 0.8f;
            beat.amplitudeFloor = 0.5f;
            beat.flapPhase = 0f;
            beat.featherPhase = -90f;
            beat.sweepPhase = -90f;
            wave.chordDelay = chordDelay;
            wave.spanDelay = 0.1f;
            wave.inertia = 1f;
        }

        public static void MakePaper(ref PresetBeat beat, ref PresetWave wave)
        {
            beat.frequencyFloor = 0f;
            beat.amplitudeFloor = 0f;
            beat.flapPhase = 0f;
            beat.featherPhase = 0f;
            beat.sweepPhase = 0f;
            wave.chordDelay = 1f;
            wave.spanDelay = 0f;
            wave.inertia = 2f;
        }
    }
}
