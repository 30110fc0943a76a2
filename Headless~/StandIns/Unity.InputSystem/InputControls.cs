using Unity.StandIns;

namespace UnityEngine.InputSystem
{
    public abstract class InputControl
    {
    }

    public abstract class InputControl<TValue> : InputControl where TValue : struct
    {
        private TValue _value;

        public TValue ReadValue() => _value;

        /// <summary>Moves the control.</summary>
        [StandInExtension]
        public void Set(TValue value) => _value = value;
    }
}

namespace UnityEngine.InputSystem.Utilities
{
    public readonly struct ReadOnlyArray<TValue>(TValue[] array)
    {
        public int Count => array.Length;
        public TValue this[int index] => array[index];
    }
}

namespace UnityEngine.InputSystem.Controls
{
    public class AxisControl : InputControl<float>
    {
    }

    public class ButtonControl : AxisControl
    {
        private int _frame = -1;

        public bool isPressed => ReadValue() >= 0.5f;
        public bool wasPressedThisFrame => isPressed && _frame == Time.frameCount;

        /// <summary>Presses the button; the next frame sees it go down.</summary>
        [StandInExtension]
        public void Press()
        {
            Set(1f);
            _frame = Time.frameCount + 1;
        }
    }

    public class KeyControl : ButtonControl
    {
    }

    public class Vector2Control : InputControl<Vector2>
    {
    }

    public class DeltaControl : Vector2Control
    {
    }

    public class StickControl : Vector2Control
    {
    }

    public class TouchPressControl : ButtonControl
    {
    }

    public class TouchControl : InputControl
    {
        public TouchPressControl press { get; } = new();
        public Vector2Control position { get; } = new();
    }
}
