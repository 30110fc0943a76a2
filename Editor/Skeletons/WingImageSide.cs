using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Where in the picture the leading edge lies.</summary>
    internal enum WingImageSide
    {
        /// <summary>Up; by the shape where the wing itself points up or down.</summary>
        Automatic,
        Up,
        Down,
        Left,
        Right,
    }

    /// <summary>Sides of a picture as directions.</summary>
    internal static class WingImageSides
    {
        /// <summary>With y down; null for <see cref="WingImageSide.Automatic"/>.</summary>
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
