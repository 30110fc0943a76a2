using Unity.Mathematics;

namespace Alate
{
    /// <summary>What an insect's body does and feels, in the world; from it each wing's surroundings follow.</summary>
    internal struct BodyFlight
    {
        /// <summary>The body's own place, world.</summary>
        public float3 position;

        /// <summary>World units per second.</summary>
        public float3 velocity;

        /// <summary>Radians per second.</summary>
        public float3 angularVelocity;

        /// <summary>Air, world units per second.</summary>
        public float3 wind;

        /// <summary>Where the body looks, unit vector, world.</summary>
        public float3 forward;

        /// <summary>Gravity, m/s²: that of the scene's physics.</summary>
        public float3 gravity;

        /// <summary>Metres that a world unit stands for; 0 takes the wing's own size for life size.</summary>
        public float metresPerUnit;

        /// <summary>Pitch of the body, radians, nose up positive; 0 where there is no gravity to tell.</summary>
        public float Pitch => math.asin(math.clamp(-math.dot(forward, math.normalizesafe(gravity)), -1f, 1f));

        /// <summary>What a wing feels, in its own frame (<see cref="WingSurroundings"/>).</summary>
        public WingSurroundings Around(in PlacedWing wing, float wingLength, float gravityShare)
        {
            float scale = metresPerUnit > 0f ? metresPerUnit : wingLength / wing.length;
            return new WingSurroundings
            {
                wind = wing.ToWing(wind - velocity) * (scale / wingLength),
                angularVelocity = wing.AxisToWing(angularVelocity),
                hinge = wing.ToWing(wing.hinge - position) * (scale / wingLength),
                gravity = wing.ToWing(gravity) * (gravityShare / wingLength),
                speed = math.length(velocity) * scale,
                angleOfAttack = Pitch,
            };
        }
    }
}
