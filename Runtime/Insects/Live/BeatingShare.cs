using Unity.Mathematics;

namespace Alate
{
    /// <summary>Share of its swing that an abdomen makes.</summary>
    internal static class BeatingShare
    {
        /// <summary>Share of the flap at full drive from which on an abdomen swings wholly.</summary>
        private const float k_Whole = 0.5f;

        /// <summary>Returns the share, 0 for wings at rest to 1.</summary>
        /// <param name="amplitude">Half of the flap of the first wing's beat, radians.</param>
        /// <param name="wing">That wing.</param>
        public static float Of(float amplitude, in WingParameters wing) =>
            math.saturate(amplitude / math.max(k_Whole * wing.amplitude.x, 1e-6f));
    }
}
