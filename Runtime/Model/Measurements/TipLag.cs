using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Lag of the tip: the phase of its height behind that of a tip that only turns with the root, both in the fundamental of the beat.
    /// </summary>
    internal static class TipLag
    {
        /// <summary>The lag, radians, −π to π, positive with the tip later than the root that drives it.</summary>
        /// <param name="tip">The vertex of the tip, <see cref="TipBend.FindTip"/>.</param>
        /// <param name="rest">[vertex] Rest positions, wing frame.</param>
        /// <param name="beat">One whole beat, times in order; the last frame lies before the first one's phase comes again.</param>
        public static float Of(int tip, float3[] rest, IReadOnlyList<BeatFrame> beat)
        {
            float3 place = rest[tip];
            return EdgeLag.Behind(beat, frame => math.rotate(frame.Root, place).y, frame => frame.Positions[tip].y);
        }
    }
}
