namespace UnityEngine;

public sealed class GeometryUtility
{
    public static Plane[] CalculateFrustumPlanes(Camera camera)
    {
        var planes = new Plane[6];
        CalculateFrustumPlanes(camera, planes);
        return planes;
    }

    public static void CalculateFrustumPlanes(Camera camera, Plane[] planes) =>
        CalculateFrustumPlanes(camera.projectionMatrix * camera.worldToCameraMatrix, planes);

    /// <summary>Left, right, down, up, near, far; normals point inwards.</summary>
    public static void CalculateFrustumPlanes(Matrix4x4 worldToProjectionMatrix, Plane[] planes)
    {
        Vector4 w = worldToProjectionMatrix.GetRow(3);
        for (int i = 0; i < 6; i++)
        {
            Vector4 row = worldToProjectionMatrix.GetRow(i / 2);
            Vector4 p = i % 2 == 0 ? w + row : w - row;
            float length = ((Vector3)p).magnitude;
            planes[i] = new Plane((Vector3)p / length, p.w / length);
        }
    }

    public static bool TestPlanesAABB(Plane[] planes, Bounds bounds)
    {
        foreach (Plane plane in planes)
        {
            Vector3 n = plane.normal, e = bounds.extents;
            float reach = e.x * Mathf.Abs(n.x) + e.y * Mathf.Abs(n.y) + e.z * Mathf.Abs(n.z);
            if (plane.GetDistanceToPoint(bounds.center) < -reach)
                return false;
        }

        return true;
    }

    /// <summary>The box of world axes around a transformed box.</summary>
    internal static Bounds Around(Bounds local, Matrix4x4 toWorld)
    {
        Vector3 e = local.extents;
        Vector3 reach = new(
            Mathf.Abs(toWorld.m00) * e.x + Mathf.Abs(toWorld.m01) * e.y + Mathf.Abs(toWorld.m02) * e.z,
            Mathf.Abs(toWorld.m10) * e.x + Mathf.Abs(toWorld.m11) * e.y + Mathf.Abs(toWorld.m12) * e.z,
            Mathf.Abs(toWorld.m20) * e.x + Mathf.Abs(toWorld.m21) * e.y + Mathf.Abs(toWorld.m22) * e.z);
        return new Bounds(toWorld.MultiplyPoint3x4(local.center), 2f * reach);
    }
}

public struct Plane
{
    public Plane(Vector3 inNormal, Vector3 inPoint)
    {
        normal = inNormal.normalized;
        distance = -Vector3.Dot(normal, inPoint);
    }

    public Plane(Vector3 inNormal, float d)
    {
        normal = inNormal.normalized;
        distance = d;
    }

    public Vector3 normal { get; set; }
    public float distance { get; set; }

    public float GetDistanceToPoint(Vector3 point) => Vector3.Dot(normal, point) + distance;
    public bool GetSide(Vector3 point) => GetDistanceToPoint(point) > 0f;
    public Vector3 ClosestPointOnPlane(Vector3 point) => point - normal * GetDistanceToPoint(point);
}
