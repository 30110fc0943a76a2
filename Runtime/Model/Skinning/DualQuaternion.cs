using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// A rigid transform as a dual quaternion q + ε e (Kavan et al. 2007). Sums of them blend transforms without collapsing; a blend
    /// need not be normalised before it is applied.
    /// </summary>
    internal struct DualQuaternion
    {
        public float4 real;
        public float4 dual;

        /// <summary>Makes a transform that rotates first, then translates.</summary>
        public DualQuaternion(quaternion rotation, float3 translation)
        {
            real = rotation.value;
            var t = new quaternion(new float4(translation, 0f));
            dual = 0.5f * math.mul(t, rotation).value;
        }

        /// <summary>Moves a point, by a transform of unit length.</summary>
        public float3 Move(float3 point)
        {
            float3 q = real.xyz, e = dual.xyz;
            return point + 2f * (math.cross(q, math.cross(q, point) + real.w * point + e) + real.w * e - dual.w * q);
        }

        /// <summary>Transform with its sign chosen to lie on the side of <paramref name="pivot"/> (antipodality).</summary>
        public DualQuaternion AlignedWith(in DualQuaternion pivot)
        {
            float sign = math.dot(real, pivot.real) < 0f ? -1f : 1f;
            return new DualQuaternion { real = real * sign, dual = dual * sign };
        }
    }
}
