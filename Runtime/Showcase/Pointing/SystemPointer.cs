#if ALATE_INPUT_SYSTEM && ENABLE_INPUT_SYSTEM
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.Controls;

namespace Alate.Showcase
{
    /// <summary>Reads the pointer by the Input System package.</summary>
    internal static class SystemPointer
    {
        /// <summary>Units of the wheel a notch where the package passes on those of Windows.</summary>
        private const float k_WindowsNotch = 120f;

        /// <summary>True where the package has a device to read.</summary>
        public static bool HasDevice =>
            Mouse.current != null || Touchscreen.current != null || Keyboard.current != null || Gamepad.current != null;

        public static PointerFrame Read()
        {
            var frame = new PointerFrame { digit = -1 };
            if (Mouse.current != null)
                ReadMouse(Mouse.current, ref frame);
            if (Keyboard.current != null)
                ReadKeys(Keyboard.current, ref frame);
            if (Gamepad.current != null)
                ReadGamepad(Gamepad.current, ref frame);
            if (Touchscreen.current != null)
                ReadFingers(Touchscreen.current, ref frame);
            return frame;
        }

        private static void ReadMouse(Mouse mouse, ref PointerFrame frame)
        {
            frame.position = FromAbove(mouse.position.ReadValue());
            frame.isDown = mouse.leftButton.isPressed;
            frame.isOtherDown = mouse.rightButton.isPressed || mouse.middleButton.isPressed;
            float wheel = mouse.scroll.ReadValue().y;
            frame.wheel = Mathf.Abs(wheel) >= k_WindowsNotch ? wheel / k_WindowsNotch : wheel;
        }

        private static void ReadKeys(Keyboard keyboard, ref PointerFrame frame)
        {
            frame.isShifted = keyboard.leftShiftKey.isPressed || keyboard.rightShiftKey.isPressed;
            frame.stick += new Vector2(
                Axis(keyboard.leftArrowKey, keyboard.rightArrowKey), Axis(keyboard.downArrowKey, keyboard.upArrowKey));
            for (int digit = 0; digit < 10; digit++)
            {
                // Key counts from 1 to 9, and 0 comes last.
                if (keyboard[digit == 0 ? Key.Digit0 : Key.Digit1 + (digit - 1)].wasPressedThisFrame
                    || keyboard[Key.Numpad0 + digit].wasPressedThisFrame)
                {
                    frame.digit = digit;
                }
            }
        }

        private static void ReadGamepad(Gamepad gamepad, ref PointerFrame frame)
        {
            frame.stick += gamepad.rightStick.ReadValue() + gamepad.leftStick.ReadValue();
            frame.triggers = gamepad.rightTrigger.ReadValue() - gamepad.leftTrigger.ReadValue();
        }

        private static void ReadFingers(Touchscreen screen, ref PointerFrame frame)
        {
            for (int k = 0; k < screen.touches.Count && frame.fingers < 2; k++)
            {
                TouchControl touch = screen.touches[k];
                if (!touch.press.isPressed)
                    continue;
                if (frame.fingers++ == 0)
                    frame.position = FromAbove(touch.position.ReadValue());
                else
                    frame.second = FromAbove(touch.position.ReadValue());
                frame.isDown = true;
            }
        }

        private static float Axis(KeyControl less, KeyControl more) => (more.isPressed ? 1f : 0f) - (less.isPressed ? 1f : 0f);

        private static Vector2 FromAbove(Vector2 place) => new Vector2(place.x, Screen.height - place.y);
    }
}
#endif
