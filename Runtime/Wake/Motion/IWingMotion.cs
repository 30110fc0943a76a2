using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>Motion of a wing's surface in axes of the body. Lengths are reference lengths; times are beats.</summary>
    public interface IWingMotion
    {
        /// <summary>Writes where places of the surface are, and how they move.</summary>
        /// <param name="beats">Time.</param>
        /// <param name="places">x: 0 at the leading to 1 at the trailing edge; y: 0 at the root to 1 at the tip.</param>
        /// <param name="points">[place] Points.</param>
        /// <param name="velocities">[place] Velocities, reference lengths a beat.</param>
        void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities);
    }
}
