using Unity.Mathematics;

namespace Alate
{
    /// <summary>Air on four whole wings in one substep, in the wings' frames about the body's centre of mass; lane = wing. For the body that the wings carry.</summary>
    internal unsafe struct LaneAir
    {
        /// <summary>Entries of the upper triangle of a symmetric 6×6 matrix, row by row.</summary>
        public const int Entries = 21;

        /// <summary>Force, wing masses · L/s².</summary>
        public SoaFloat3 force;

        /// <summary>Moment, wing masses · L²/s².</summary>
        public SoaFloat3 moment;

        /// <summary>Power that the wing gives to the air, wing masses · L²/s³.</summary>
        public float4 power;

        /// <summary>K: force and moment that a unit of velocity and angular velocity takes away, [entry][lane].</summary>
        public fixed float damping[Entries * 4];

        /// <summary>Entry k of K in one wing.</summary>
        public float Damping(int k, int lane) => damping[4 * k + lane];
    }
}
