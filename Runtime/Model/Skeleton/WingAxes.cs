using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Right-angled unit axes from a skeleton's span and up axis.</summary>
    internal static class WingAxes
    {
        /// <summary>Sine below which span and up count as parallel.</summary>
        private const float k_LeastSine = 1e-3f;

        /// <summary>
        /// Makes the axes as columns: span, up (made perpendicular to span), cross(span, up). False for zero, non-finite or parallel axes.
        /// </summary>
        public static bool TryMake(Vector3 span, Vector3 up, out float3x3 axes)
        {
            axes = float3x3.identity;
            if (!TryDirection(span, out float3 x) || !TryDirection(up, out float3 y))
                return false;
            y -= x * math.dot(x, y);
            float sine = math.length(y);
            if (sine < k_LeastSine)
                return false;
            y /= sine;
            y = math.normalize(y - x * math.dot(x, y));
            axes = new float3x3(x, y, math.cross(x, y));
            return true;
        }

        // Scaled first, so that neither tiny nor huge vectors lose their direction.
        private static bool TryDirection(Vector3 v, out float3 direction)
        {
            float3 a = v;
            float largest = math.cmax(math.abs(a));
            bool usable = largest > 0f && math.all(math.isfinite(a));
            direction = usable ? math.normalize(a / largest) : default;
            return usable;
        }
    }
}
