namespace UnityEditor;

public enum MouseCursor
{
    Arrow = 0,
    Text = 1,
    ResizeVertical = 2,
    ResizeHorizontal = 3,
    Link = 4,
    SlideArrow = 5,
    ResizeUpRight = 6,
    ResizeUpLeft = 7,
    MoveArrow = 8,
    RotateArrow = 9,
    ScaleArrow = 10,
    ArrowPlus = 11,
    ArrowMinus = 12,
    Pan = 13,
    Orbit = 14,
    Zoom = 15,
    FPS = 16,
    CustomCursor = 17,
    SplitResizeUpDown = 18,
    SplitResizeLeftRight = 19,
}
