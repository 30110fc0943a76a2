using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>Makes the view of a camera, in the place that it has when it begins to draw.</summary>
    internal static class CameraView
    {
        private static readonly Plane[] s_Planes = new Plane[6];

        /// <summary>The view of a camera.</summary>
        /// <param name="camera">The camera.</param>
        /// <param name="casts">True where insects cast shadows: those count too that are seen by their shadow alone.</param>
        public static CrowdView Of(Camera camera, bool casts)
        {
            Transform place = camera.transform;
            var view = new CrowdView
            {
                eye = place.position,
                ahead = place.forward,
                halfHeight = camera.orthographic ? 0f : Elementary.Tan(0.5f * math.radians(camera.fieldOfView)),
                flatHeight = camera.orthographic ? camera.orthographicSize : 0f,
                isStereo = camera.stereoEnabled,
            };
            view.frustum = view.isStereo ? EyeOf(camera, Camera.StereoscopicEye.Left) : FrustumOf(camera.cullingMatrix);
            if (view.isStereo)
                view.rightFrustum = EyeOf(camera, Camera.StereoscopicEye.Right);

            // A probe's camera looks to six sides in one frame, and what is drawn for the first is drawn for all.
            if (camera.cameraType == CameraType.Reflection)
                view.around = camera.farClipPlane;
            if (casts)
                AddShadows(ref view, camera);
            return view;
        }

        // The lamps of a scene are not asked one by one: where the sun casts no shadow, all within the distance of shadows may.
        private static void AddShadows(ref CrowdView view, Camera camera)
        {
            Light sun = RenderSettings.sun;
            if (sun != null && sun.isActiveAndEnabled && sun.shadows != LightShadows.None)
                view.shadow = camera.farClipPlane * (float3)sun.transform.forward;
            else
                view.around = math.max(view.around, QualitySettings.shadowDistance);
        }

        private static CrowdFrustum EyeOf(Camera camera, Camera.StereoscopicEye side) =>
            FrustumOf(camera.GetStereoProjectionMatrix(side) * camera.GetStereoViewMatrix(side));

        private static CrowdFrustum FrustumOf(Matrix4x4 worldToPicture)
        {
            GeometryUtility.CalculateFrustumPlanes(worldToPicture, s_Planes);
            return CrowdFrustum.Of(s_Planes);
        }
    }
}
