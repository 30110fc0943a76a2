using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Loads of the air on a wing in a step of a <see cref="FreeWake"/>, over the density of the fluid, in axes of the body; L is the
    /// reference length.
    /// </summary>
    public readonly struct WakeLoads
    {
        internal WakeLoads(float3 force, float3 moment, float power, float3 inflow)
        {
            Force = force;
            Moment = moment;
            Power = power;
            Inflow = inflow;
        }

        /// <summary>Force of the air, L⁴ a squared beat.</summary>
        public float3 Force { get; }

        /// <summary>Moment of the air about the origin, L⁵ a squared beat.</summary>
        public float3 Moment { get; }

        /// <summary>Power that the wing gives to the air, L⁵ a cubed beat; below 0 where the air drives the wing.</summary>
        public float Power { get; }

        /// <summary>
        /// Velocity of the air that vortices have set moving, L a beat: a mean over the wing, weighted by the speed at which it meets the
        /// air. What the lift coefficients of strips hold of it is left out: this flow, added to the wind of a model without a wake, gives
        /// these loads.
        /// </summary>
        public float3 Inflow { get; }
    }
}
