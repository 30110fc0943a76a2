using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Side of the picture on which the leading edge lies.</summary>
    internal enum WingImageSide
    {
        /// <summary>Upper side; guessed by the shape where the wing itself points up or down.</summary>
        Automatic,
        Up,
        Down,
        Left,
        Right,
    }

    /// <summary>Converts sides of a picture to directions.</summary>
    internal static class WingImageSides
    {
        /// <summary>Direction with y down; null for <see cref="WingImageSide.Automatic"/>.</summary>
        public static Vector2? ToDirection(this WingImageSide side)
        {
            switch (side)
            {
                case WingImageSide.Up:
                    return new Vector2(0f, -1f);
                case WingImageSide.Down:
                    return new Vector2(0f, 1f);
                case WingImageSide.Left:
                    return new Vector2(-1f, 0f);
                case WingImageSide.Right:
                    return new Vector2(1f, 0f);
                default:
                    return null;
            }
        }
    }
}
