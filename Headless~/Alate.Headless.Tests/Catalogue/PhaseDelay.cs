using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli;

namespace Alate.Tests.Insects
{
    /// <summary>Measures the delay of one motion behind another by sliding one over the other until they are most alike.</summary>
    internal static class PhaseDelay
    {
        /// <summary>
        /// The delay of the second motion, degrees of a beat, −180 to 180; finer than the frames by a parabola through the best three.
        /// </summary>
        public static double Of(IReadOnlyList<RecordedFrame> beat, Func<RecordedFrame, float> first, Func<RecordedFrame, float> second)
        {
            double[] one = Centred(beat, first), other = Centred(beat, second);
            int count = beat.Count;
            double[] likeness = Enumerable.Range(0, count)
                .Select(shift => Enumerable.Range(0, count).Sum(k => one[k] * other[(k + shift) % count])).ToArray();
            int best = Array.IndexOf(likeness, likeness.Max());
            double before = likeness[(best + count - 1) % count], at = likeness[best], after = likeness[(best + 1) % count];
            double shift = best + 0.5 * (before - after) / (before - 2.0 * at + after);
            return 360.0 / count * (shift > 0.5 * count ? shift - count : shift);
        }

        private static double[] Centred(IReadOnlyList<RecordedFrame> beat, Func<RecordedFrame, float> motion)
        {
            double mean = beat.Average(frame => (double)motion(frame));
            return beat.Select(frame => motion(frame) - mean).ToArray();
        }
    }
}
