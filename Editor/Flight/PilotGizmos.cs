using System.Collections.Generic;
using Alate.Flight;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Draws the gizmos of pilots: the volume of a wanderer, the path of a follower, marks to perch on; of what flies its path, velocity
    /// and wanted velocity, and the force that carries it.
    /// </summary>
    internal static class PilotGizmos
    {
        private const float k_MarkSize = 0.5f;

        /// <summary>World units drawn for a metre per second of the body.</summary>
        private const float k_VelocityScale = 1f;

        /// <summary>World units drawn for a weight of force.</summary>
        private const float k_ForceScale = 1f;

        private static readonly FlightTrail s_Trail = new FlightTrail();

        [DrawGizmo(GizmoType.InSelectionHierarchy)]
        private static void Draw(WanderPilot pilot, GizmoType type)
        {
            FlightVolume volume = pilot.WorldVolume;
            Matrix4x4 before = Gizmos.matrix;
            Gizmos.color = GizmoColours.Bounds;
            Gizmos.matrix = Matrix4x4.TRS(volume.centre, Quaternion.identity, volume.size);
            if (volume.shape == VolumeShape.Box)
                Gizmos.DrawWireCube(Vector3.zero, Vector3.one);
            else
                Gizmos.DrawWireSphere(Vector3.zero, 0.5f);
            Gizmos.matrix = before;
        }

        [DrawGizmo(GizmoType.InSelectionHierarchy)]
        private static void Draw(FollowPilot pilot, GizmoType type)
        {
            Gizmos.color = GizmoColours.Span;
            List<Vector3> points = pilot.Points;
            for (int k = pilot.Loop ? 0 : 1; k < points.Count; k++)
                Gizmos.DrawLine(Place(pilot, points[(k + points.Count - 1) % points.Count]), Place(pilot, points[k]));
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected)]
        private static void Draw(PerchMark mark, GizmoType type)
        {
            Transform place = mark.transform;
            Gizmos.color = mark.IsFree ? GizmoColours.Up : GizmoColours.Span;
            Gizmos.DrawRay(place.position, k_MarkSize * place.up);
            Gizmos.DrawRay(place.position, k_MarkSize * place.forward);
        }

        [DrawGizmo(GizmoType.InSelectionHierarchy)]
        private static void Draw(InsectFlight flight, GizmoType type)
        {
            if (flight.Problem != FlightProblem.None || flight.Limits.TopSpeed <= 0f)
                return;
            Gizmos.color = GizmoColours.Velocity;
            Gizmos.DrawRay(flight.Position, k_VelocityScale * flight.BodyVelocity);
            Gizmos.color = GizmoColours.Up;
            Gizmos.DrawRay(flight.Position, k_ForceScale * flight.Force);
            if (flight.TryReadTrim(out _, out Vector3 wanted))
            {
                Gizmos.color = GizmoColours.Span;
                Gizmos.DrawRay(flight.Position, k_VelocityScale * wanted);
            }

            Gizmos.color = GizmoColours.Bounds;
            s_Trail.Add(flight, flight.Position);
            for (int k = 1; k < s_Trail.Points.Count; k++)
                Gizmos.DrawLine(s_Trail.Points[k - 1], s_Trail.Points[k]);
        }

        private static Vector3 Place(FollowPilot pilot, Vector3 point) => pilot.Origin == null ? point : pilot.Origin.TransformPoint(point);
    }
}
