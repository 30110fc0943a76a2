using Unity.Mathematics;

namespace Alate
{
    /// <summary>What one wing feels of the world, in its own right-wing frame: X hinge to tip, Y up, Z forward.</summary>
    /// <remarks>For a left wing mirror the x components first: it is simulated as a right wing.</remarks>
    public struct WingSurroundings
    {
        /// <summary>Air velocity minus body velocity, wing lengths per second.</summary>
        public float3 wind;

        /// <summary>Gravity, wing lengths per second squared; −161 along the world's up for a monarch.</summary>
        public float3 gravity;

        /// <summary>Speed of the body |u| (Eq. 6–7), metres per second, at least 0.</summary>
        public float speed;

        /// <summary>Pitch of the body (AoA of Eq. 6–7): asin(forward · up), radians, −π/2…π/2.</summary>
        public float angleOfAttack;

        /// <summary>True when every component is finite.</summary>
        public bool IsFinite =>
            math.all(math.isfinite(wind)) && math.all(math.isfinite(gravity)) && math.isfinite(speed) && math.isfinite(angleOfAttack);
    }
}
