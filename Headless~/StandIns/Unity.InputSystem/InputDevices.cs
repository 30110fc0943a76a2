using System.Collections.Generic;
using UnityEngine.InputSystem.Controls;
using UnityEngine.InputSystem.Utilities;

namespace UnityEngine.InputSystem;

public abstract class InputDevice : InputControl
{
    internal abstract void MakeCurrent(bool isCurrent);
}

public abstract class Pointer : InputDevice
{
    public Vector2Control position { get; } = new();
}

public class Mouse : Pointer
{
    public static Mouse current { get; private set; }
    public ButtonControl leftButton { get; } = new();
    public ButtonControl rightButton { get; } = new();
    public ButtonControl middleButton { get; } = new();
    public DeltaControl scroll { get; } = new();

    internal override void MakeCurrent(bool isCurrent) => current = isCurrent ? this : null;
}

public class Touchscreen : Pointer
{
    private readonly TouchControl[] _touches = [new(), new(), new(), new(), new(), new(), new(), new(), new(), new()];

    public static Touchscreen current { get; private set; }
    public ReadOnlyArray<TouchControl> touches => new(_touches);

    internal override void MakeCurrent(bool isCurrent) => current = isCurrent ? this : null;
}

public class Keyboard : InputDevice
{
    private readonly Dictionary<Key, KeyControl> _keys = [];

    public static Keyboard current { get; private set; }
    public KeyControl leftShiftKey => this[Key.LeftShift];
    public KeyControl rightShiftKey => this[Key.RightShift];
    public KeyControl leftArrowKey => this[Key.LeftArrow];
    public KeyControl rightArrowKey => this[Key.RightArrow];
    public KeyControl upArrowKey => this[Key.UpArrow];
    public KeyControl downArrowKey => this[Key.DownArrow];

    public KeyControl this[Key key]
    {
        get
        {
            if (!_keys.TryGetValue(key, out KeyControl control))
                _keys[key] = control = new KeyControl();
            return control;
        }
    }

    internal override void MakeCurrent(bool isCurrent) => current = isCurrent ? this : null;
}

public class Gamepad : InputDevice
{
    public static Gamepad current { get; private set; }
    public StickControl leftStick { get; } = new();
    public StickControl rightStick { get; } = new();
    public ButtonControl leftTrigger { get; } = new();
    public ButtonControl rightTrigger { get; } = new();

    internal override void MakeCurrent(bool isCurrent) => current = isCurrent ? this : null;
}

/// <summary>Numbers as the package has them: 1 to 9 lie before 0.</summary>
public enum Key
{
    None = 0,
    Digit1 = 41,
    Digit2,
    Digit3,
    Digit4,
    Digit5,
    Digit6,
    Digit7,
    Digit8,
    Digit9,
    Digit0,
    LeftShift = 51,
    RightShift = 52,
    LeftArrow = 61,
    RightArrow = 62,
    UpArrow = 63,
    DownArrow = 64,
    Numpad0 = 84,
    Numpad1,
    Numpad2,
    Numpad3,
    Numpad4,
    Numpad5,
    Numpad6,
    Numpad7,
    Numpad8,
    Numpad9,
}

public static class InputSystem
{
    public static TDevice AddDevice<TDevice>(string name = null) where TDevice : InputDevice
    {
        TDevice device = System.Activator.CreateInstance<TDevice>();
        device.MakeCurrent(true);
        return device;
    }

    public static void RemoveDevice(InputDevice device) => device.MakeCurrent(false);
}
