using System.Collections.Generic;
using Alate.Flight;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>
    /// Draws the insects of a flock that are far from the camera baked, by the crowd beside it: their bodies fly on, but their meshes are
    /// neither deformed nor drawn. Each shows the loops nearest to its velocity, in the phase of its own wings.
    /// </summary>
    [AddComponentMenu("Alate/Flock Crowd")]
    [RequireComponent(typeof(InsectCrowd))]
    [DefaultExecutionOrder(ExecutionOrders.CrowdPoses)]
    [DisallowMultipleComponent]
    public sealed class FlockCrowd : MonoBehaviour
    {
        /// <summary>An insect that is baked becomes live again at this share of the distance.</summary>
        private const float k_Back = 0.9f;

        private const float k_Distance = 10f;

        [SerializeField]
        [Tooltip("Number of the flock, as its pilots have it.")]
        private int m_Group;

        [SerializeField]
        [Min(0f)]
        [Tooltip("Distance from the camera beyond which insects are drawn baked, world units.")]
        private float m_Distance = k_Distance;

        private readonly List<Member> m_Members = new List<Member>();

        // Baked members by the number of their pose, which they keep for as long: motion vectors lead from pose to pose. Null where free.
        private readonly List<Member> m_Baked = new List<Member>();
        private InsectCrowd m_Crowd;

        /// <summary>Number of the flock, as its pilots have it (<see cref="FlockSettings.group"/>).</summary>
        public int Group
        {
            get => m_Group;
            set => m_Group = value;
        }

        /// <summary>Distance from the camera beyond which insects are drawn baked, world units, 0 or more.</summary>
        public float Distance
        {
            get => NumberRange.Clamp(m_Distance, 0f, OuterBounds.Distance, k_Distance);
            set => m_Distance = NumberRange.Clamp(value, 0f, OuterBounds.Distance, k_Distance);
        }

        /// <summary>Insects of the flock that are drawn baked now.</summary>
        public int BakedCount { get; private set; }

        private void OnEnable() => m_Crowd = GetComponent<InsectCrowd>();

        private void OnDisable()
        {
            foreach (Member member in m_Members)
                member.Show(true);
            m_Members.Clear();
            m_Baked.Clear();
            BakedCount = 0;
        }

        private void Update()
        {
            Gather();
            int room = math.max(m_Members.Count, m_Baked.Count);
            if (m_Crowd.Count < room)
                m_Crowd.Count = 2 * room;
            NativeArray<CrowdPose> poses = m_Crowd.Poses;
            Camera eye = m_Crowd.Camera != null ? m_Crowd.Camera : Camera.main;
            BakedCount = 0;
            for (int k = 0; k < m_Members.Count; k++)
            {
                Member member = m_Members[k];
                bool baked = poses.IsCreated && eye != null && member.IsFar(eye.transform.position, Distance);
                member.Show(!baked);
                Number(member, baked);
                if (baked)
                    BakedCount++;
            }

            for (int k = 0; k < poses.Length; k++)
                poses[k] = k < m_Baked.Count && m_Baked[k] != null ? m_Baked[k].Pose(m_Crowd.Insect) : default;
        }

        private void Number(Member member, bool baked)
        {
            if (member.IsBaked == baked)
                return;
            member.IsBaked = baked;
            int number = m_Baked.IndexOf(baked ? null : member);
            if (number < 0)
                m_Baked.Add(member);
            else
                m_Baked[number] = baked ? member : null;
        }

        // Members come and go seldom; those that went are shown as they were.
        private void Gather()
        {
            IReadOnlyList<FlockPilot> pilots = Flock.Pilots;
            for (int k = m_Members.Count - 1; k >= 0; k--)
            {
                if (m_Members[k].IsOf(m_Group))
                    continue;
                m_Members[k].Show(true);
                Number(m_Members[k], false);
                m_Members.RemoveAt(k);
            }

            for (int k = 0; k < pilots.Count; k++)
            {
                if (pilots[k].Settings.group == m_Group && !IsKnown(pilots[k]))
                    m_Members.Add(new Member(pilots[k]));
            }
        }

        private bool IsKnown(FlockPilot pilot)
        {
            for (int k = 0; k < m_Members.Count; k++)
            {
                if (ReferenceEquals(m_Members[k].Pilot, pilot))
                    return true;
            }

            return false;
        }

        /// <summary>One insect of the flock.</summary>
        private sealed class Member
        {
            private readonly InsectWings m_Wings;
            private readonly Renderer[] m_Renderers;
            private bool m_Hidden, m_KeptForces;

            public Member(FlockPilot pilot)
            {
                Pilot = pilot;
                m_Wings = pilot.GetComponent<InsectWings>();
                m_Renderers = pilot.GetComponentsInChildren<Renderer>(true);
            }

            public FlockPilot Pilot { get; }

            /// <summary>True while the insect has a pose of the crowd.</summary>
            public bool IsBaked { get; set; }

            public bool IsOf(int group) => Pilot != null && Pilot.isActiveAndEnabled && Pilot.Settings.group == group;

            public bool IsFar(Vector3 eye, float distance) =>
                m_Wings != null && m_Wings.Live != null && (Pilot.transform.position - eye).magnitude > distance * (m_Hidden ? k_Back : 1f);

            public void Show(bool shown)
            {
                if (m_Hidden != shown)
                    return;
                m_Hidden = !shown;
                if (m_Wings != null)
                    KeepForces();
                foreach (Renderer renderer in m_Renderers)
                {
                    if (renderer != null)
                        renderer.forceRenderingOff = m_Hidden;
                }
            }

            // Wings that carry the body beat on though nobody sees them.
            private void KeepForces()
            {
                if (m_Hidden)
                    m_KeptForces = m_Wings.Quality.keepForces;
                m_Wings.Quality.keepForces = m_Hidden || m_KeptForces;
            }

            public CrowdPose Pose(BakedInsect baked)
            {
                Transform body = Pilot.transform;
                var pose = CrowdPose.At(body.position, body.rotation, m_Wings.Phase / 360f);
                pose.scale = body.lossyScale.x;
                pose.rate = 0f;

                // Speed ahead and climb, in the insect's own units, as loops have them.
                float3 velocity = Pilot.Member.velocity / math.max(pose.scale, 1e-6f);
                var level = new float2(math.length(velocity.xz), velocity.y);
                float nearest = float.PositiveInfinity, next = float.PositiveInfinity;
                for (int k = 0; k < baked.Loops.Count; k++)
                {
                    CrowdLoop loop = baked.Loops[k];
                    if (loop.frames < 2 || loop.angularVelocity.sqrMagnitude > 0f)
                        continue;
                    float3 own = math.rotate(loop.attitude, (float3)loop.velocity);
                    float away = math.distance(level, new float2(own.z, own.y));
                    if (away < nearest)
                    {
                        next = nearest;
                        pose.nextLoop = pose.loop;
                        nearest = away;
                        pose.loop = k;
                    }
                    else if (away < next)
                    {
                        next = away;
                        pose.nextLoop = k;
                    }
                }

                pose.blend = float.IsInfinity(next) || nearest + next <= 0f ? 0f : nearest / (nearest + next);
                return pose;
            }
        }
    }
}
