namespace UnityEditor;

public enum PivotMode
{
    Center = 0,
    Pivot = 1,
}
