using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Air on four whole wings in one substep, in the wings' frames about the body's centre of mass; lane = wing. For the body that the
    /// wings carry.
    /// </summary>
    internal struct LaneAir
    {
        /// <summary>Force, wing masses · L/s².</summary>
        public SoaFloat3 force;

        /// <summary>Moment, wing masses · L²/s².</summary>
        public SoaFloat3 moment;

        /// <summary>Power that the wing gives to the air, wing masses · L²/s³.</summary>
        public float4 power;

        /// <summary>
        /// K, what a unit of velocity and of angular velocity takes away: force against velocity, force against turning, moment against
        /// turning.
        /// </summary>
        public SoaFloat3x3 uu, uw, ww;
    }
}
