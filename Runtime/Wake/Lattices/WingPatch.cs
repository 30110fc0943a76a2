using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>Patch of a wing that meets the air; axes of the body, reference lengths, beats.</summary>
    internal struct WingPatch
    {
        /// <summary>Its middle, and how that moves.</summary>
        public float3 place, motion;

        /// <summary>Velocity of the chord a quarter of its length ahead of its middle, less that of the middle.</summary>
        public float3 turning;

        /// <summary>Unit vectors across it, and in it from the root to the tip.</summary>
        public float3 normal, span;

        /// <summary>Squared reference lengths.</summary>
        public float area;
    }
}
