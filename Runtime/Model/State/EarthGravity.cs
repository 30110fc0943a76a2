using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Gravity where no scene says it: for trims, bakes and flights of tools. A living insect takes that of its scene's physics.
    /// </summary>
    internal static class EarthGravity
    {
        /// <summary>Its size, m/s²: that of a new Unity project.</summary>
        public const float Size = (float)Precise;

        /// <summary>Its size for sums in double precision, m/s².</summary>
        public const double Precise = 9.81;

        /// <summary>Acceleration downwards, m/s².</summary>
        public static float3 Down => new float3(0f, -Size, 0f);
    }
}
