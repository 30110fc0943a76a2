using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Which level of detail an insect gets by its size on the screen.</summary>
    internal static class DetailChoice
    {
        /// <summary>A level is left only when the size has grown by this share beyond its threshold, so that it does not flicker.</summary>
        private const float k_Hysteresis = 0.15f;

        /// <summary>Share of the screen's height that a sphere fills; 0 when there is none.</summary>
        public static float ScreenHeight(Camera camera, float3 centre, float radius)
        {
            if (camera.orthographic)
                return radius / camera.orthographicSize;
            float distance = math.distance(centre, camera.transform.position);
            return radius / (math.max(distance, 1e-6f) * math.tan(0.5f * math.radians(camera.fieldOfView)));
        }

        /// <summary>The level for a size.</summary>
        /// <param name="screenHeight">Share of the screen's height.</param>
        /// <param name="thresholds">Below which the levels after the first begin.</param>
        /// <param name="current">The level now.</param>
        public static WingDetail Choose(float screenHeight, Vector4 thresholds, WingDetail current)
        {
            for (int level = (int)WingDetail.Frozen; level > (int)WingDetail.Full; level--)
            {
                float threshold = thresholds[level - 1];
                if (level <= (int)current)
                    threshold *= 1f + k_Hysteresis;
                if (screenHeight < threshold)
                    return (WingDetail)level;
            }

            return WingDetail.Full;
        }
    }
}
