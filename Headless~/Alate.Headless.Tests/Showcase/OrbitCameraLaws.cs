using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>Picture of a made camera, its ranges, and its sticks along both axes.</summary>
public sealed class OrbitCameraLaws : PlayFixture
{
    [TearDown]
    public void LetGo()
    {
        if (Gamepad.current != null)
            InputSystem.RemoveDevice(Gamepad.current);
    }

    // Insects are dark or bright, so the ground behind them is between, and of hardly any colour.
    [Test]
    public void TheBackground_IsAPlainLightGrey()
    {
        Camera camera = Made().GetComponent<Camera>();
        Color ground = camera.backgroundColor;
        Assert.That(camera.clearFlags, Is.EqualTo(CameraClearFlags.SolidColor));
        Assert.That(ground.a, Is.EqualTo(1f));
        float[] channels = [ground.r, ground.g, ground.b];
        Assert.That(channels, Is.All.InRange(0.5f, 0.8f));
        Assert.That(channels.Max() - channels.Min(), Is.LessThan(0.15f));
    }

    [UnityTest]
    public IEnumerator TheLight_ShinesFromAboveTheCamera_OnWhatItSees()
    {
        OrbitCamera orbit = Made();
        orbit.Pitch = 0f;
        yield return Frames(1);
        Light light = orbit.GetComponentInChildren<Light>();
        Assert.That(light.type, Is.EqualTo(LightType.Directional));
        Vector3 way = orbit.transform.InverseTransformDirection(light.transform.forward);
        Assert.That(way.z, Is.GreaterThan(0.3f), "along the view");
        Assert.That(way.y, Is.LessThan(-0.3f), "down");
        Assert.That(Mathf.Abs(way.x), Is.GreaterThan(0.1f), "from one side, so that it has shades");
    }

    [Test]
    public void Numbers_StayInTheRangesThatTheirPropertiesTell()
    {
        OrbitCamera orbit = Made();
        (orbit.Pitch, orbit.Distance) = (-100f, 0f);
        Assert.That((orbit.Pitch, orbit.Distance), Is.EqualTo((-89f, 0.05f)));
        (orbit.Pitch, orbit.Distance) = (100f, 5000f);
        Assert.That((orbit.Pitch, orbit.Distance), Is.EqualTo((89f, 1000f)));
        (orbit.Pitch, orbit.Distance) = (-88f, 999f);
        Assert.That((orbit.Pitch, orbit.Distance), Is.EqualTo((-88f, 999f)));
        OrbitCamera other = Keep(new GameObject("other")).AddComponent<OrbitCamera>();
        (float pitch, float distance) = (other.Pitch, other.Distance);
        (orbit.Pitch, orbit.Distance) = (float.NaN, float.NaN);
        Assert.That((orbit.Pitch, orbit.Distance), Is.EqualTo((pitch, distance)), "what is no number is that of a new one");
    }

    [UnityTest]
    public IEnumerator WhatIsNoView_IsToldOnce_AndTheCameraStays([Values] bool byYaw)
    {
        OrbitCamera orbit = Made();
        yield return Frames(1);
        Vector3 place = orbit.transform.position;
        LogAssert.Expect(LogType.Warning, new Regex("'Orbit Camera' stays where it is"));
        if (byYaw)
            orbit.Yaw = 2e6f;
        else
            orbit.Target = new Vector3(0f, float.NaN, 0f);
        yield return Frames(3);
        LogAssert.NoUnexpectedReceived();
        Assert.That(orbit.transform.position, Is.EqualTo(place));
        (orbit.Yaw, orbit.Target) = (145f, new Vector3(1f, 0f, 0f));
        yield return Frames(1);
        Assert.That(orbit.transform.position, Is.Not.EqualTo(place), "it goes on");
    }

    [UnityTest]
    public IEnumerator Sticks_TurnAlongBothAxes_TogetherNoFasterThanOne()
    {
        OrbitCamera orbit = Made();
        orbit.Pitch = 0f;
        yield return Frames(1);
        Gamepad gamepad = InputSystem.AddDevice<Gamepad>();
        gamepad.rightStick.Set(new Vector2(0.6f, 0.8f));
        gamepad.leftStick.Set(new Vector2(0.6f, 0.8f));
        (float yaw, float pitch) = (orbit.Yaw, orbit.Pitch);
        yield return Frames(1);
        float seconds = Time.unscaledDeltaTime;
        Assert.That(orbit.Yaw - yaw, Is.EqualTo(0.6f * 120f * seconds).Within(1e-3f));
        Assert.That(orbit.Pitch - pitch, Is.EqualTo(0.8f * 120f * seconds).Within(1e-3f));
    }

    [UnityTest]
    public IEnumerator Triggers_BringItNearer_AndRestInTheirDeadZone()
    {
        OrbitCamera orbit = Made();
        yield return Frames(1);
        Gamepad gamepad = InputSystem.AddDevice<Gamepad>();
        gamepad.rightTrigger.Set(0.14f);
        yield return Frames(3);
        Assert.That(orbit.Distance, Is.EqualTo(2f));
        gamepad.rightTrigger.Set(0.5f);
        yield return Frames(1);
        Assert.That(orbit.Distance, Is.EqualTo(2f * Mathf.Exp(-1.5f * 0.5f * Time.unscaledDeltaTime)).Within(1e-5f));
    }

    [Test]
    public void Create_GoesWithItsParent_AndIsAtItsPlaceAtOnce()
    {
        GameObject stage = Keep(new GameObject("stage"));
        var target = new Vector3(3f, -1f, 7f);
        var orbit = OrbitCamera.Create(stage.transform, target, 6f);
        Assert.That(orbit.transform.parent, Is.SameAs(stage.transform));
        Assert.That((orbit.transform.position - target).magnitude, Is.EqualTo(6f).Within(1e-4f));
        Assert.That(orbit.Target, Is.EqualTo(target));
        Assert.That(Vector3.Dot(orbit.transform.forward, (target - orbit.transform.position).normalized), Is.EqualTo(1f).Within(1e-5f));
    }

    private OrbitCamera Made() => OrbitCamera.Create(Keep(new GameObject("stage")).transform, Vector3.zero, 2f);
}
