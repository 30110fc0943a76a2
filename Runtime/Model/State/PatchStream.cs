using Unity.Mathematics;

namespace Alate
{
    /// <summary>The air stream at one element of four wings.</summary>
    internal struct PatchStream
    {
        /// <summary>|V|, L/s.</summary>
        public float4 speed;

        /// <summary>V·n.</summary>
        public float4 across;

        /// <summary>|V − (V·n)n|.</summary>
        public float4 along;

        /// <summary>What the angle of attack is measured against.</summary>
        public float4 tangential;

        /// <summary>α, radians, 0…π/2; only where the coefficients need it.</summary>
        public float4 angle;

        /// <summary>C_L.</summary>
        public float4 lift;

        /// <summary>C_D.</summary>
        public float4 drag;
    }
}
