using System.Collections;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>The camera by fingers and gamepad.</summary>
public sealed class OrbitCameraSteering : PlayFixture
{
    [TearDown]
    public void LetGo()
    {
        Input.Fingers.Clear();
        if (Gamepad.current != null)
            InputSystem.RemoveDevice(Gamepad.current);
    }

    [UnityTest]
    public IEnumerator FingersThatPart_BringTheInsectNearer_ByTheRatioOfTheirDistances()
    {
        OrbitCamera orbit = Made();
        yield return Pinch(100f);
        float distance = orbit.Distance;
        yield return Pinch(250f);
        Assert.That(orbit.Distance, Is.EqualTo(distance / 2.5f).Within(1e-4f));
        yield return Pinch(100f);
        Assert.That(orbit.Distance, Is.EqualTo(distance).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator TwoFingers_MoveWhatIsBetweenThem_AndOneTurns()
    {
        OrbitCamera orbit = Made();
        float yaw = orbit.Yaw;
        yield return Pinch(100f);
        yield return Frames(1);
        Camera camera = orbit.GetComponent<Camera>();
        Vector3 before = camera.WorldToScreenPoint(Vector3.zero);
        yield return Pinch(100f, 80f);
        yield return Frames(1);
        Vector3 after = camera.WorldToScreenPoint(Vector3.zero);
        Assert.That(after.x - before.x, Is.EqualTo(80f).Within(0.5f));
        Assert.That(orbit.Yaw, Is.EqualTo(yaw));

        Input.Fingers.RemoveAt(1);
        yield return Frames(1);
        Assert.That(orbit.Yaw, Is.EqualTo(yaw), "a finger that is lifted is no movement of the other");
        Input.Fingers[0] = new Touch { position = Input.Fingers[0].position + new Vector2(50f, 0f), phase = TouchPhase.Moved };
        yield return Frames(1);
        Assert.That(orbit.Yaw - yaw, Is.EqualTo(15f).Within(1e-3f));
    }

    [UnityTest]
    public IEnumerator AStick_TurnsByItsTime_AndRestsInItsDeadZone()
    {
        OrbitCamera orbit = Made();
        yield return Frames(1);
        Gamepad gamepad = InputSystem.AddDevice<Gamepad>();
        gamepad.rightStick.Set(new Vector2(0.1f, 0f));
        yield return Frames(5);
        Assert.That(orbit.Yaw, Is.EqualTo(145f));
        gamepad.rightStick.Set(new Vector2(-1f, 0f));
        float seconds = 0f;
        for (int frame = 0; frame < 10; frame++)
        {
            yield return null;
            seconds += Time.unscaledDeltaTime;
        }

        Assert.That(orbit.Yaw - 145f, Is.EqualTo(-120f * seconds).Within(1e-3f));
        gamepad.rightStick.Set(Vector2.zero);
        gamepad.leftTrigger.Set(1f);
        float distance = orbit.Distance;
        seconds = 0f;
        for (int frame = 0; frame < 10; frame++)
        {
            yield return null;
            seconds += Time.unscaledDeltaTime;
        }

        Assert.That(orbit.Distance, Is.EqualTo(distance * Mathf.Exp(1.5f * seconds)).Within(1e-4f));
    }

    private OrbitCamera Made() => OrbitCamera.Create(Keep(new GameObject("stage")).transform, Vector3.zero, 2f);

    private IEnumerator Pinch(float span, float right = 0f)
    {
        Input.Fingers.Clear();
        foreach (float side in new[] { -0.5f, 0.5f })
        {
            Input.Fingers.Add(new Touch
            {
                position = new Vector2(960f + right + side * span, 540f),
                phase = TouchPhase.Moved,
            });
        }

        yield return Frames(1);
    }
}
