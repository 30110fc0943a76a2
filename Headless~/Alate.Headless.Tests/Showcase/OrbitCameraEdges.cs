using System.Collections;
using System.Text.RegularExpressions;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>The camera at the ends of what it takes, and where it takes nothing.</summary>
public sealed class OrbitCameraEdges : PlayFixture
{
    [TearDown]
    public void LetGo()
    {
        for (int button = 0; button < 3; button++)
            Input.HoldMouse(button, false);
        Input.Fingers.Clear();
        Input.Scroll(0f);
        if (Gamepad.current != null)
            InputSystem.RemoveDevice(Gamepad.current);
    }

    // A three-quarter light, a little brighter than Unity's own sun; the ground is a little cooler than grey.
    [Test]
    public void ThePicture_HasAThreeQuarterLight_AndACoolGround()
    {
        OrbitCamera orbit = Made();
        Light light = orbit.GetComponentInChildren<Light>();
        Vector3 angles = light.transform.localEulerAngles;
        Assert.That(angles.x, Is.EqualTo(40f).Within(1f), "down");
        Assert.That(angles.y, Is.EqualTo(35f).Within(1f), "from the side");
        Assert.That(light.intensity, Is.InRange(1.05f, 1.2f));
        Color ground = orbit.GetComponent<Camera>().backgroundColor;
        Assert.That(ground.r < ground.g && ground.g < ground.b && ground.b - ground.r < 0.1f, $"{ground}");
    }

    // Prefabs have lights too, and what is off shines on nobody.
    [Test]
    public void ASunThatIsOff_IsNone([Values("component", "object", "parent")] string what)
    {
        GameObject sky = Keep(new GameObject("sky"));
        Light sun = new GameObject("sun").AddComponent<Light>();
        sun.transform.SetParent(sky.transform);
        sun.type = LightType.Directional;
        sun.enabled = what != "component";
        sun.gameObject.SetActive(what != "object");
        sky.SetActive(what != "parent");
        Assert.That(Made().GetComponentsInChildren<Light>(), Has.Length.EqualTo(1));
    }

    // The nose is ahead, along Z: seen from ahead of it, from its right and from above.
    [UnityTest]
    public IEnumerator ANewOne_LooksAtTheInsectFromAhead_FromTheSide_AndFromAbove()
    {
        OrbitCamera orbit = Keep(new GameObject("camera")).AddComponent<OrbitCamera>();
        yield return Frames(2);
        Assert.That((orbit.Yaw, orbit.Pitch, orbit.Distance, orbit.Target), Is.EqualTo((145f, 25f, 3f, Vector3.zero)));
        Vector3 eye = orbit.transform.position;
        Assert.That(eye.z > 0f && eye.y > 0f && eye.x * eye.z != 0f, $"{eye}");
        Assert.That(eye.magnitude, Is.EqualTo(3f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator TheNearPlane_IsAtAFiftiethOfTheDistance_ButNotBeyondUnitysOwn([Values(0.05f, 1f, 14f, 16f, 1000f)] float distance)
    {
        OrbitCamera orbit = Made();
        orbit.Distance = distance;
        yield return Frames(2);
        Assert.That(orbit.GetComponent<Camera>().nearClipPlane, Is.EqualTo(Mathf.Min(0.3f, distance / 50f)).Within(1e-4).Percent);
    }

    [UnityTest]
    public IEnumerator AYawOfAMillion_OrATargetOfTenMillion_IsTheLast([Values] bool byYaw, [Values(1f, -1f)] float sign)
    {
        OrbitCamera orbit = Made();
        yield return Frames(1);
        Move(0.99f);
        yield return Frames(1);
        LogAssert.NoUnexpectedReceived();
        Vector3 place = orbit.transform.position;
        LogAssert.Expect(LogType.Warning, new Regex("stays where it is"));
        Move(1.05f);
        yield return Frames(2);
        Assert.That(orbit.transform.position, Is.EqualTo(place));

        void Move(float share)
        {
            if (byYaw)
                orbit.Yaw = sign * share * 1e6f;
            else
                orbit.Target = new Vector3(0f, 0f, sign * share * 1e7f);
        }
    }

    [UnityTest]
    public IEnumerator ANotchOfTheWheel_IsThreeTwentiethsOfAnEFold()
    {
        OrbitCamera orbit = Made();
        yield return Frames(1);
        Input.MoveMouse(new Vector2(900f, 500f));
        Input.Scroll(1f);
        yield return Frames(1);
        Input.Scroll(0f);
        Assert.That(Mathf.Log(2f / orbit.Distance), Is.EqualTo(0.15f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator BeyondTheDeadZone_AStickAndATriggerAct()
    {
        OrbitCamera orbit = Made();
        yield return Frames(1);
        Gamepad gamepad = InputSystem.AddDevice<Gamepad>();
        gamepad.rightStick.Set(new Vector2(0.16f, 0f));
        gamepad.leftTrigger.Set(0.16f);
        float yaw = orbit.Yaw;
        yield return Frames(1);
        Assert.That(orbit.Yaw - yaw, Is.EqualTo(0.16f * 120f * Time.unscaledDeltaTime).Within(1e-4f));
        Assert.That(orbit.Distance, Is.EqualTo(2f * Mathf.Exp(1.5f * 0.16f * Time.unscaledDeltaTime)).Within(1e-5f));
    }

    // The button went down before it looked: what is dragged is somebody else's.
    [UnityTest]
    public IEnumerator AButtonThatIsHeldAlready_DragsNothing([Values(0, 1, 2)] int button)
    {
        OrbitCamera orbit = Made();
        orbit.enabled = false;
        yield return Frames(1);
        Input.MoveMouse(new Vector2(900f, 500f));
        Input.HoldMouse(button, true);
        yield return Frames(2);
        orbit.enabled = true;
        (float yaw, Vector3 target) = (orbit.Yaw, orbit.Target);
        Input.MoveMouse(new Vector2(950f, 500f));
        yield return Frames(1);
        Input.MoveMouse(new Vector2(990f, 500f));
        yield return Frames(2);
        Assert.That((orbit.Yaw, orbit.Target), Is.EqualTo((yaw, target)));
    }

    [UnityTest]
    public IEnumerator FingersInOnePlace_ChangeNoDistance()
    {
        OrbitCamera orbit = Made();
        yield return Pinch(100f);
        yield return Pinch(0f);
        Assert.That(orbit.Distance, Is.EqualTo(2f).Within(1e-5f));
    }

    [Test]
    public void Create_IsAsLargeAsTheWorld_WhateverItsParentIs()
    {
        GameObject stage = Keep(new GameObject("stage"));
        stage.transform.SetPositionAndRotation(new Vector3(5f, 6f, 7f), Quaternion.Euler(20f, 30f, 40f));
        stage.transform.localScale = 3f * Vector3.one;
        Camera main = Keep(new GameObject("main")).AddComponent<Camera>();
        main.tag = "MainCamera";
        main.depth = -4f;
        var orbit = OrbitCamera.Create(stage.transform, new Vector3(1f, 0f, 0f), 2f);
        Assert.That(orbit.transform.localScale, Is.EqualTo(Vector3.one), "of its own");
        Assert.That(Vector3.Distance(orbit.transform.position, orbit.Target), Is.EqualTo(2f).Within(1e-4f));
        Assert.That((orbit.GetComponent<Camera>().depth, orbit.tag), Is.EqualTo((-3f, "Untagged")));
    }

    private static IEnumerator Pinch(float span)
    {
        Input.Fingers.Clear();
        foreach (float side in new[] { -0.5f, 0.5f })
            Input.Fingers.Add(new Touch { position = new Vector2(960f + side * span, 540f), phase = TouchPhase.Moved });
        yield return Frames(1);
    }

    private OrbitCamera Made() => OrbitCamera.Create(Keep(new GameObject("stage")).transform, Vector3.zero, 2f);
}
