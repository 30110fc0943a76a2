namespace UnityEngine;

public class SphereCollider : Collider
{
    public Vector3 center { get; set; }
    public float radius { get; set; } = 0.5f;

    private protected override PhysicsShape? Shape => ShapeOf(center, radius * Vector3.one, true);

    private protected override void CopyShapeTo(Collider copy)
    {
        var to = (SphereCollider)copy;
        to.center = center;
        to.radius = radius;
    }
}
