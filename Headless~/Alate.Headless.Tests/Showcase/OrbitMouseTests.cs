using System.Collections;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>Effects of the mouse on a camera that turns about a point.</summary>
public sealed class OrbitMouseTests : PlayFixture
{
    private OrbitCamera m_Orbit;
    private Camera m_Camera;

    [UnityTest]
    public IEnumerator APannedPoint_GoesWithTheMouse_PixelByPixel([Values(0, 1, 2)] int button)
    {
        Make();
        Vector3 before = m_Orbit.Target, seen = m_Camera.WorldToScreenPoint(before);
        yield return Drag(new Vector2(30f, -20f), button, shift: button == 0);

        Vector3 now = m_Camera.WorldToScreenPoint(before);
        Assert.That(now.x - seen.x, Is.EqualTo(30f).Within(0.1f));
        Assert.That(now.y - seen.y, Is.EqualTo(-20f).Within(0.1f));
        Assert.That(now.z, Is.EqualTo(5f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator ATurn_IsAsFarAsTheMouseGoes_AboutThePoint()
    {
        Make();
        float yaw = m_Orbit.Yaw, pitch = m_Orbit.Pitch;
        yield return Drag(new Vector2(40f, 0f));
        yield return Drag(new Vector2(-10f, -20f));

        Assert.That(m_Orbit.Yaw - yaw, Is.EqualTo(0.3f * 30f).Within(1e-3f));
        Assert.That(m_Orbit.Pitch - pitch, Is.EqualTo(0.3f * 20f).Within(1e-3f), "down, as the mouse");
        Assert.That((m_Camera.WorldToScreenPoint(m_Orbit.Target) - new Vector3(Screen.width / 2f, Screen.height / 2f, 5f)).magnitude,
            Is.LessThan(0.1f));
        yield return Drag(new Vector2(0f, -1e4f));
        Assert.That(m_Orbit.Pitch, Is.EqualTo(89f));
    }

    [UnityTest]
    public IEnumerator Zooming_IsByAFactor_AndBackIsBack_WithANearPlaneThatDoesNotCut()
    {
        Make();
        yield return Scroll(-1f);
        float factor = m_Orbit.Distance / 5f;
        Assert.That(factor, Is.GreaterThan(1.02f), "away");
        yield return Scroll(-1f);
        Assert.That(m_Orbit.Distance, Is.EqualTo(5f * factor * factor).Within(1e-4f));
        yield return Scroll(2f);
        Assert.That(m_Orbit.Distance, Is.EqualTo(5f).Within(1e-4f));
        foreach (float distance in new[] { 0.05f, 0.4f, 1000f })
        {
            m_Orbit.Distance = distance;
            yield return Frames(1);
            Assert.That(m_Camera.nearClipPlane, Is.GreaterThan(0f).And.LessThan(0.5f * distance).And.LessThanOrEqualTo(0.3f));
            Assert.That((m_Camera.transform.position - m_Orbit.Target).magnitude, Is.EqualTo(distance).Within(1e-3).Percent);
        }
    }

    private void Make()
    {
        m_Orbit = OrbitCamera.Create(Keep(new GameObject("stage")).transform, new Vector3(1f, 2f, 3f), 5f);
        m_Camera = m_Orbit.GetComponent<Camera>();
    }

    // From below, as Input counts.
    private IEnumerator Drag(Vector2 way, int button = 0, bool shift = false)
    {
        var from = new Vector2(960f, 540f);
        if (shift)
            Input.Press(KeyCode.LeftShift);
        Input.MoveMouse(from);
        Input.HoldMouse(button, true);
        yield return Frames(1);
        Input.MoveMouse(from + way);
        yield return Frames(1);
        Input.HoldMouse(button, false);
        Input.Release(KeyCode.LeftShift);
        yield return Frames(1);
    }

    private IEnumerator Scroll(float notches)
    {
        Input.Scroll(notches);
        yield return Frames(1);
        Input.Scroll(0f);
        yield return Frames(1);
    }
}
