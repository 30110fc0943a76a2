using Unity.Mathematics;

namespace Alate
{
    /// <summary>Air stream at one element of four wings.</summary>
    /// <remarks>
    /// 28 bytes a wing, patch behind patch: the stream is filled, gets its coefficients and is turned into a load in three passes, and each
    /// reads most of it.
    /// </remarks>
    internal struct PatchStream
    {
        /// <summary>Speed |V|, L/s.</summary>
        public float4 speed;

        /// <summary>Component V·n along the normal, L/s.</summary>
        public float4 across;

        /// <summary>Size |V − (V·n)n| of the component in the surface, L/s.</summary>
        public float4 along;

        /// <summary>Component against which the angle of attack is measured, L/s.</summary>
        public float4 tangential;

        /// <summary>Angle of attack α, radians, 0…π/2; only where the coefficients need it.</summary>
        public float4 angle;

        /// <summary>Lift coefficient C_L.</summary>
        public float4 lift;

        /// <summary>Drag coefficient C_D.</summary>
        public float4 drag;
    }
}
