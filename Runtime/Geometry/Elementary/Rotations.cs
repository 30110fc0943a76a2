using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>Rotations by angles, as Unity.Mathematics makes them, with the sines of <see cref="Elementary"/>.</summary>
    internal static class Rotations
    {
        /// <summary>Cosine of half the angle apart from which on two rotations are blended in a straight line.</summary>
        private const float k_Near = 0.9995f;

        /// <summary>Rotation about the x axis, radians.</summary>
        public static quaternion AboutX(float angle)
        {
            Elementary.SinCos(0.5f * angle, out float sin, out float cos);
            return new quaternion(sin, 0f, 0f, cos);
        }

        /// <summary>Rotation about the y axis, radians.</summary>
        public static quaternion AboutY(float angle)
        {
            Elementary.SinCos(0.5f * angle, out float sin, out float cos);
            return new quaternion(0f, sin, 0f, cos);
        }

        /// <summary>Rotation on the shorter way from one to another at constant angular speed.</summary>
        public static quaternion Slerp(quaternion from, quaternion to, float share)
        {
            float cosine = math.dot(from, to);
            float4 end = cosine < 0f ? -to.value : to.value;
            cosine = math.abs(cosine);
            if (cosine >= k_Near)
                return math.nlerp(from, new quaternion(end), share);
            float angle = Elementary.Acos(cosine), scale = math.rsqrt(1f - cosine * cosine);
            return new quaternion(
                from.value * (Elementary.Sin(angle * (1f - share)) * scale) + end * (Elementary.Sin(angle * share) * scale));
        }
    }
}
