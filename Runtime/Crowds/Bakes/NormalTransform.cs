using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>Turns normals as a matrix turns the surface they stand on: by the inverse transposed matrix.</summary>
    internal readonly struct NormalTransform
    {
        private readonly float3x3 m_Matrix;

        public NormalTransform(in Matrix4x4 matrix)
        {
            float3 x = matrix.MultiplyVector(Vector3.right), y = matrix.MultiplyVector(Vector3.up),
                z = matrix.MultiplyVector(Vector3.forward);

            // The adjugate is the inverse times the determinant, of which only the sign matters.
            float side = math.dot(x, math.cross(y, z)) < 0f ? -1f : 1f;
            m_Matrix = new float3x3(math.cross(y, z) * side, math.cross(z, x) * side, math.cross(x, y) * side);
        }

        /// <summary>A unit normal; up where there is none.</summary>
        public float3 Apply(float3 normal) => math.normalizesafe(math.mul(m_Matrix, normal), new float3(0f, 1f, 0f));
    }
}
