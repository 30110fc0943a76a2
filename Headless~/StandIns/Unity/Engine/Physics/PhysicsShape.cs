using System;

namespace UnityEngine;

/// <summary>A box or a sphere in the world, as rays and spheres meet it.</summary>
internal readonly record struct PhysicsShape(
    int Collider, int Layer, bool IsTrigger, Vector3 Centre, Quaternion Rotation, Vector3 Half, bool IsRound)
{
    /// <summary>Returns true where a query looks at it.</summary>
    public bool IsMet(int layerMask, QueryTriggerInteraction triggers) =>
        (layerMask & (1 << Layer)) != 0 && (!IsTrigger || triggers != QueryTriggerInteraction.Ignore);

    /// <summary>Finds the place where a ray enters; one that starts within does not.</summary>
    public bool Raycast(Vector3 from, Vector3 direction, float distance, out RaycastHit hit)
    {
        var back = Quaternion.Inverse(Rotation);
        Vector3 start = back * (from - Centre), along = back * direction;
        Vector3 normal = default;
        float at = IsRound ? MeetSphere(start, along) : MeetBox(start, along, out normal);
        hit = default;
        if (!(at >= 0f && at <= distance))
            return false;
        Vector3 place = start + at * along;
        hit = new RaycastHit(Collider)
        {
            distance = at,
            point = from
            + at * direction,
            normal = Rotation * (IsRound ? place.normalized : normal)
        };
        return true;
    }

    /// <summary>Returns true where a sphere touches it.</summary>
    public bool Touches(Vector3 place, float radius)
    {
        Vector3 within = Quaternion.Inverse(Rotation) * (place - Centre);
        if (IsRound)
            return within.magnitude <= radius + Half.x;
        var nearest = Vector3.Max(-Half, Vector3.Min(Half, within));
        return (within - nearest).magnitude <= radius;
    }

    private float MeetSphere(Vector3 start, Vector3 along)
    {
        float nearest = -Vector3.Dot(start, along);
        float under = nearest * nearest - start.sqrMagnitude + Half.x * Half.x;
        return under < 0f || start.sqrMagnitude < Half.x * Half.x ? -1f : nearest - MathF.Sqrt(under);
    }

    private float MeetBox(Vector3 start, Vector3 along, out Vector3 normal)
    {
        float enter = float.NegativeInfinity, leave = float.PositiveInfinity;
        normal = default;
        for (int axis = 0; axis < 3; axis++)
        {
            if (along[axis] == 0f)
            {
                if (Mathf.Abs(start[axis]) > Half[axis])
                    return -1f;
                continue;
            }

            float side = Mathf.Sign(along[axis]);
            float near = (-side * Half[axis] - start[axis]) / along[axis], far = (side * Half[axis] - start[axis]) / along[axis];
            if (near > enter)
            {
                enter = near;
                normal = default;
                normal[axis] = -side;
            }

            leave = Mathf.Min(leave, far);
        }

        return enter > leave ? -1f : enter;
    }
}
