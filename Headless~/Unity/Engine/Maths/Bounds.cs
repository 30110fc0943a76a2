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

    public Vector3 min => center - extents;
    public Vector3 max => center + extents;

    public void SetMinMax(Vector3 min, Vector3 max)
    {
        extents = (max - min) * 0.5f;
        center = min + extents;
    }

    public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

    public bool Contains(Vector3 point) =>
        Vector3.Min(point, min).Equals(min) && Vector3.Max(point, max).Equals(max);

    public bool Equals(Bounds other) => center.Equals(other.center) && extents.Equals(other.extents);
    public override bool Equals(object other) => other is Bounds bounds && Equals(bounds);
    public override int GetHashCode() => HashCode.Combine(center, extents);
}
