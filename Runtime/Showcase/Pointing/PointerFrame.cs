using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>State of mouse, fingers, gamepad and number keys in one frame, whichever input back end read it.</summary>
    internal struct PointerFrame
    {
        /// <summary>Place of the mouse or the first finger, pixels from the upper left corner.</summary>
        public Vector2 position;

        /// <summary>Place of the second finger, pixels from the upper left corner.</summary>
        public Vector2 second;

        /// <summary>Number of fingers on the screen; 0 for a mouse.</summary>
        public int fingers;

        /// <summary>True while the left button or a finger is down.</summary>
        public bool isDown;

        /// <summary>True while the right or the middle button is down.</summary>
        public bool isOtherDown;

        /// <summary>True while a Shift key is down.</summary>
        public bool isShifted;

        /// <summary>Notches that the wheel was turned, away from the user positive.</summary>
        public float wheel;

        /// <summary>Gamepad's stick or arrow keys, −1 to 1: to the right and up.</summary>
        public Vector2 stick;

        /// <summary>Gamepad's triggers: right minus left, −1 to 1.</summary>
        public float triggers;

        /// <summary>Number key that went down, 0 to 9; −1 for none.</summary>
        public int digit;

        /// <summary>Distance between two fingers, pixels.</summary>
        public float Span => Vector2.Distance(position, second);

        /// <summary>Middle of two fingers, or the place of the only one, pixels from the upper left corner.</summary>
        public Vector2 Middle => fingers >= 2 ? 0.5f * (position + second) : position;
    }
}
