using UnityEngine;

namespace UnityEditor;

public sealed class Tools : ScriptableObject
{
    public static Tool current { get; set; }
    public static PivotMode pivotMode { get; set; }
    public static PivotRotation pivotRotation { get; set; }
    public static Vector3 handlePosition { get; }
    public static Quaternion handleRotation { get; set; }
    public static bool viewToolActive { get; }
    public static bool hidden { get; set; }
}
