using Unity.Mathematics;

namespace Alate
{
    /// <summary>A symmetric positive 6×6 matrix of force and moment against velocity and angular velocity, in blocks.</summary>
    internal struct Symmetric6
    {
        /// <summary>Force against velocity, force against turning, moment against turning.</summary>
        public float3x3 uu, uw, ww;

        /// <summary>Matrix times a vector.</summary>
        public readonly void Multiply(float3 u, float3 w, out float3 force, out float3 moment)
        {
            force = math.mul(uu, u) + math.mul(uw, w);
            moment = math.mul(u, uw) + math.mul(ww, w);
        }

        /// <summary>Solves for the vector that the matrix makes into force and moment: turning first, by the Schur complement.</summary>
        public readonly void Solve(float3 force, float3 moment, out float3 u, out float3 w)
        {
            float3x3 inverse = math.inverse(uu), carried = math.mul(inverse, uw);
            w = math.mul(math.inverse(ww - math.mul(math.transpose(uw), carried)), moment - math.mul(force, carried));
            u = math.mul(inverse, force - math.mul(uw, w));
        }
    }
}
