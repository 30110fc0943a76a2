using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Headings: radians about the world's up, 0 along +Z, π/2 along +X.</summary>
    internal static class Headings
    {
        /// <summary>The heading of a rotation's forward direction.</summary>
        public static float Of(quaternion rotation)
        {
            float3 ahead = math.rotate(rotation, new float3(0f, 0f, 1f));
            return Elementary.Atan2(ahead.x, ahead.z);
        }

        /// <summary>Angle less whole turns, −π to π.</summary>
        public static float Wrap(float angle) => angle - 2f * math.PI * math.round(angle / (2f * math.PI));
    }
}
