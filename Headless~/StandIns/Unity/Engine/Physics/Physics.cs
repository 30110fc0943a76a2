using System.Collections.Generic;

namespace UnityEngine;

/// <summary>
/// Rays and spheres against the colliders of the scene. Colliders are where their transforms are, without a step between.
/// </summary>
public class Physics
{
    public const int DefaultRaycastLayers = -5;
    public const int AllLayers = -1;

    private static readonly List<PhysicsShape> s_Shapes = [];

    public static Vector3 gravity { get; set; } = new(0f, -9.81f, 0f);

    public static bool Raycast(
        Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask,
        QueryTriggerInteraction queryTriggerInteraction)
    {
        Collider.Shapes(s_Shapes);
        return Nearest(s_Shapes, origin, direction, maxDistance, layerMask, queryTriggerInteraction, out hitInfo);
    }

    public static bool CheckSphere(Vector3 position, float radius, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
    {
        Collider.Shapes(s_Shapes);
        foreach (PhysicsShape shape in s_Shapes)
        {
            if (shape.IsMet(layerMask, queryTriggerInteraction) && shape.Touches(position, radius))
                return true;
        }

        return false;
    }

    internal static bool Nearest(
        List<PhysicsShape> shapes, Vector3 origin, Vector3 direction, float maxDistance, int layerMask, QueryTriggerInteraction triggers,
        out RaycastHit hit)
    {
        hit = default;
        float length = direction.magnitude;
        if (!(length > 0f) || !(maxDistance > 0f))
            return false;
        bool any = false;
        foreach (PhysicsShape shape in shapes)
        {
            if (!shape.IsMet(layerMask, triggers) || !shape.Raycast(origin, direction / length, maxDistance, out RaycastHit met))
                continue;
            any = true;
            maxDistance = met.distance;
            hit = met;
        }

        return any;
    }
}
