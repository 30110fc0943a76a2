namespace UnityEngine;

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

    public Plane(Vector3 a, Vector3 b, Vector3 c) : this(Vector3.Cross(b - a, c - a), a)
    {
    }

    public Vector3 normal { get; set; }
    public float distance { get; set; }

    public float GetDistanceToPoint(Vector3 point) => Vector3.Dot(normal, point) + distance;
    public Vector3 ClosestPointOnPlane(Vector3 point) => point - normal * GetDistanceToPoint(point);
    public bool GetSide(Vector3 point) => GetDistanceToPoint(point) > 0f;

    /// <summary>Whether the ray meets the plane ahead; the distance is negative if it met it behind, 0 if it runs along.</summary>
    public bool Raycast(Ray ray, out float enter)
    {
        float slope = Vector3.Dot(ray.direction, normal);
        enter = Mathf.Abs(slope) < 1e-12f ? 0f : -GetDistanceToPoint(ray.origin) / slope;
        return enter > 0f;
    }
}
