using System;

namespace UnityEngine;

public struct Bounds : IEquatable<Bounds>
{
    public Bounds(Vector3 center, Vector3 size)
    {
        this.center = center;
        extents = size * 0.5f;
    }

    public Vector3 center { get; set; }
    public Vector3 extents { get; set; }

    public Vector3 size
    {
        get => extents * 2f;
        set => extents = value * 0.5f;
    }

    public Vector3 min
    {
        get => center - extents;
        set => SetMinMax(value, max);
    }

    public Vector3 max
    {
        get => center + extents;
        set => SetMinMax(min, value);
    }

    public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.center == rhs.center && lhs.extents == rhs.extents;
    public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);

    public void SetMinMax(Vector3 min, Vector3 max)
    {
        extents = (max - min) * 0.5f;
        center = min + extents;
    }

    public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

    public void Encapsulate(Bounds bounds)
    {
        Encapsulate(bounds.min);
        Encapsulate(bounds.max);
    }

    public void Expand(float amount) => extents += Vector3.one * (amount * 0.5f);
    public void Expand(Vector3 amount) => extents += amount * 0.5f;

    public bool Intersects(Bounds bounds) =>
        min.x <= bounds.max.x && max.x >= bounds.min.x
        && min.y <= bounds.max.y && max.y >= bounds.min.y
        && min.z <= bounds.max.z && max.z >= bounds.min.z;

    public float SqrDistance(Vector3 point) => (ClosestPoint(point) - point).sqrMagnitude;
    public Vector3 ClosestPoint(Vector3 point) => Vector3.Max(min, Vector3.Min(max, point));

    public bool Contains(Vector3 point) =>
        Vector3.Min(point, min).Equals(min) && Vector3.Max(point, max).Equals(max);

    public bool Equals(Bounds other) => center.Equals(other.center) && extents.Equals(other.extents);
    public override bool Equals(object other) => other is Bounds bounds && Equals(bounds);
    public override int GetHashCode() => HashCode.Combine(center, extents);
    public override string ToString() => $"Center: {center}, Extents: {extents}";
}
