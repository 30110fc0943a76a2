namespace UnityEditor;

public enum PivotRotation
{
    Local = 0,
    Global = 1,
}
