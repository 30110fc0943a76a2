using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>Six planes around what an eye sees, four and two side by side; their normals point inwards. 128 bytes.</summary>
    internal struct CrowdFrustum
    {
        private float4 m_X, m_Y, m_Z, m_W;
        private float4 m_BackX, m_BackY, m_BackZ, m_BackW;

        /// <summary>Planes in any order, of unit normals.</summary>
        /// <param name="planes">Six.</param>
        public static CrowdFrustum Of(Plane[] planes)
        {
            var frustum = new CrowdFrustum();
            for (int k = 0; k < 4; k++)
            {
                Vector3 normal = planes[k].normal, back = planes[4 + (k & 1)].normal;
                frustum.m_X[k] = normal.x;
                frustum.m_Y[k] = normal.y;
                frustum.m_Z[k] = normal.z;
                frustum.m_W[k] = planes[k].distance;
                frustum.m_BackX[k] = back.x;
                frustum.m_BackY[k] = back.y;
                frustum.m_BackZ[k] = back.z;
                frustum.m_BackW[k] = planes[4 + (k & 1)].distance;
            }

            return frustum;
        }

        /// <summary>Returns true where a sphere that moves along a line may touch the frustum; near its edges also where not.</summary>
        /// <param name="sphere">Middle of the sphere at first, and its radius, world.</param>
        /// <param name="way">How far and where it moves; 0 for a sphere at rest.</param>
        public bool MayMeet(float4 sphere, float3 way)
        {
            float4 side = m_X * sphere.x + m_Y * sphere.y + m_Z * sphere.z + m_W;
            float4 back = m_BackX * sphere.x + m_BackY * sphere.y + m_BackZ * sphere.z + m_BackW;
            side += math.max(m_X * way.x + m_Y * way.y + m_Z * way.z, 0f);
            back += math.max(m_BackX * way.x + m_BackY * way.y + m_BackZ * way.z, 0f);
            return math.all(side >= -sphere.w & back >= -sphere.w);
        }
    }
}
