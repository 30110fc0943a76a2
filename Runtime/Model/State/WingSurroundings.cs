using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Surroundings of one wing, in its own right-wing frame: X hinge to tip, Y up, Z forward.</summary>
    /// <remarks>
    /// A left wing is simulated as a right wing: negate x of its wind, gravity and hinge, and y and z of its angular velocity.
    /// </remarks>
    [MovedFrom(true, null, "Alate")]
    public struct WingSurroundings
    {
        /// <summary>Air velocity minus body velocity, wing lengths per second.</summary>
        public float3 wind;

        /// <summary>
        /// Angular velocity Ω of the body, radians per second. A point of the wing at x from the hinge meets wind − Ω ×
        /// (<see cref="hinge"/> + x). +X turns the nose down, +Y the nose to the right, +Z lifts a right wing.
        /// </summary>
        public float3 angularVelocity;

        /// <summary>
        /// Vector to the hinge from the point of the body whose velocity <see cref="wind"/> contains, as a rule the centre of mass, wing
        /// lengths; 0 where <see cref="wind"/> is that at the hinge. The moment of the air is about that point.
        /// </summary>
        public float3 hinge;

        /// <summary>Gravity, wing lengths per second squared; −161 along the world's up for a monarch.</summary>
        public float3 gravity;

        /// <summary>Speed of the body |u| (Eq. 6–7), metres per second, at least 0.</summary>
        public float speed;

        /// <summary>Pitch of the body (AoA of Eq. 6–7): asin(forward · up), radians, −π/2…π/2.</summary>
        public float angleOfAttack;

        /// <summary>True when every component is finite.</summary>
        public readonly bool IsFinite =>
            math.all(math.isfinite(wind)) && math.all(math.isfinite(gravity)) && math.all(math.isfinite(angularVelocity))
            && math.all(math.isfinite(hinge)) && math.isfinite(speed) && math.isfinite(angleOfAttack);

        /// <summary>Finds the first value that is not finite; null where there is none.</summary>
        internal readonly string FindProblem()
        {
            if (IsFinite)
                return null;
            return Problem(nameof(wind), wind) ?? Problem(nameof(gravity), gravity) ?? Problem(nameof(angularVelocity), angularVelocity)
                ?? Problem(nameof(hinge), hinge) ?? Problem(nameof(speed), speed) ?? Problem(nameof(angleOfAttack), angleOfAttack);
        }

        private static string Problem(string name, float3 value) =>
            math.all(math.isfinite(value)) ? null : $"{name} is ({value.x}, {value.y}, {value.z}); it must be finite.";

        private static string Problem(string name, float value) => math.isfinite(value) ? null : $"{name} is {value}; it must be finite.";
    }
}
