namespace UnityEngine;

public struct RaycastHit
{
    private readonly int _collider;

    internal RaycastHit(int collider) : this() => _collider = collider;

    public Vector3 point { get; set; }
    public Vector3 normal { get; set; }
    public float distance { get; set; }

    public readonly Collider collider => _collider == 0 ? null : ObjectRegistry.Get(_collider) as Collider;

    public readonly Transform transform => collider is { } met ? met.transform : null;
}
