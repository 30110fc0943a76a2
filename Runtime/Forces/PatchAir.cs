using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Aerodynamic force on one surface element in an air stream (Eq. 9, 10).</summary>
    internal static class PatchAir
    {
        /// <summary>Below this squared air speed (L²/s²) there is no force.</summary>
        private const float k_LeastSpeedSquared = 1e-12f;

        /// <summary>Below this sine of the angle between stream and normal there is no lift.</summary>
        private const float k_LeastTangent = 1e-6f;

        /// <summary>The damping estimate divides by the sine of the angle of attack, never by less.</summary>
        private const float k_LeastSine = 0.05f;

        /// <summary>Eq. 9 and 10 for one element of four wings.</summary>
        /// <param name="options">Coefficients and tangent.</param>
        /// <param name="wind">V, air minus surface velocity.</param>
        /// <param name="normal">Unit normal of the element.</param>
        /// <param name="alongSpan">|V·e_s| for the printed tangent (base to tip); not read else.</param>
        /// <param name="halfDensityArea">½ρ*A.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static PatchLoad Load(in ModelOptions options, SoaFloat3 wind, SoaFloat3 normal, float4 alongSpan, float4 halfDensityArea)
        {
            float4 speed2 = SoaFloat3.LengthSquared(wind);
            float4 speed = math.sqrt(speed2);
            float4 signed = SoaFloat3.Dot(wind, normal);
            float4 across = math.abs(signed);
            float4 along = math.sqrt(math.max(speed2 - signed * signed, 0f));
            float4 tangential = options.tangent == AirTangent.BaseToTip ? alongSpan : along;
            Coefficients.Evaluate(options, across, tangential, out float4 lift, out float4 drag);

            // Lift acts along unit(n − (n·D)D) = (|V| n − (V·n) V/|V|) / along, so both forces are a sum of n and V.
            float4 turned = math.select(lift / math.max(along, 1e-12f), 0f, along < k_LeastTangent * speed);
            float4 alive = math.select(halfDensityArea * speed, 0f, speed2 < k_LeastSpeedSquared);
            PatchLoad load;
            load.force = normal * (alive * turned * SoaMath.Sign(signed) * speed2) + wind * (alive * (drag - turned * across));

            float4 inverse = SoaMath.SafeReciprocal(speed);
            load.sinAttack = across * inverse;
            float4 sine = math.max(load.sinAttack, k_LeastSine);
            load.damping = alive * (1f + sine * sine) * math.max(lift * along * inverse + drag * sine, 0f) / sine;
            return load;
        }
    }
}
