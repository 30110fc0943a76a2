using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Position loop along straight stretches between points: flies along the stretch, back to it where the insect is beside it, round
    /// corners on arcs that it can fly, and stops at the last point.
    /// </summary>
    public sealed class PathFollower
    {
        /// <summary>Rate at which a distance from the path is flown off, 1/s: a fifth of the rate at which the body follows.</summary>
        public const float Rate = 1f;

        /// <summary>Distance by which an arc may cut a corner, metres.</summary>
        private const float k_CornerCut = 0.15f;

        /// <summary>Slowest flight round a corner, m/s.</summary>
        private const float k_CornerSpeed = 0.2f;

        /// <summary>Cosine of the sharpest turn that counts: half of a turn straight back has no tangent.</summary>
        private const float k_SharpestTurn = -0.995f;

        private int m_Stretch = -1;

        /// <summary>The point that the insect flies to, counted from 0.</summary>
        public int Next { get; private set; }

        /// <summary>
        /// True where the last point of a path that does not loop, or the only point, is near: within 5 cm of the insect.
        /// </summary>
        public bool HasArrived { get; private set; }

        /// <summary>Begins again with the first point.</summary>
        public void Restart()
        {
            m_Stretch = -1;
            HasArrived = false;
        }

        /// <summary>Velocity towards a point that may move, m/s: as fast as the insect can stop there, and with the point.</summary>
        /// <param name="situation">The insect now.</param>
        /// <param name="point">World units.</param>
        /// <param name="pointVelocity">m/s of the insect.</param>
        /// <param name="speed">Most, m/s.</param>
        public static float3 Towards(in FlightSituation situation, float3 point, float3 pointVelocity, float speed)
        {
            float3 way = (point - situation.position) / situation.unitsPerMetre;
            float distance = math.length(way);
            float closing = math.min(math.min(Rate * distance, situation.limits.SpeedToStopWithin(distance)), speed);
            return pointVelocity + closing * math.normalizesafe(way);
        }

        /// <summary>Velocity along a path, m/s.</summary>
        /// <param name="situation">The insect now.</param>
        /// <param name="points">World units; at least one.</param>
        /// <param name="loop">Whether the last point is followed by the first.</param>
        /// <param name="speed">Wanted, m/s.</param>
        public float3 Along(in FlightSituation situation, IReadOnlyList<Vector3> points, bool loop, float speed)
        {
            int count = points.Count;
            speed = math.min(speed, situation.limits.TopSpeed);
            if (m_Stretch >= count)
                Restart();
            Next = Index(m_Stretch + 1, count, loop);
            float3 goal = points[Next], position = situation.position;
            bool isLast = !loop && Next == count - 1;

            // The way to the first point begins where the insect is.
            if (m_Stretch < 0 || count == 1)
            {
                float left = math.distance(goal, position) / situation.unitsPerMetre;
                if (left < 0.5f * situation.limits.StoppingDistance(speed) && count > 1)
                    m_Stretch = 0;
                HasArrived = count == 1 && left < 0.05f;
                return Towards(situation, goal, default, speed);
            }

            float3 start = points[Index(m_Stretch, count, loop)];
            float length = math.distance(start, goal) / situation.unitsPerMetre;
            float3 tangent = math.normalizesafe(goal - start);
            float gone = math.dot(position - start, tangent) / situation.unitsPerMetre, ahead = length - gone;
            float corner = 0f, lead = 0f;
            if (!isLast)
            {
                Corner(situation.limits, tangent, math.normalizesafe((float3)points[Index(Next + 1, count, loop)] - goal), speed,
                    out corner, out lead);
            }
            if (!isLast && ahead <= math.min(lead, 0.5f * length))
            {
                m_Stretch = Next;
                return Along(situation, points, loop, speed, tangent, corner);
            }

            HasArrived = isLast && math.distance(goal, position) < 0.05f * situation.unitsPerMetre;
            float brake = isLast ? math.min(situation.limits.SpeedToStopWithin(ahead), Rate * math.max(ahead, 0f))
                : math.sqrt(corner * corner + situation.limits.Acceleration * math.max(ahead - lead, 0f));
            float3 nearest = start + tangent * math.clamp(gone, 0f, length) * situation.unitsPerMetre;
            float3 back = Towards(situation, nearest, default, 0.5f * speed);
            return math.min(speed, brake) * tangent + back;
        }

        // On the new stretch the insect leaves the corner with the speed of its arc.
        private float3 Along(
            in FlightSituation situation, IReadOnlyList<Vector3> points, bool loop, float speed, float3 before, float corner)
        {
            Next = Index(m_Stretch + 1, points.Count, loop);
            float3 tangent = math.normalizesafe((float3)points[Next] - (float3)points[m_Stretch], before);
            return math.max(math.min(corner, speed), k_CornerSpeed) * tangent;
        }

        // The arc that cuts a corner by a distance d has the radius r = d / (1 / cos(turn / 2) - 1), touches the stretches at r tan(turn /
        // 2), and is flown at √(a r).
        private static void Corner(in FlightLimits limits, float3 before, float3 after, float speed, out float corner, out float lead)
        {
            float half = 0.5f * Elementary.Acos(math.clamp(math.dot(before, after), k_SharpestTurn, 1f));
            float radius = k_CornerCut / math.max(1f / Elementary.Cos(half) - 1f, 1e-4f);
            corner = math.clamp(math.sqrt(limits.Acceleration * radius), k_CornerSpeed, math.max(speed, k_CornerSpeed));
            lead = math.min(
                corner * corner / limits.Acceleration * math.min(Elementary.Tan(half), 2f) + 0.2f * corner * Elementary.Sin(half),
                limits.StoppingDistance(corner) + 0.3f);
        }

        private static int Index(int index, int count, bool loop) =>
            loop ? index % count : math.min(index, count - 1);
    }
}
