using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>Load of the air on a part of a wing; axes of the body, reference lengths, beats, over the density of the fluid.</summary>
    internal struct WingLoad
    {
        /// <summary>Place at which the force acts, and its velocity.</summary>
        public float3 place, motion;

        public float3 force;

        /// <summary>Velocity of the air that vortices have set moving there.</summary>
        public float3 inflow;

        /// <summary>
        /// Weight of the inflow in means: the area times the speed of the air against the part, as a little more air changes the force by
        /// that much.
        /// </summary>
        public float weight;

        /// <summary>Mean of inflows that were summed up with their weights.</summary>
        public readonly float3 MeanInflow => weight > 0f ? inflow / weight : default;
    }
}
