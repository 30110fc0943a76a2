namespace UnityEngine;

public class BoxCollider : Collider
{
    public Vector3 center { get; set; }
    public Vector3 size { get; set; } = Vector3.one;

    private protected override PhysicsShape? Shape => ShapeOf(center, 0.5f * size, false);

    private protected override void CopyShapeTo(Collider copy)
    {
        var to = (BoxCollider)copy;
        to.center = center;
        to.size = size;
    }
}
