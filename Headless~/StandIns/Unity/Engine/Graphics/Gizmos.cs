using System;

namespace UnityEngine;

/// <summary>Draws nothing.</summary>
public sealed class Gizmos
{
    public static Color color { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawLine(Vector3 from, Vector3 to)
    {
    }

    public static void DrawLineList(ReadOnlySpan<Vector3> points)
    {
    }

    public static void DrawLineStrip(ReadOnlySpan<Vector3> points, bool looped)
    {
    }

    public static void DrawRay(Vector3 from, Vector3 direction)
    {
    }

    public static void DrawSphere(Vector3 center, float radius)
    {
    }

    public static void DrawWireSphere(Vector3 center, float radius)
    {
    }

    public static void DrawCube(Vector3 center, Vector3 size)
    {
    }

    public static void DrawWireCube(Vector3 center, Vector3 size)
    {
    }

    public static void DrawWireMesh(Mesh mesh)
    {
    }
}
