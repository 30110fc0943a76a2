using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>Tangents along the texture's u, with the sign that makes cross(normal, tangent) run along its v.</summary>
public sealed partial class Mesh
{
    public void RecalculateTangents() => RecalculateTangents(MeshUpdateFlags.Default);

    public void RecalculateTangents(MeshUpdateFlags flags)
    {
        Vector3[] points = vertices;
        Vector3[] up = normals;
        Vector2[] texture = uv;
        if (up.Length == 0 || texture.Length == 0)
            return;
        var alongU = new Vector3[points.Length];
        var alongV = new Vector3[points.Length];
        int[] corners = triangles;
        for (int t = 0; t + 2 < corners.Length; t += 3)
        {
            (int a, int b, int c) = (corners[t], corners[t + 1], corners[t + 2]);
            (float u1, float v1) = (texture[b].x - texture[a].x, texture[b].y - texture[a].y);
            (float u2, float v2) = (texture[c].x - texture[a].x, texture[c].y - texture[a].y);
            float area = u1 * v2 - u2 * v1;
            if (area == 0f)
                continue;
            (Vector3 first, Vector3 second) = (points[b] - points[a], points[c] - points[a]);
            Vector3 du = (first * v2 - second * v1) / area;
            Vector3 dv = (second * u1 - first * u2) / area;
            foreach (int corner in new[] { a, b, c })
            {
                alongU[corner] += du.normalized;
                alongV[corner] += dv.normalized;
            }
        }

        var found = new Vector4[points.Length];
        for (int i = 0; i < found.Length; i++)
        {
            Vector3 tangent = (alongU[i] - up[i] * Vector3.Dot(up[i], alongU[i])).normalized;
            float side = Vector3.Dot(Vector3.Cross(up[i], tangent), alongV[i]) < 0f ? -1f : 1f;
            found[i] = new Vector4(tangent.x, tangent.y, tangent.z, side);
        }

        tangents = found;
    }
}
