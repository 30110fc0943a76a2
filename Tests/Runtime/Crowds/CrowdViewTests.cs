using System.Linq;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Crowds
{
    /// <summary>Spheres that a camera sees, against what it shows of points, its eyes, and shadows on their way.</summary>
    public sealed class CrowdViewTests
    {
        private Camera m_Camera;

        [SetUp]
        public void MakeACamera()
        {
            m_Camera = new GameObject("eye").AddComponent<Camera>();
            m_Camera.transform.SetPositionAndRotation(new Vector3(1f, 2f, -3f), Quaternion.Euler(20f, 130f, 5f));
            m_Camera.nearClipPlane = 0.5f;
            m_Camera.farClipPlane = 40f;
            m_Camera.fieldOfView = 50f;
        }

        [TearDown]
        public void DestroyTheCamera()
        {
            RenderSettings.sun = null;
            Object.DestroyImmediate(m_Camera.gameObject);
        }

        [Test]
        public void Points_AreSeen_WhereTheCameraShowsThem([Values] bool perspective)
        {
            m_Camera.orthographic = !perspective;
            CrowdView view = CameraView.Of(m_Camera, false);
            var random = new Random(3u);
            int seen = 0;
            for (int k = 0; k < 2000; k++)
            {
                Vector3 point = m_Camera.transform.TransformPoint(
                    random.NextFloat3(new float3(-25f, -15f, -10f), new float3(25f, 15f, 50f)));
                Vector3 shown = m_Camera.WorldToViewportPoint(point);
                bool inside = shown.x > 0f && shown.x < 1f && shown.y > 0f && shown.y < 1f && shown.z > 0.5f && shown.z < 40f;
                Assert.That(Sees(view, point, 1e-4f), Is.EqualTo(inside), $"{shown}");
                seen += inside ? 1 : 0;
            }

            Assert.That(seen, Is.InRange(100, 1900));
        }

        [Test]
        public void Spheres_AreSeen_UntilTheirRadiusIsBeyondASide([Values(-1f, 1f)] float side)
        {
            CrowdView view = CameraView.Of(m_Camera, false);
            float half = math.radians(25f), away = 10f;
            for (float radius = 0.1f; radius < 3f; radius *= 2f)
            {
                // On the upper or lower side of the picture, and farther by the radius at right angles to it.
                float3 At(float beyond) => m_Camera.transform.TransformPoint(
                    new Vector3(0f, side * (away * math.tan(half) + beyond * math.cos(half)), away - beyond * math.sin(half)));
                Assert.That(Sees(view, At(0.99f * radius), radius), Is.True);
                Assert.That(Sees(view, At(1.01f * radius), radius), Is.False);
            }
        }

        [Test]
        public void AnInsect_CountsByItsShadow_WhereTheSunThrowsItIntoThePicture()
        {
            Light sun = new GameObject("sun").AddComponent<Light>();
            sun.type = LightType.Directional;
            sun.shadows = LightShadows.Soft;
            sun.transform.rotation = Quaternion.LookRotation(Vector3.down);
            RenderSettings.sun = sun;
            m_Camera.transform.SetPositionAndRotation(Vector3.zero, Quaternion.identity);
            float3[] places = { new float3(0f, 30f, 10f), new float3(0f, -30f, 10f), new float3(0f, 30f, -10f) };
            try
            {
                CrowdView view = CameraView.Of(m_Camera, true);
                Assert.That(places.Select(place => Sees(view, place, 0.1f)), Is.EqualTo(new[] { true, false, false }), "above alone");
                Assert.That(Sees(CameraView.Of(m_Camera, false), places[0], 0.1f), Is.False, "insects without shadows");
                sun.transform.rotation = Quaternion.LookRotation(Vector3.up);
                view = CameraView.Of(m_Camera, true);
                Assert.That(places.Select(place => Sees(view, place, 0.1f)), Is.EqualTo(new[] { false, true, false }), "below alone");
            }
            finally
            {
                Object.DestroyImmediate(sun.gameObject);
            }
        }

        [Test]
        public void WithoutASunThatCastsShadows_AllWithinTheirDistanceCount()
        {
            m_Camera.transform.SetPositionAndRotation(Vector3.zero, Quaternion.identity);
            CrowdView view = CameraView.Of(m_Camera, true);
            float reach = QualitySettings.shadowDistance;
            Assert.That(Sees(view, new float3(0f, 0f, -0.99f * reach), 1e-4f), Is.True);
            Assert.That(Sees(view, new float3(0f, 0f, -1.01f * reach), 1e-4f), Is.False);
            Assert.That(Sees(CameraView.Of(m_Camera, false), new float3(0f, 0f, -0.1f), 1e-4f), Is.False);
        }

        [Test]
        public void AProbesCamera_SeesAllAroundIt()
        {
            m_Camera.cameraType = CameraType.Reflection;
            CrowdView view = CameraView.Of(m_Camera, false);
            foreach (Vector3 way in new[] { Vector3.back, Vector3.up, Vector3.left })
            {
                Assert.That(Sees(view, m_Camera.transform.position + 39f * way, 1e-4f), Is.True);
                Assert.That(Sees(view, m_Camera.transform.position + 41f * way, 1e-4f), Is.False);
            }
        }

        [Test]
        public void OfTwoEyes_OneIsEnough()
        {
            m_Camera.transform.SetPositionAndRotation(Vector3.zero, Quaternion.identity);
            Matrix4x4 narrow = Matrix4x4.Perspective(20f, 1f, 0.5f, 40f), look = m_Camera.worldToCameraMatrix;
            foreach (Camera.StereoscopicEye eye in new[] { Camera.StereoscopicEye.Left, Camera.StereoscopicEye.Right })
            {
                m_Camera.SetStereoProjectionMatrix(eye, narrow);
                float side = eye == Camera.StereoscopicEye.Left ? 3f : -3f;
                m_Camera.SetStereoViewMatrix(eye, Matrix4x4.Translate(new Vector3(side, 0f, 0f)) * look);
            }

            if (!m_Camera.stereoEnabled)
                Assert.Ignore("A camera takes eyes from a headset here.");
            CrowdView view = CameraView.Of(m_Camera, false);
            float[] places = { -3f, 3f, 0f, -6f };
            Assert.That(places.Select(x => Sees(view, new float3(x, 0f, 10f), 0.1f)), Is.EqualTo(new[] { true, true, false, false }));
        }

        [Test]
        public void Heights_AreSharesOfThePicture([Values] bool perspective)
        {
            m_Camera.orthographic = !perspective;
            m_Camera.orthographicSize = 4f;
            CrowdView view = CameraView.Of(m_Camera, false);
            Vector3 middle = m_Camera.transform.TransformPoint(new Vector3(0f, 0f, 12f)), top = middle + 0.3f * m_Camera.transform.up;
            float shown = m_Camera.WorldToViewportPoint(top).y - m_Camera.WorldToViewportPoint(middle).y;
            Assert.That(view.HeightOf(new float4(middle, 0.3f)), Is.EqualTo(2f * shown).Within(1e-4f));
        }

        private static bool Sees(in CrowdView view, float3 middle, float radius) => view.Sees(new float4(middle, radius));
    }
}
