using System;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public void RecalculateBounds() => RecalculateBounds(MeshUpdateFlags.Default);

    /// <summary>The box around the vertices that each submesh spans, and around all of these.</summary>
    public void RecalculateBounds(MeshUpdateFlags flags)
    {
        if (!CanAccess("vertices"))
            return;
        var points = _buffer.ReadAll<Vector3>(VertexAttribute.Position);
        Bounds? all = null;
        for (int i = 0; i < _indices.PartCount; i++)
        {
            SubMeshDescriptor part = _indices.Part(i);
            if (part.vertexCount == 0 || part.firstVertex + part.vertexCount > points.Length)
                continue;
            Bounds box = Around(points.AsSpan(part.firstVertex, part.vertexCount));
            _indices.SetPartBounds(i, box);
            if (all is { } sofar)
                box.Encapsulate(sofar);
            all = box;
        }

        _bounds = all ?? (points.Length == 0 ? default : Around(points));
    }

    public void RecalculateNormals() => RecalculateNormals(MeshUpdateFlags.Default);

    public void RecalculateNormals(MeshUpdateFlags flags)
    {
        if (!CanAccess("vertices"))
            return;
        var points = _buffer.ReadAll<Vector3>(VertexAttribute.Position);
        var sums = new Vector3[points.Length];
        int[] corners = triangles;
        for (int i = 0; i < corners.Length; i += 3)
        {
            Vector3 normal = Vector3.Cross(
                points[corners[i + 1]] - points[corners[i]], points[corners[i + 2]] - points[corners[i]]);
            for (int k = 0; k < 3; k++)
                sums[corners[i + k]] += normal;
        }

        normals = Array.ConvertAll(sums, sum => sum.sqrMagnitude > 0f ? sum / sum.magnitude : Vector3.zero);
    }

    private static Bounds Around(ReadOnlySpan<Vector3> points)
    {
        Vector3 least = points[0];
        Vector3 largest = points[0];
        foreach (Vector3 point in points)
        {
            least = Vector3.Min(least, point);
            largest = Vector3.Max(largest, point);
        }

        var box = default(Bounds);
        box.SetMinMax(least, largest);
        return box;
    }
}
