using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Flies after an object or along points; without either stays where the insect is.</summary>
    [AddComponentMenu("Alate/Follow Pilot")]
    [DisallowMultipleComponent]
    public sealed class FollowPilot : FlightPilot
    {
        /// <summary>Speed where none is set, m/s.</summary>
        private const float k_Speed = 1f;

        /// <summary>Time over which the target's velocity is smoothed, seconds.</summary>
        private const float k_Smoothing = 0.2f;

        /// <summary>Seconds between two looks whether a goal that is not reached lies within a wall.</summary>
        private const float k_LookTime = 0.5f;

        [SerializeField]
        [Tooltip("The object to follow; none flies along the points.")]
        private Transform m_Target;

        [SerializeField]
        [Tooltip("Where the insect flies beside the target, world units along the world's axes.")]
        private Vector3 m_Offset;

        [SerializeField]
        [Tooltip("Points to fly along, world units; relative to the object below where there is one.")]
        private List<Vector3> m_Points = new List<Vector3>();

        [SerializeField]
        [Tooltip("The points go with this object; none keeps them in the world.")]
        private Transform m_Origin;

        [SerializeField]
        [Tooltip("Whether the first point follows the last; otherwise the insect stays at the last.")]
        private bool m_Loop;

        [SerializeField]
        [Range(LeastSpeed, MostSpeed)]
        [Tooltip("Metres per second of the insect; 1. Its own limits hold besides.")]
        private float m_Speed = k_Speed;

        [SerializeField]
        private ObstacleSettings m_Obstacles = ObstacleSettings.Default;

        private readonly PathFollower m_Path = new PathFollower();
        private readonly List<Vector3> m_World = new List<Vector3>();
        private float3 m_Seen, m_TargetVelocity, m_Home;
        private float m_SinceLook;
        private bool m_HasSeen, m_HasHome;

        /// <summary>The object to follow; null flies along <see cref="Points"/>.</summary>
        public Transform Target
        {
            get => m_Target;
            set
            {
                m_Target = value;
                m_HasSeen = false;
            }
        }

        /// <summary>Place of the insect beside the target, world units.</summary>
        public Vector3 Offset
        {
            get => m_Offset;
            set => m_Offset = value;
        }

        /// <summary>
        /// Points to fly along, world units, relative to <see cref="Origin"/> where there is one. May be changed at any time;
        /// <see cref="Restart"/> begins with the first.
        /// </summary>
        public List<Vector3> Points => m_Points;

        /// <summary>The object with which the points go; null keeps them in the world.</summary>
        public Transform Origin
        {
            get => m_Origin;
            set => m_Origin = value;
        }

        /// <summary>True where the first point follows the last.</summary>
        public bool Loop
        {
            get => m_Loop;
            set => m_Loop = value;
        }

        /// <summary>Most, m/s of the insect, 0.05 to 5 (clamped).</summary>
        public float Speed
        {
            get => NumberRange.Clamp(m_Speed, LeastSpeed, MostSpeed, k_Speed);
            set => m_Speed = NumberRange.Clamp(value, LeastSpeed, MostSpeed, k_Speed);
        }

        /// <summary>Settings by which the insect avoids colliders in its way.</summary>
        public ref ObstacleSettings Obstacles => ref m_Obstacles;

        /// <summary>True where the insect has come to the last point; false while it follows an object, or has no points.</summary>
        public bool HasArrived => m_Target == null && m_Points.Count > 0 && m_Path.HasArrived;

        /// <summary>Flies to a point, world units, and stays there.</summary>
        public void GoTo(Vector3 point)
        {
            m_Target = null;
            m_Points.Clear();
            m_Points.Add(m_Origin == null ? point : m_Origin.InverseTransformPoint(point));
            Restart();
        }

        /// <summary>Begins the path with its first point.</summary>
        public void Restart()
        {
            m_Path.Restart();
            m_HasHome = m_HasSeen = false;
        }

        /// <inheritdoc/>
        public override FlightCommand Command(in FlightSituation situation)
        {
            float3 wanted = Wanted(situation, out float3 goal);
            float left = math.distance(goal, situation.position) / situation.unitsPerMetre;
            float3 velocity = Avoid(wanted, situation, m_Obstacles, left);
            m_SinceLook += situation.deltaTime;
            if (IsBlocked && m_SinceLook > k_LookTime && IsWithinWall(goal))
                Warn($"The goal of '{name}' at {(Vector3)goal} lies within a collider: the insect stays before it. Move the goal out.");
            return FlightCommand.Fly(velocity);
        }

        /// <summary>The points in the world; a point that is not finite is left out with a warning.</summary>
        internal IReadOnlyList<Vector3> WorldPoints()
        {
            m_World.Clear();
            for (int k = 0; k < m_Points.Count; k++)
            {
                Vector3 point = m_Points[k], place = m_Origin == null ? point : m_Origin.TransformPoint(point);
                if (OuterBounds.Hold(place, OuterBounds.Distance))
                    m_World.Add(place);
                else
                    Warn($"Point {k} of '{name}' is {point}: points must be finite, within {OuterBounds.Distance} units. It is left out.");
            }

            return m_World;
        }

        private float3 Wanted(in FlightSituation situation, out float3 goal)
        {
            if (m_Target != null)
                return AfterTarget(situation, out goal);
            IReadOnlyList<Vector3> points = WorldPoints();
            if (points.Count == 0)
                return Stay(situation, out goal);
            m_HasHome = false;
            float3 wanted = m_Path.Along(situation, points, m_Loop, Speed);
            goal = points[m_Path.Next];
            return wanted;
        }

        private float3 AfterTarget(in FlightSituation situation, out float3 goal)
        {
            goal = (float3)(m_Target.position + m_Offset);
            if (!OuterBounds.Hold(goal, OuterBounds.Distance))
            {
                Warn($"The target of '{name}' is at {(Vector3)goal}: it must be finite, within "
                    + $"{OuterBounds.Distance} units. It stays where it is.");
                m_HasSeen = false;
                return Stay(situation, out goal);
            }

            m_HasHome = false;
            float3 moved = m_HasSeen ? (goal - m_Seen) / (math.max(situation.deltaTime, 1e-4f) * situation.unitsPerMetre) : default;
            moved = math.clamp(moved, -OuterBounds.Speed, OuterBounds.Speed);
            m_TargetVelocity = m_HasSeen
                ? math.lerp(m_TargetVelocity, moved, 1f - Elementary.Exp(-situation.deltaTime / k_Smoothing))
                : default;
            m_Seen = goal;
            m_HasSeen = true;
            return PathFollower.Towards(situation, goal, m_TargetVelocity, Speed);
        }

        private float3 Stay(in FlightSituation situation, out float3 goal)
        {
            if (!m_HasHome)
                m_Home = situation.position;
            m_HasHome = true;
            goal = m_Home;
            return PathFollower.Towards(situation, m_Home, default, Speed);
        }

        private bool IsWithinWall(float3 goal)
        {
            m_SinceLook = 0f;
            return Physics.CheckSphere(goal, 1e-3f, m_Obstacles.layers, QueryTriggerInteraction.Ignore);
        }

        private void OnEnable() => Restart();

        private void OnValidate() => Speed = m_Speed;
    }
}
