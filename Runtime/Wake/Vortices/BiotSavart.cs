using System.Runtime.CompilerServices;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Velocity that straight vortex segments with a core induce (Biot and Savart; core of Vatistas et al. 1991 with n = 2), eight points
    /// at a time: V = Γ/4π · c · d / √(|c|⁴ + rc⁴ |r0|⁴), c = r1 × r2, d = r0·r1/|r1| − r0·r2/|r2|. Finite everywhere.
    /// </summary>
    internal static class BiotSavart
    {
        // Kept out of roots; far below what floats resolve of lengths near 1.
        private const float k_Square = 1e-20f, k_Fourth = 1e-30f;

        /// <summary>Adds up what a run of vertices induces at eight points.</summary>
        /// <param name="vertices">Chains of segments; the first of the run begins one.</param>
        /// <param name="first">First vertex of the run.</param>
        /// <param name="end">One past its last vertex.</param>
        /// <param name="low">Four points.</param>
        /// <param name="high">Four more.</param>
        /// <param name="lowVelocity">Velocities at the first four, reference lengths a beat.</param>
        /// <param name="highVelocity">Velocities at the others.</param>
        public static void Induce(
            in NativeArray<VortexVertex> vertices, int first, int end, in SoaFloat3 low, in SoaFloat3 high,
            out SoaFloat3 lowVelocity, out SoaFloat3 highVelocity)
        {
            SoaFloat3 a = default, b = default, sumA = default, sumB = default;
            float4 inverseA = default, inverseB = default;
            for (int k = first; k < end; k++)
            {
                VortexVertex vertex = vertices[k];
                var position = new SoaFloat3(vertex.position);
                SoaFloat3 nextA = low - position, nextB = high - position;
                float4 nextInverseA = Inverse(nextA), nextInverseB = Inverse(nextB);
                if (vertex.strength != 0f)
                {
                    var along = new SoaFloat3(vertex.along);
                    sumA += Segment(along, a, inverseA, nextA, nextInverseA, vertex.strength, vertex.core);
                    sumB += Segment(along, b, inverseB, nextB, nextInverseB, vertex.strength, vertex.core);
                }

                a = nextA;
                b = nextB;
                inverseA = nextInverseA;
                inverseB = nextInverseB;
            }

            lowVelocity = sumA;
            highVelocity = sumB;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Inverse(in SoaFloat3 v) => 1f / math.sqrt(SoaFloat3.LengthSquared(v) + k_Square);

        // r1 × r2 = r0 × r1 as r2 = r1 − r0, which loses no digits where both are long.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 Segment(
            in SoaFloat3 along, in SoaFloat3 from, float4 inverseFrom, in SoaFloat3 to, float4 inverseTo, float strength, float core)
        {
            var c = SoaFloat3.Cross(along, from);
            float4 d = SoaFloat3.Dot(along, from) * inverseFrom - SoaFloat3.Dot(along, to) * inverseTo;
            float4 square = SoaFloat3.LengthSquared(c);
            return c * (strength * d / math.sqrt(square * square + (core + k_Fourth)));
        }
    }
}
