using Unity.Mathematics;

namespace Alate
{
    /// <summary>Surroundings of four wings, each in its own wing frame; lane = wing.</summary>
    /// <remarks>
    /// 68 bytes a wing: what changes once a step, apart from the parameters, so that writing it leaves them alone.
    /// </remarks>
    internal struct LaneSurroundings
    {
        /// <summary>Air velocity relative to the body, wing lengths per second.</summary>
        public SoaFloat3 wind;

        /// <summary>The wind as the wing feels it, derived once a step from <see cref="wind"/> and parameters.</summary>
        public SoaFloat3 boundWind;

        /// <summary>Gravity, wing lengths per second squared.</summary>
        public SoaFloat3 gravity;

        /// <summary>Angular velocity Ω of the body, rad/s.</summary>
        public SoaFloat3 angularVelocity;

        /// <summary>Vector to the hinge from the point whose velocity <see cref="wind"/> contains, wing lengths.</summary>
        public SoaFloat3 hinge;

        /// <summary>Speed of the body, m/s.</summary>
        public float4 speed;

        /// <summary>Pitch of the body (AoA of Eq. 6–7), radians.</summary>
        public float4 pitch;

        /// <summary>Writes one wing's surroundings.</summary>
        public void Set(int lane, in WingSurroundings surroundings)
        {
            wind[lane] = surroundings.wind;
            gravity[lane] = surroundings.gravity;
            angularVelocity[lane] = surroundings.angularVelocity;
            hinge[lane] = surroundings.hinge;
            speed[lane] = surroundings.speed;
            pitch[lane] = surroundings.angleOfAttack;
        }
    }
}
