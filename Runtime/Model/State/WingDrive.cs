using System;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// One beat of one wing as a flight controller commands it; takes effect at the next beat and is glided into over the first half of it.
    /// </summary>
    [Serializable]
    public struct WingDrive
    {
        /// <summary>Bounds of the frequency, hertz.</summary>
        internal const float LeastFrequency = 0.1f, MostFrequency = 1000f;

        /// <summary>Frequency, hertz, 0.1 to 1000.</summary>
        public float frequency;

        /// <summary>Factor on the wing's amplitudes, 0 to 2.</summary>
        public float amplitude;

        /// <summary>Radians by which the middle of the stroke is raised.</summary>
        public float meanFlap;

        /// <summary>Radians by which the middle of the stroke is swept ahead.</summary>
        public float meanSweep;

        /// <summary>Radians by which the wing is feathered in the middle of the stroke, nose down.</summary>
        public float meanFeather;

        /// <summary>Radians by which the stroke plane is tilted, nose up.</summary>
        public float tilt;

        /// <summary>True where the wing can beat so.</summary>
        internal bool IsValid => frequency >= LeastFrequency && frequency <= MostFrequency && amplitude >= 0f && amplitude <= 2f
            && math.all(math.abs(new float4(meanFlap, meanSweep, meanFeather, tilt)) <= math.PI);
    }
}
