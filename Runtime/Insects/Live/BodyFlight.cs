using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Motion of an insect's body, wind and gravity, in the world; each wing's surroundings follow from it.</summary>
    internal struct BodyFlight
    {
        /// <summary>Position of the body, world.</summary>
        public float3 position;

        /// <summary>Velocity of the body, world units per second.</summary>
        public float3 velocity;

        /// <summary>Angular velocity of the body, radians per second.</summary>
        public float3 angularVelocity;

        /// <summary>Velocity of the air, world units per second.</summary>
        public float3 wind;

        /// <summary>Forward direction of the body, unit vector, world.</summary>
        public float3 forward;

        /// <summary>Gravity of the scene's physics, m/s².</summary>
        public float3 gravity;

        /// <summary>Metres that a world unit stands for; 0 takes the wing's own size for life size.</summary>
        public float metresPerUnit;

        /// <summary>Pitch of the body, radians, nose up positive; 0 where there is no gravity to tell.</summary>
        public float Pitch => Elementary.Asin(math.clamp(-math.dot(forward, math.normalizesafe(gravity)), -1f, 1f));

        /// <summary>Surroundings of a wing, in its own frame (<see cref="WingSurroundings"/>).</summary>
        public WingSurroundings Around(in PlacedWing wing, float wingLength, float gravityShare) =>
            Around(wing, wingLength, gravityShare, Pitch);

        /// <summary>The same, with the body's <see cref="Pitch"/> computed once for all wings.</summary>
        public WingSurroundings Around(in PlacedWing wing, float wingLength, float gravityShare, float pitch)
        {
            float scale = metresPerUnit > 0f ? metresPerUnit : wingLength / wing.length;
            return new WingSurroundings
            {
                wind = wing.ToWing(wind - velocity) * (scale / wingLength),
                angularVelocity = wing.AxisToWing(angularVelocity),
                hinge = wing.ToWing(wing.hinge - position) * (scale / wingLength),
                gravity = wing.ToWing(gravity) * (gravityShare / wingLength),
                speed = math.length(velocity) * scale,
                angleOfAttack = pitch,
            };
        }
    }
}
