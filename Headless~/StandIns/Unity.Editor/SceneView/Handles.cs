using UnityEngine;
using UnityEngine.Rendering;

namespace UnityEditor;

public sealed partial class Handles
{
    public delegate void CapFunction(int controlID, Vector3 position, Quaternion rotation, float size, EventType eventType);

    public static Color color { get; set; }
    public static Matrix4x4 matrix { get; set; }
    public static bool lighting { get; set; }
    public static CompareFunction zTest { get; set; }
    public static Color xAxisColor { get; }
    public static Color yAxisColor { get; }
    public static Color zAxisColor { get; }
    public static Color selectedColor { get; }
    public static Color preselectionColor { get; }

    public static void DrawLine(Vector3 p1, Vector3 p2) => DrawnLine.Check([p1, p2], 2);
    public static void DrawLine(Vector3 p1, Vector3 p2, float thickness) => throw Absent.Editor;
    public static void DrawLines(Vector3[] lineSegments) => throw Absent.Editor;
    public static void DrawLines(Vector3[] points, int[] segmentIndices) => throw Absent.Editor;
    public static void DrawDottedLine(Vector3 p1, Vector3 p2, float screenSpaceSize) => throw Absent.Editor;
    public static void DrawAAPolyLine(float width, int actualNumberOfPoints, params Vector3[] points) =>
        DrawnLine.Check(points, actualNumberOfPoints, width);
    public static void DrawAAPolyLine(float width, Color[] colors, Vector3[] points) => throw Absent.Editor;
    public static void DrawAAPolyLine(float width, params Vector3[] points) =>
        DrawnLine.Check(points, points.Length, width);
    public static void DrawAAPolyLine(Color[] colors, Vector3[] points) => throw Absent.Editor;
    public static void DrawAAPolyLine(Texture2D lineTex, float width, params Vector3[] points) => throw Absent.Editor;
    public static void DrawAAPolyLine(Texture2D lineTex, params Vector3[] points) => throw Absent.Editor;
    public static void DrawAAPolyLine(params Vector3[] points) => throw Absent.Editor;
    public static void DrawAAConvexPolygon(params Vector3[] points) => throw Absent.Editor;
    public static void DrawPolyLine(params Vector3[] points) => throw Absent.Editor;
    public static void DrawWireDisc(Vector3 center, Vector3 normal, float radius) => throw Absent.Editor;
    public static void DrawWireDisc(Vector3 center, Vector3 normal, float radius, float thickness) =>
        DrawnLine.Check([center, normal * radius], 2, thickness);
    public static void DrawSolidDisc(Vector3 center, Vector3 normal, float radius) => DrawnLine.Check([center, normal * radius], 2);
    public static void DrawWireArc(Vector3 center, Vector3 normal, Vector3 from, float angle, float radius) => throw Absent.Editor;
    public static void DrawWireArc(
        Vector3 center,
        Vector3 normal,
        Vector3 from,
        float angle,
        float radius,
        float thickness) => throw Absent.Editor;
    public static void DrawSolidArc(Vector3 center, Vector3 normal, Vector3 from, float angle, float radius) => throw Absent.Editor;
    public static void DrawWireCube(Vector3 center, Vector3 size) => throw Absent.Editor;
    public static void DrawBezier(
        Vector3 startPosition,
        Vector3 endPosition,
        Vector3 startTangent,
        Vector3 endTangent,
        Color color,
        Texture2D texture,
        float width) => throw Absent.Editor;
    public static void Label(Vector3 position, string text) => throw Absent.Editor;
    public static void Label(Vector3 position, string text, GUIStyle style)
    {
        DrawnLine.Check([position], 1);
        StandIns.DrawnLines.Labels?.Add((text, position));
    }

    public static void Label(Vector3 position, GUIContent content) => throw Absent.Editor;
    public static void Label(Vector3 position, GUIContent content, GUIStyle style) => throw Absent.Editor;
    public static void SphereHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => throw Absent.Editor;
    public static void DotHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => DrawnLine.Check([position, new Vector3(size, rotation.x, rotation.w)], 2);
    public static void CubeHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => throw Absent.Editor;
    public static void ConeHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => throw Absent.Editor;
    public static void ArrowHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => DrawnLine.Check([position, new Vector3(size, rotation.x, rotation.w)], 2);
    public static void CircleHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => throw Absent.Editor;
    public static void RectangleHandleCap(
        int controlID,
        Vector3 position,
        Quaternion rotation,
        float size,
        EventType eventType) => throw Absent.Editor;
    public static Vector3 PositionHandle(Vector3 position, Quaternion rotation) => throw Absent.Editor;
    public static Quaternion RotationHandle(Quaternion rotation, Vector3 position) => throw Absent.Editor;
    public static Vector3 ScaleHandle(Vector3 scale, Vector3 position, Quaternion rotation) => throw Absent.Editor;
    public static Vector3 FreeMoveHandle(
        int controlID,
        Vector3 position,
        float size,
        Vector3 snap,
        CapFunction capFunction) => throw Absent.Editor;
    public static Vector3 FreeMoveHandle(
        Vector3 position,
        float size,
        Vector3 snap,
        CapFunction capFunction) => throw Absent.Editor;
    public static Vector3 Slider(Vector3 position, Vector3 direction) => throw Absent.Editor;
    public static Vector3 Slider(
        Vector3 position,
        Vector3 direction,
        float size,
        CapFunction capFunction,
        float snap) => throw Absent.Editor;
    public static Vector3 Slider2D(
        Vector3 handlePos,
        Vector3 handleDir,
        Vector3 slideDir1,
        Vector3 slideDir2,
        float handleSize,
        CapFunction capFunction,
        float snap) => throw Absent.Editor;
    public static bool Button(
        Vector3 position,
        Quaternion direction,
        float size,
        float pickSize,
        CapFunction capFunction) => throw Absent.Editor;
    public static void BeginGUI()
    {
    }

    public static void EndGUI()
    {
    }

    public static void DrawSolidRectangleWithOutline(Rect rectangle, Color faceColor, Color outlineColor)
    {
        DrawnLine.Check([rectangle.min, rectangle.max], 2);
        StandIns.DrawnLines.Rectangles?.Add((rectangle, faceColor, outlineColor));
    }

    public static void SetCamera(Camera camera) => throw Absent.Editor;
    public static bool ShouldRenderGizmos() => throw Absent.Editor;
    public static float SnapValue(float value, float snap) => throw Absent.Editor;
}
