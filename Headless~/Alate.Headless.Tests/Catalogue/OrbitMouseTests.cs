using System;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Catalogue
{
    /// <summary>Effects of the mouse on a camera that turns about a point.</summary>
    public sealed class OrbitMouseTests
    {
        private GameObject m_Stage;
        private OrbitCamera m_Orbit;
        private Camera m_Camera;

        [SetUp]
        public void Make()
        {
            m_Stage = new GameObject("stage");
            m_Orbit = OrbitCamera.Create(m_Stage.transform, new Vector3(1f, 2f, 3f), 5f);
            m_Camera = m_Orbit.GetComponent<Camera>();
        }

        [TearDown]
        public void Clear()
        {
            Event.current = null;
            GUIUtility.hotControl = 0;
            Object.DestroyImmediate(m_Stage);
        }

        [TestCase(1, false)]
        [TestCase(0, true)]
        public void APannedPoint_GoesWithTheMouse_PixelByPixel(int button, bool shift)
        {
            Vector3 before = m_Orbit.Target, seen = m_Camera.WorldToScreenPoint(before);
            Drag(new Vector2(30f, -20f), button, shift);

            Vector3 now = m_Camera.WorldToScreenPoint(before);
            Assert.That((now.x - seen.x, now.y - seen.y), Is.EqualTo((30f, 20f)).Using<(float, float)>(
                (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 0.1f), "the mouse counts down");
            Assert.That(now.z, Is.EqualTo(5f).Within(1e-4f));
        }

        [Test]
        public void ATurn_IsAsFarAsTheMouseGoes_AboutThePoint()
        {
            float yaw = m_Orbit.Yaw, pitch = m_Orbit.Pitch;
            Drag(new Vector2(40f, 0f));
            float perPixel = (m_Orbit.Yaw - yaw) / 40f;
            Drag(new Vector2(-10f, 20f));

            Assert.That(perPixel, Is.InRange(0.1f, 1f), "degrees");
            Assert.That((m_Orbit.Yaw - yaw, m_Orbit.Pitch - pitch), Is.EqualTo((30f * perPixel, 20f * perPixel)).Using<(float, float)>(
                (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-3f));
            Assert.That((m_Camera.WorldToScreenPoint(m_Orbit.Target) - new Vector3(Screen.width / 2f, Screen.height / 2f, 5f)).magnitude,
                Is.LessThan(0.1f));
            Drag(new Vector2(0f, 1e4f));
            Assert.That(m_Orbit.Pitch, Is.EqualTo(89f));
        }

        [Test]
        public void AControlThatHoldsTheMouse_KeepsTheCameraStill()
        {
            (float Yaw, Vector3 Target) before = (m_Orbit.Yaw, m_Orbit.Target);
            GUIUtility.hotControl = 7;
            Drag(new Vector2(40f, 3f));
            Drag(new Vector2(40f, 3f), 1);
            Assert.That((m_Orbit.Yaw, m_Orbit.Target), Is.EqualTo(before));
        }

        [Test]
        public void Zooming_IsByAFactor_AndBackIsBack_WithANearPlaneThatDoesNotCut()
        {
            Scroll(3f);
            float factor = m_Orbit.Distance / 5f;
            Assert.That(factor, Is.GreaterThan(1.02f), "away");
            Scroll(3f);
            Assert.That(m_Orbit.Distance, Is.EqualTo(5f * factor * factor).Within(1e-4f));
            Scroll(-6f);
            Assert.That(m_Orbit.Distance, Is.EqualTo(5f).Within(1e-4f));
            foreach (float distance in new[] { 0.05f, 0.4f, 1000f })
            {
                m_Orbit.Distance = distance;
                Call("LateUpdate");
                Assert.That(m_Camera.nearClipPlane, Is.GreaterThan(0f).And.LessThan(0.5f * distance).And.LessThanOrEqualTo(0.3f));
                Assert.That((m_Camera.transform.position - m_Orbit.Target).magnitude, Is.EqualTo(distance).Within(1e-3).Percent);
            }
        }

        private void Drag(Vector2 delta, int button = 0, bool shift = false) => Happens(
            new Event { type = EventType.MouseDrag, delta = delta, button = button, modifiers = shift ? EventModifiers.Shift : default });

        private void Scroll(float lines) => Happens(new Event { type = EventType.ScrollWheel, delta = new Vector2(0f, lines) });

        private void Happens(Event what)
        {
            Event.current = what;
            Call("OnGUI");
            Call("LateUpdate");
        }

        private void Call(string message) => typeof(OrbitCamera)
            .GetMethod(message, System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic).Invoke(m_Orbit, null);
    }
}
