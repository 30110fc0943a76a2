using System.Collections.Generic;

namespace UnityEngine;

/// <summary>A shape that rays meet. It has no contacts: bodies pass through it.</summary>
public class Collider : Component, IStateful
{
    private static readonly List<Collider> s_All = [];
    private bool _enabled = true;

    public Collider() => s_All.Add(this);

    public bool enabled
    {
        get
        {
            CheckAlive();
            return _enabled;
        }
        set
        {
            CheckAlive();
            _enabled = value;
        }
    }

    public bool isTrigger { get; set; }

    /// <summary>Writes the shapes of all colliders that are on, where they are now.</summary>
    internal static void Shapes(List<PhysicsShape> shapes)
    {
        shapes.Clear();
        foreach (Collider collider in s_All)
        {
            if (collider._enabled && collider.Owner is { ActiveFlag: true } && collider.Shape is { } shape)
                shapes.Add(shape);
        }
    }

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (Collider)copy;
        to._enabled = _enabled;
        to.isTrigger = isTrigger;
        CopyShapeTo(to);
    }

    private protected virtual PhysicsShape? Shape => null;

    private protected PhysicsShape ShapeOf(Vector3 centre, Vector3 half, bool isRound)
    {
        Vector3 scale = transform.lossyScale;
        scale = new Vector3(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
        if (isRound)
            scale = Mathf.Max(scale.x, Mathf.Max(scale.y, scale.z)) * Vector3.one;
        return new PhysicsShape(GetInstanceID(), gameObject.layer, isTrigger, transform.TransformPoint(centre), transform.rotation,
            Vector3.Scale(half, scale), isRound);
    }

    private protected virtual void CopyShapeTo(Collider copy)
    {
    }

    private protected override void Released() => s_All.Remove(this);
}
