using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Aerodynamic force on one surface element in an air stream (Eq. 9, 10).</summary>
    internal static class PatchAir
    {
        /// <summary>Air speed below which there is no force, L/s.</summary>
        private const float k_LeastSpeed = 1e-6f;

        /// <summary>Sine of the angle between stream and normal below which there is no lift.</summary>
        private const float k_LeastTangent = 1e-6f;

        /// <summary>Least sine of the angle of attack by which the damping estimate divides.</summary>
        private const float k_LeastSine = 0.05f;

        /// <summary>First step: finds the stream in the frame of the element.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static PatchStream Evaluate(in SoaFloat3 wind, in SoaFloat3 normal)
        {
            float4 speed2 = SoaFloat3.LengthSquared(wind);
            float4 across = SoaFloat3.Dot(wind, normal);
            PatchStream stream = default;
            stream.speed = math.sqrt(speed2);
            stream.across = across;
            stream.along = math.sqrt(math.max(speed2 - across * across, 0f));
            stream.tangential = stream.along;
            return stream;
        }

        /// <summary>Third step, after <see cref="Coefficients.Evaluate"/>: finds the force.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Force(in PatchStream stream, in SoaFloat3 wind, in SoaFloat3 normal, float4 halfDensityArea)
        {
            // Lift acts along unit(n − (n·D)D) = (|V| n − (V·n) V/|V|) / along, so both forces are a sum of n and V.
            float4 speed = stream.speed, across = math.abs(stream.across);
            float4 turned = math.select(stream.lift / math.max(stream.along, 1e-12f), 0f, stream.along < k_LeastTangent * speed);
            float4 alive = math.select(halfDensityArea * speed, 0f, speed < k_LeastSpeed);
            float4 lifting = alive * turned * (speed * speed);
            return normal * math.select(lifting, -lifting, stream.across < 0f) + wind * (alive * (stream.drag - turned * across));
        }

        /// <summary>Estimate of −dF/dv, with the sine of the angle of attack.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float4 Damping(in PatchStream stream, float4 halfDensityArea, out float4 sinAttack)
        {
            float4 inverse = 1f / math.max(stream.speed, 1e-12f);
            sinAttack = math.abs(stream.across) * inverse;
            float4 sine = math.max(sinAttack, k_LeastSine);
            float4 slope = math.max(stream.lift * stream.along * inverse + stream.drag * sine, 0f);
            return halfDensityArea * stream.speed * (1f + sine * sine) * slope / sine;
        }
    }
}
