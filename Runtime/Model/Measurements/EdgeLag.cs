using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Lag of a section's trailing edge: the phase of its height behind that of the leading edge, both in the fundamental of the beat, less
    /// the lag that a wing which only turns with its root has by its feathering. Each edge's height has a phase of its own here and the two
    /// are subtracted; the phase of the difference in height is another number (15° where the monarch's lag is 27°).
    /// </summary>
    internal static class EdgeLag
    {
        /// <summary>Least swing of a height that has a phase, wing lengths.</summary>
        private const float k_LeastSwing = 1e-5f;

        /// <summary>The lag, radians, −π to π, positive with the trailing edge later.</summary>
        /// <param name="section">The section.</param>
        /// <param name="rest">[vertex] Rest positions, wing frame.</param>
        /// <param name="beat">One whole beat, times in order; the last frame lies before the first one's phase comes again.</param>
        public static float Of(WingSection section, float3[] rest, IReadOnlyList<BeatFrame> beat)
        {
            float3 leading = section.Leading(rest), trailing = section.Trailing(rest);
            float deformed = Behind(beat, frame => section.Leading(frame.Positions).y, frame => section.Trailing(frame.Positions).y);
            float rigid = Behind(beat, frame => math.rotate(frame.Root, leading).y, frame => math.rotate(frame.Root, trailing).y);
            return Wrap(deformed - rigid);
        }

        /// <summary>
        /// The coefficient a + ib of a height's part a cos Φ + b sin Φ; its angle is the phase at which the height is greatest.
        /// </summary>
        /// <param name="beat">One whole beat, three frames or more.</param>
        /// <param name="height">The height in a frame.</param>
        public static float2 Fundamental(IReadOnlyList<BeatFrame> beat, Func<BeatFrame, float> height)
        {
            float2 sum = 0f;
            for (int k = 0; k < beat.Count; k++)
            {
                float before = beat[(k + beat.Count - 1) % beat.Count].Phase, after = beat[(k + 1) % beat.Count].Phase;
                float share = 0.5f * Turn(after - before);
                Elementary.SinCos(beat[k].Phase, out float sine, out float cosine);
                sum += height(beat[k]) * share / math.PI * new float2(cosine, sine);
            }

            return sum;
        }

        /// <summary>Phase by which the second height follows the first, radians, −π to π; 0 where one of them hardly swings.</summary>
        internal static float Behind(IReadOnlyList<BeatFrame> beat, Func<BeatFrame, float> first, Func<BeatFrame, float> second)
        {
            float2 one = Fundamental(beat, first), other = Fundamental(beat, second);
            if (math.length(one) < k_LeastSwing || math.length(other) < k_LeastSwing)
                return 0f;
            return Wrap(Elementary.Atan2(other.y, other.x) - Elementary.Atan2(one.y, one.x));
        }

        private static float Wrap(float angle) => angle - 2f * math.PI * math.round(angle / (2f * math.PI));

        private static float Turn(float angle) => angle - 2f * math.PI * math.floor(angle / (2f * math.PI));
    }
}
