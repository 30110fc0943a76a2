using System;
using System.Collections;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Showcase;

/// <summary>One state of mouse, fingers, keys and gamepad, read by either back end.</summary>
public sealed class PointerReaderTests : PlayFixture
{
    private Mouse m_Mouse;
    private Keyboard m_Keyboard;
    private Gamepad m_Gamepad;
    private Touchscreen m_Screen;

    [TearDown]
    public void RemoveDevices()
    {
        foreach (InputDevice device in new InputDevice[] { m_Mouse, m_Keyboard, m_Gamepad, m_Screen })
        {
            if (device != null)
                InputSystem.RemoveDevice(device);
        }

        (m_Mouse, m_Keyboard, m_Gamepad, m_Screen) = (null, null, null, null);
        Input.Fingers.Clear();
        for (int button = 0; button < 3; button++)
            Input.HoldMouse(button, false);
        Input.Push("Horizontal", 0f);
        Input.Push("Vertical", 0f);
        Input.Scroll(0f);
        Input.Release(KeyCode.LeftShift);
    }

    [UnityTest]
    public IEnumerator TheMouse_IsReadFromTheUpperLeftCorner([Values] bool bySystem, [Values(0, 1, 2)] int button)
    {
        Begin(bySystem);
        if (bySystem)
        {
            m_Mouse.position.Set(new Vector2(100f, 30f));
            new[] { m_Mouse.leftButton, m_Mouse.rightButton, m_Mouse.middleButton }[button].Set(1f);
            m_Mouse.scroll.Set(new Vector2(0f, -2f));
            m_Keyboard.leftShiftKey.Set(1f);
        }
        else
        {
            Input.MoveMouse(new Vector2(100f, 30f));
            Input.HoldMouse(button, true);
            Input.Scroll(-2f);
            Input.Press(KeyCode.LeftShift);
        }

        yield return null;
        PointerFrame now = PointerReader.Now;
        Assert.That((now.position.x, now.position.y), Is.EqualTo((100f, Screen.height - 30f)));
        Assert.That((now.isDown, now.isOtherDown), Is.EqualTo((button == 0, button > 0)));
        Assert.That((now.wheel, now.isShifted, now.fingers, now.digit), Is.EqualTo((-2f, true, 0, -1)));
    }

    [UnityTest]
    public IEnumerator TwoFingers_AreNoRightButton([Values] bool bySystem)
    {
        Begin(bySystem);
        if (bySystem)
        {
            m_Screen = InputSystem.AddDevice<Touchscreen>();
            m_Screen.touches[1].position.Set(new Vector2(10f, 20f));
            m_Screen.touches[1].press.Set(1f);
            m_Screen.touches[3].position.Set(new Vector2(40f, 60f));
            m_Screen.touches[3].press.Set(1f);
        }
        else
        {
            Input.Fingers.Add(new Touch { phase = TouchPhase.Ended });
            Input.Fingers.Add(new Touch { position = new Vector2(10f, 20f), phase = TouchPhase.Stationary });
            Input.Fingers.Add(new Touch { position = new Vector2(40f, 60f), phase = TouchPhase.Moved });
            Input.HoldMouse(1, true);
        }

        yield return null;
        PointerFrame now = PointerReader.Now;
        Assert.That((now.fingers, now.isDown, now.isOtherDown), Is.EqualTo((2, true, false)));
        Assert.That(now.Span, Is.EqualTo(50f).Within(1e-4f));
        Assert.That((now.Middle.x, now.Middle.y), Is.EqualTo((25f, Screen.height - 40f)));
    }

    [UnityTest]
    public IEnumerator OfThreeFingers_TheFirstTwoCount([Values] bool bySystem)
    {
        Begin(bySystem);
        m_Screen = bySystem ? InputSystem.AddDevice<Touchscreen>() : null;
        for (int finger = 0; finger < 3; finger++)
        {
            var place = new Vector2(10f + 30f * finger, 20f + 40f * finger * finger);
            if (bySystem)
            {
                m_Screen.touches[finger].position.Set(place);
                m_Screen.touches[finger].press.Set(1f);
            }
            else
            {
                Input.Fingers.Add(new Touch { position = place, phase = TouchPhase.Moved });
            }
        }

        yield return null;
        PointerFrame now = PointerReader.Now;
        Assert.That((now.fingers, now.position.x, now.second.x), Is.EqualTo((2, 10f, 40f)));
        Assert.That(now.Span, Is.EqualTo(50f).Within(1e-4f));
    }

    [UnityTest]
    public IEnumerator OneDeviceIsEnough([Values("mouse", "keyboard", "gamepad", "screen")] string device)
    {
        switch (device)
        {
            case "mouse":
                m_Mouse = InputSystem.AddDevice<Mouse>();
                m_Mouse.leftButton.Set(1f);
                break;
            case "keyboard":
                m_Keyboard = InputSystem.AddDevice<Keyboard>();
                m_Keyboard.leftArrowKey.Set(1f);
                m_Keyboard.downArrowKey.Set(1f);
                m_Keyboard.rightShiftKey.Set(1f);
                break;
            case "gamepad":
                m_Gamepad = InputSystem.AddDevice<Gamepad>();
                m_Gamepad.leftStick.Set(new Vector2(-0.5f, 0.5f));
                break;
            default:
                m_Screen = InputSystem.AddDevice<Touchscreen>();
                m_Screen.touches[0].press.Set(1f);
                break;
        }

        yield return null;
        PointerFrame now = PointerReader.Now;
        Assert.That((now.isDown, now.isOtherDown, now.isShifted, now.fingers, now.digit),
            Is.EqualTo((device is "mouse" or "screen", false, device == "keyboard", device == "screen" ? 1 : 0, -1)));
        Assert.That((now.stick.x, now.stick.y),
            Is.EqualTo(device == "keyboard" ? (-1f, -1f) : device == "gamepad" ? (-0.5f, 0.5f) : (0f, 0f)));
    }

    [UnityTest]
    public IEnumerator SticksAndKeys_Steer([Values] bool bySystem)
    {
        Begin(bySystem);
        if (bySystem)
        {
            m_Gamepad = InputSystem.AddDevice<Gamepad>();
            m_Gamepad.rightStick.Set(new Vector2(0.5f, -0.25f));
            m_Gamepad.rightTrigger.Set(0.75f);
            m_Gamepad.leftTrigger.Set(0.25f);
            m_Keyboard.upArrowKey.Set(1f);
        }
        else
        {
            Input.Push("Horizontal", 0.5f);
            Input.Push("Vertical", 0.75f);
        }

        yield return null;
        Assert.That((PointerReader.Now.stick.x, PointerReader.Now.stick.y), Is.EqualTo((0.5f, 0.75f)));
        Assert.That(PointerReader.Now.triggers, Is.EqualTo(bySystem ? 0.5f : 0f));
    }

    [UnityTest]
    public IEnumerator NumberKeys_AreTheirNumbers([Values] bool bySystem, [Values(0, 1, 5, 9)] int digit, [Values] bool onPad)
    {
        Begin(bySystem);
        yield return null;
        if (bySystem)
            m_Keyboard[onPad ? Key.Numpad0 + digit : Enum.Parse<Key>($"Digit{digit}")].Press();
        else
            Input.Press((onPad ? KeyCode.Keypad0 : KeyCode.Alpha0) + digit);
        yield return null;
        Assert.That(PointerReader.Now.digit, Is.EqualTo(digit));
        yield return null;
        Assert.That(PointerReader.Now.digit, Is.EqualTo(-1), "a key that is held goes down once");
        Input.Release((onPad ? KeyCode.Keypad0 : KeyCode.Alpha0) + digit);
    }

    // Behind 9 come other signs, which are no numbers.
    [UnityTest]
    public IEnumerator KeysBehindNine_AreNoNumbers([Values(KeyCode.Alpha0, KeyCode.Keypad0)] KeyCode nought)
    {
        KeyCode behind = nought + 10;
        Input.Press(behind);
        yield return null;
        Assert.That(Input.GetKeyDown(behind));
        Assert.That(PointerReader.Now.digit, Is.EqualTo(-1));
        Input.Release(behind);
    }

    [UnityTest]
    public IEnumerator AFingerThatWasLifted_HoldsNothing(
        [Values(TouchPhase.Ended, TouchPhase.Canceled, TouchPhase.Began)] TouchPhase phase)
    {
        Input.Fingers.Add(new Touch { position = new Vector2(10f, 20f), phase = phase });
        Input.HoldMouse(0, true);
        Input.HoldMouse(1, true);
        yield return null;
        PointerFrame now = PointerReader.Now;
        bool isDown = phase == TouchPhase.Began;
        Assert.That((now.fingers, now.isDown, now.isOtherDown), Is.EqualTo((isDown ? 1 : 0, isDown, false)));
    }

    [UnityTest]
    public IEnumerator EitherKey_Shifts([Values(KeyCode.LeftShift, KeyCode.RightShift, KeyCode.LeftAlt)] KeyCode key)
    {
        Input.Press(key);
        yield return null;
        Assert.That(PointerReader.Now.isShifted, Is.EqualTo(key != KeyCode.LeftAlt));
        Input.Release(key);
    }

    [UnityTest]
    public IEnumerator InAFrame_ThePointerIsReadOnce()
    {
        yield return null;
        Input.MoveMouse(new Vector2(1f, 2f));
        PointerFrame before = PointerReader.Now;
        Input.MoveMouse(new Vector2(3f, 4f));
        Assert.That(PointerReader.Now.position, Is.EqualTo(before.position));
        yield return null;
        Assert.That(PointerReader.Now.position.x, Is.EqualTo(3f));
    }

    [UnityTest]
    public IEnumerator ANotchOfTheWheel_IsOne_WhereThePackagePassesOnThatOfWindows([Values(120f, -240f)] float units)
    {
        Begin(true);
        m_Mouse.scroll.Set(new Vector2(0f, units));
        yield return null;
        Assert.That(PointerReader.Now.wheel, Is.EqualTo(units / 120f));
    }

    private void Begin(bool bySystem)
    {
        if (!bySystem)
            return;
        m_Mouse = InputSystem.AddDevice<Mouse>();
        m_Keyboard = InputSystem.AddDevice<Keyboard>();
    }
}
