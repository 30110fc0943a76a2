using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The load on one patch, as <see cref="Aerodynamics"/> puts it together for the patches of a cell.</summary>
    internal static class PatchLoads
    {
        /// <summary>
        /// Eq. 9 and 10 for one element of four wings, at once; a wing's many elements take the three steps one after the other.
        /// </summary>
        /// <param name="options">Coefficients and tangent.</param>
        /// <param name="wind">V, air minus surface velocity.</param>
        /// <param name="normal">Unit normal of the element.</param>
        /// <param name="alongSpan">|V·e_s| for the printed tangent (base to tip); not read else.</param>
        /// <param name="halfDensityArea">½ρ*A.</param>
        public static unsafe PatchLoad Of(
            in ModelOptions options, in SoaFloat3 wind, in SoaFloat3 normal, float4 alongSpan, float4 halfDensityArea)
        {
            PatchStream stream = PatchAir.Evaluate(wind, normal);
            if (options.tangent == AirTangent.BaseToTip)
                stream.tangential = alongSpan;
            Coefficients.Evaluate(options, &stream, 1);
            PatchLoad load;
            load.force = PatchAir.Force(stream, wind, normal, halfDensityArea);
            load.damping = PatchAir.Damping(stream, halfDensityArea, out load.sinAttack);
            return load;
        }
    }
}
