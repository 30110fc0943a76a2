using StandIns;
using UnityEngine;

namespace UnityEditor;

public sealed class HandleUtility
{
    public static int nearestControl { get; set; }

    public static float GetHandleSize(Vector3 position) => SceneEye.HandleSize?.Invoke(position) ?? 1f;
    public static float DistanceToLine(Vector3 p1, Vector3 p2) => throw Absent.Editor;
    public static float DistanceToCircle(Vector3 position, float radius) => throw Absent.Editor;
    public static float DistanceToPolyLine(params Vector3[] points) => throw Absent.Editor;
    public static float DistancePointLine(Vector3 point, Vector3 lineStart, Vector3 lineEnd) => throw Absent.Editor;
    public static void AddControl(int controlId, float distance) => throw Absent.Editor;
    public static void AddDefaultControl(int controlId) => nearestControl = controlId;
    public static Vector2 WorldToGUIPoint(Vector3 world) => throw Absent.Editor;
    public static Ray GUIPointToWorldRay(Vector2 position) => SceneEye.Needed.Through(position);
    public static Vector3 WorldToGUIPointWithDepth(Vector3 world) => SceneEye.Needed.Project(world);
    public static GameObject PickGameObject(Vector2 position, bool selectPrefabRoot) => throw Absent.Editor;
    public static bool PlaceObject(Vector2 guiPosition, out Vector3 position, out Vector3 normal) => throw Absent.Editor;
    public static object RaySnap(Ray ray) => throw Absent.Editor;
    public static Vector3 ProjectPointLine(Vector3 point, Vector3 lineStart, Vector3 lineEnd) => throw Absent.Editor;
    public static Vector3 ClosestPointToPolyLine(params Vector3[] vertices) => throw Absent.Editor;
    public static float CalcLineTranslation(Vector2 src, Vector2 dest, Vector3 srcPosition, Vector3 constraintDir) => throw Absent.Editor;
    public static void Repaint() => throw Absent.Editor;
}
