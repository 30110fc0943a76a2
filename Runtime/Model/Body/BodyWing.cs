using Unity.Mathematics;

namespace Alate
{
    /// <summary>Place of one wing on a flying body: its lane, and the way between its frame and the body's.</summary>
    internal struct BodyWing
    {
        /// <summary>Index of the pack among those of the jobs.</summary>
        public int pack;

        /// <summary>Lane in the pack.</summary>
        public int lane;

        /// <summary>First and end of the lanes that copy the wing's, where the pack is not full.</summary>
        public int firstCopy, endCopy;

        /// <summary>Directions of the wing frame in body axes; a left wing's mirrors.</summary>
        public float3x3 axes;

        /// <summary>Determinant of <see cref="axes"/>: −1 for a mirror, which turns axes of turning round.</summary>
        public float handedness;

        /// <summary>The hinge from the centre of mass in body axes, metres.</summary>
        public float3 hinge;

        /// <summary>Length of the wing, metres.</summary>
        public float length;

        /// <summary>Mass of the wing, kilograms.</summary>
        public float mass;

        /// <summary>Share of gravity that the wing feels.</summary>
        public float gravityShare;

        /// <summary>Number of the wing among those of its side.</summary>
        public int pair;

        /// <summary>1 for a right wing, −1 for a left one.</summary>
        public float side;

        /// <summary>A direction of the body in the wing's frame.</summary>
        public float3 ToWing(float3 body) => math.mul(body, axes);

        /// <summary>A direction of the wing's frame in body axes.</summary>
        public float3 ToBody(float3 wing) => math.mul(axes, wing);
    }
}
