using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Flies the erratic track of a butterfly within a volume.</summary>
    [AddComponentMenu("Alate/Wander Pilot")]
    [DisallowMultipleComponent]
    public sealed class WanderPilot : FlightPilot
    {
        [SerializeField]
        [Tooltip("Where the insect stays.")]
        private FlightVolume m_Volume = new FlightVolume(VolumeShape.Box, new Vector3(0f, 10f, 0f), new Vector3(40f, 16f, 40f));

        [SerializeField]
        [Tooltip("The volume goes with this object; none keeps it in the world.")]
        private Transform m_Around;

        [SerializeField]
        [Tooltip(
            "Counts the middle of the volume from where the insect starts, instead of from the world's origin. Around comes before it.")]
        private bool m_FromStart;

        [SerializeField]
        [Tooltip("How the insect wanders.")]
        private WanderSettings m_Settings = WanderSettings.Default;

        [SerializeField]
        [Tooltip("Number of the track: one number always gives one track. 0 takes another track for each insect.")]
        private int m_Seed;

        [SerializeField]
        private ObstacleSettings m_Obstacles = ObstacleSettings.Default;

        private ErraticCourse m_Course;
        private int m_CourseSeed;
        private Vector3 m_Start;
        private bool m_HasStarted;

        /// <summary>
        /// Volume in which the insect stays, world units; relative to <see cref="Around"/> where there is one, or else to the start with
        /// <see cref="FromStart"/>.
        /// </summary>
        public FlightVolume Volume
        {
            get => m_Volume;
            set => m_Volume = value;
        }

        /// <summary>The object with which the volume goes; null keeps the volume in the world.</summary>
        public Transform Around
        {
            get => m_Around;
            set => m_Around = value;
        }

        /// <summary>
        /// True where the middle of the volume counts from where the insect is when the pilot, once enabled, steers for the first time.
        /// </summary>
        public bool FromStart
        {
            get => m_FromStart;
            set => m_FromStart = value;
        }

        /// <summary>Settings of the track.</summary>
        public ref WanderSettings Settings => ref m_Settings;

        /// <summary>Settings by which the insect avoids colliders in its way.</summary>
        public ref ObstacleSettings Obstacles => ref m_Obstacles;

        /// <summary>Number of the track; 0 takes another one for each insect. A new number starts a new track.</summary>
        public int Seed
        {
            get => m_Seed;
            set => m_Seed = value;
        }

        /// <summary>The volume in the world.</summary>
        internal FlightVolume WorldVolume
        {
            get
            {
                FlightVolume volume = m_Volume;
                if (m_Around != null)
                    volume.centre += m_Around.position;
                else if (m_FromStart)
                    volume.centre += m_HasStarted ? m_Start : transform.position;
                return volume;
            }
        }

        /// <summary>
        /// Keeps the insect about where it starts and above: sets <see cref="FromStart"/>, and the volume's floor to the height of the
        /// start.
        /// </summary>
        public void StayAroundStart()
        {
            m_FromStart = true;
            m_Volume.centre = new Vector3(0f, 0.5f * m_Volume.size.y, 0f);
        }

        /// <inheritdoc/>
        public override FlightCommand Command(in FlightSituation situation)
        {
            if (!m_HasStarted)
                m_Start = situation.position;
            m_HasStarted = true;
            if (m_Course == null || m_CourseSeed != m_Seed)
                m_Course = new ErraticCourse(m_Seed != 0 ? m_Seed : GetHashCode());
            m_CourseSeed = m_Seed;
            float3 wanted = m_Course.Next(situation, WorldVolume, m_Settings);
            return FlightCommand.Fly(Avoid(wanted, situation, m_Obstacles));
        }

        private void OnEnable()
        {
            m_HasStarted = false;
            m_Course?.Restart();
        }
    }
}
