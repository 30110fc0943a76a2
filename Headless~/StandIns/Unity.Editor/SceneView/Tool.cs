namespace UnityEditor;

public enum Tool
{
    None = -1,
    View = 0,
    Move = 1,
    Rotate = 2,
    Scale = 3,
    Rect = 4,
    Transform = 5,
    Custom = 6,
}
