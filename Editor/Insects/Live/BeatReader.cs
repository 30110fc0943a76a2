using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Reads off a living insect what the graphs show.</summary>
    internal static class BeatReader
    {
        /// <summary>A sample of now; false while the wings do not live.</summary>
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

        /// <summary>Beats by which the air force lies back: it is the mean over the last step.</summary>
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
        /// Degrees by which the leading edge's tip stands above the plane of the wing at rest, as seen along the body: deformed, so that it lags and overshoots what
        /// the muscles drive.
        /// </summary>
        public static float FlapAngle(in WingReading wing)
        {
            float3 tip = wing.JointPosition(0, wing.JointsPerChain - 1);
            return math.degrees(math.atan2(tip.y, tip.x));
        }
    }
}
