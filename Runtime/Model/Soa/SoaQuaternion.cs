using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>One rotation of four wings: component-wise, lane = wing, with Unity's algebra v' = q v q*.</summary>
    internal struct SoaQuaternion
    {
        /// <summary>The vector part.</summary>
        public SoaFloat3 v;

        /// <summary>The scalar part.</summary>
        public float4 w;

        /// <summary>Vector and scalar part.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public SoaQuaternion(SoaFloat3 v, float4 w)
        {
            this.v = v;
            this.w = w;
        }

        /// <summary>The opposite rotation of a unit quaternion.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Conjugate(SoaQuaternion q) => new SoaQuaternion(-q.v, q.w);

        /// <summary>Product: rotates by <paramref name="b"/> first, then by <paramref name="a"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion operator *(SoaQuaternion a, SoaQuaternion b) => new SoaQuaternion(
            new SoaFloat3(
                a.w * b.v.x + a.v.x * b.w + a.v.y * b.v.z - a.v.z * b.v.y,
                a.w * b.v.y + a.v.y * b.w + a.v.z * b.v.x - a.v.x * b.v.z,
                a.w * b.v.z + a.v.z * b.w + a.v.x * b.v.y - a.v.y * b.v.x),
            a.w * b.w - a.v.x * b.v.x - a.v.y * b.v.y - a.v.z * b.v.z);

        /// <summary>Scaled by one factor per wing; not a rotation any more.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion operator *(SoaQuaternion q, float4 s) => new SoaQuaternion(q.v * s, q.w * s);

        /// <summary>Sum, component by component.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion operator +(SoaQuaternion a, SoaQuaternion b) => new SoaQuaternion(a.v + b.v, a.w + b.w);

        /// <summary>Difference of one rotation, with the sign that is nearer to the other one, from that one: no rotation.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Difference(SoaQuaternion from, SoaQuaternion to)
        {
            float4 sign = SoaMath.Sign(SoaFloat3.Dot(from.v, to.v) + from.w * to.w);
            return new SoaQuaternion(to.v - from.v * sign, to.w - from.w * sign);
        }

        /// <summary>The vector turned by a unit quaternion.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaFloat3 Rotate(SoaQuaternion q, SoaFloat3 p)
        {
            var t = SoaFloat3.Cross(q.v, p);
            t += t;
            return p + t * q.w + SoaFloat3.Cross(q.v, t);
        }

        /// <summary>Unit quaternion; callers never pass zero.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Normalize(SoaQuaternion q)
        {
            float4 s = 1f / math.sqrt(SoaFloat3.LengthSquared(q.v) + q.w * q.w);
            return new SoaQuaternion(q.v * s, q.w * s);
        }

        /// <summary>Halfway between two unit quaternions, the shortest way (nlerp at ½).</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Halfway(SoaQuaternion a, SoaQuaternion b)
        {
            float4 sign = SoaMath.Sign(SoaFloat3.Dot(a.v, b.v) + a.w * b.w);
            return Normalize(new SoaQuaternion(a.v + b.v * sign, a.w + b.w * sign));
        }

        /// <summary>
        /// Rotation by <paramref name="first"/>, then by the shortest one that takes the direction of <paramref name="from"/> to that of
        /// <paramref name="to"/>, both unit vectors that are not opposite.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Swing(SoaFloat3 from, SoaFloat3 to, SoaQuaternion first)
        {
            float4 w = math.max(1f + SoaFloat3.Dot(from, to), 1e-6f);
            return Normalize(new SoaQuaternion(SoaFloat3.Cross(from, to), w) * first);
        }

        /// <summary>The rotation by a small vector of angles (radians, below about 1.2): the exponential map, by its series.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Exp(SoaFloat3 angles)
        {
            float4 h2 = 0.25f * SoaFloat3.LengthSquared(angles);
            float4 sinc = 1f + h2 * (-1f / 6f + h2 * (1f / 120f + h2 * (-1f / 5040f + h2 * (1f / 362880f))));
            float4 cos = 1f + h2 * (-0.5f + h2 * (1f / 24f + h2 * (-1f / 720f + h2 * (1f / 40320f))));
            return new SoaQuaternion(angles * (0.5f * sinc), cos);
        }

        /// <summary>Per wing: <paramref name="b"/> where <paramref name="test"/> holds, else <paramref name="a"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static SoaQuaternion Select(SoaQuaternion a, SoaQuaternion b, bool4 test) =>
            new SoaQuaternion(SoaFloat3.Select(a.v, b.v, test), math.select(a.w, b.w, test));

        /// <summary>The rotation of one wing.</summary>
        public quaternion this[int lane] => new quaternion(v.x[lane], v.y[lane], v.z[lane], w[lane]);
    }
}
