#if ENABLE_LEGACY_INPUT_MANAGER
using System;
using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>Reads the pointer by the Input Manager.</summary>
    internal static class LegacyPointer
    {
        public static PointerFrame Read()
        {
            var frame = new PointerFrame
            {
                position = FromAbove(Input.mousePosition),
                isDown = Input.GetMouseButton(0),
                isOtherDown = Input.GetMouseButton(1) || Input.GetMouseButton(2),
                isShifted = Input.GetKey(KeyCode.LeftShift) || Input.GetKey(KeyCode.RightShift),
                wheel = Input.mouseScrollDelta.y,
                stick = new Vector2(Axis("Horizontal"), Axis("Vertical")),
                digit = Digit(),
            };
            ReadFingers(ref frame);
            return frame;
        }

        // Unity lets fingers press the mouse's buttons as well, two of them the right one.
        private static void ReadFingers(ref PointerFrame frame)
        {
            if (Input.touchCount == 0)
                return;
            frame.isDown = frame.isOtherDown = false;
            for (int k = 0; k < Input.touchCount && frame.fingers < 2; k++)
            {
                Touch touch = Input.GetTouch(k);
                if (touch.phase == TouchPhase.Ended || touch.phase == TouchPhase.Canceled)
                    continue;
                if (frame.fingers++ == 0)
                    frame.position = FromAbove(touch.position);
                else
                    frame.second = FromAbove(touch.position);
                frame.isDown = true;
            }
        }

        private static Vector2 FromAbove(Vector2 place) => new Vector2(place.x, Screen.height - place.y);

        // A project may have removed the axes that Unity gives to a new one.
        private static float Axis(string name)
        {
            try
            {
                return Input.GetAxisRaw(name);
            }
            catch (ArgumentException)
            {
                return 0f;
            }
        }

        private static int Digit()
        {
            for (int digit = 0; digit < 10; digit++)
            {
                if (Input.GetKeyDown(KeyCode.Alpha0 + digit) || Input.GetKeyDown(KeyCode.Keypad0 + digit))
                    return digit;
            }

            return -1;
        }
    }
}
#endif
