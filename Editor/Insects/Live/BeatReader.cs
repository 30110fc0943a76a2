using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Reads the samples that the graphs show from a living insect.</summary>
    internal static class BeatReader
    {
        /// <summary>Reads the current sample; false while the wings do not live.</summary>
        public static bool TryRead(InsectWings insect, out BeatSample sample)
        {
            sample = default;
            if (insect == null || insect.Live == null)
                return false;
            WingReading wing = insect.Read(0);
            double beat = wing.Beats + wing.Phase / (2.0 * math.PI_DBL);
            sample = new BeatSample(beat, FlapAngle(wing), insect.LiftOverWeight);
            return true;
        }

        /// <summary>Number of beats by which the air force lies back, because it is the mean over the last step.</summary>
        public static double ForceLag(InsectWings insect)
        {
            switch (insect.UpdateMode)
            {
                case WingUpdateMode.FixedUpdate:
                    return 0.5 * insect.Frequency * Time.fixedDeltaTime;
                case WingUpdateMode.Manual:
                    return 0.0;
                default:
                    return 0.5 * insect.Frequency * Clocks.FrameStep;
            }
        }

        /// <summary>
        /// Angle of the leading edge's tip above the plane of the wing at rest, degrees, as seen along the body: deformed, so that it lags
        /// and overshoots the driven angle.
        /// </summary>
        public static float FlapAngle(in WingReading wing)
        {
            float3 tip = wing.JointPosition(0, wing.JointsPerChain - 1);
            return math.degrees(math.atan2(tip.y, tip.x));
        }
    }
}
