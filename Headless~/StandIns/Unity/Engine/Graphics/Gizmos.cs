using System;
using StandIns;

namespace UnityEngine;

/// <summary>Draws nothing, but notes what is drawn.</summary>
public sealed class Gizmos
{
    public static Color color { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawLine(Vector3 from, Vector3 to) => DrawnGizmos.Add("line", from, to);

    public static void DrawLineList(ReadOnlySpan<Vector3> points)
    {
    }

    public static void DrawLineStrip(ReadOnlySpan<Vector3> points, bool looped)
    {
    }

    public static void DrawRay(Vector3 from, Vector3 direction) => DrawnGizmos.Add("line", from, from + direction);

    public static void DrawSphere(Vector3 center, float radius) => DrawnGizmos.AddSolid("ball", center, 2f * radius * Vector3.one);

    public static void DrawWireSphere(Vector3 center, float radius) => DrawnGizmos.AddSolid("wire ball", center, 2f * radius * Vector3.one);

    public static void DrawCube(Vector3 center, Vector3 size) => DrawnGizmos.AddSolid("box", center, size);

    public static void DrawWireCube(Vector3 center, Vector3 size) => DrawnGizmos.AddSolid("wire box", center, size);

    public static void DrawWireMesh(Mesh mesh)
    {
    }
}
