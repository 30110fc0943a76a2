using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>One 3×3 matrix of four wings, by columns; lane = wing.</summary>
    internal struct SoaFloat3x3
    {
        /// <summary>First column: the image of the x axis.</summary>
        public SoaFloat3 c0;

        /// <summary>Second column: the image of the y axis.</summary>
        public SoaFloat3 c1;

        /// <summary>Third column: the image of the z axis.</summary>
        public SoaFloat3 c2;

        /// <summary>The rotation matrix of a unit quaternion.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public SoaFloat3x3(SoaQuaternion q)
        {
            SoaFloat3 v2 = q.v + q.v;
            float4 xx = q.v.x * v2.x, yy = q.v.y * v2.y, zz = q.v.z * v2.z;
            float4 xy = q.v.x * v2.y, xz = q.v.x * v2.z, yz = q.v.y * v2.z;
            float4 wx = q.w * v2.x, wy = q.w * v2.y, wz = q.w * v2.z;
            c0 = new SoaFloat3(1f - yy - zz, xy + wz, xz - wy);
            c1 = new SoaFloat3(xy - wz, 1f - xx - zz, yz + wx);
            c2 = new SoaFloat3(xz + wy, yz - wx, 1f - xx - yy);
        }

        /// <summary>Matrix times a vector that is the same in all wings.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Mul(in SoaFloat3x3 m, float3 v) => m.c0 * v.x + m.c1 * v.y + m.c2 * v.z;

        /// <summary>Matrix times a vector of each wing.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Mul(in SoaFloat3x3 m, SoaFloat3 v) => m.c0 * v.x + m.c1 * v.y + m.c2 * v.z;
    }
}
