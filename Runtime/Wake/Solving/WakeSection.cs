using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Loads of the air on a strip of a wing, from its leading edge to its trailing edge, in a step of a <see cref="FreeWake"/>: over the
    /// density of the fluid, in axes of the body; L is the reference length.
    /// </summary>
    public readonly struct WakeSection
    {
        internal WakeSection(float span, float circulation, float3 force, float3 inflow)
        {
            Span = span;
            Circulation = circulation;
            Force = force;
            Inflow = inflow;
        }

        /// <summary>Place of the strip's middle between the root, 0, and the tip, 1.</summary>
        public float Span { get; }

        /// <summary>
        /// Circulation Γ around the strip, L² a beat: air that streams past it with a velocity V makes a force Γ V × s over the length of
        /// span, where s points from the root to the tip (Kutta and Joukowski).
        /// </summary>
        public float Circulation { get; }

        /// <summary>Force of the air, L⁴ a squared beat. All strips together have that of <see cref="WakeLoads.Force"/>.</summary>
        public float3 Force { get; }

        /// <summary>
        /// Velocity of the air that vortices have set moving, L a beat: a mean over the chord, weighted and counted as
        /// <see cref="WakeLoads.Inflow"/> is.
        /// </summary>
        public float3 Inflow { get; }
    }
}
