using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Lets an insect fly by its own wings: beside <see cref="InsectWings"/>, it moves the object by the forces that the wings feel, and
    /// steers through the wings alone. A pilot says where to.
    /// </summary>
    [AddComponentMenu("Alate/Insect Flight")]
    [RequireComponent(typeof(InsectWings))]
    [DisallowMultipleComponent]
    public sealed partial class InsectFlight : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Trims and gains of this kind of insect.")]
        private FlightTrims m_Trims;

        [SerializeField]
        [Tooltip("Parts of the body with their shares of its mass, metres of the real insect.")]
        private List<BodyEllipsoid> m_Parts = new List<BodyEllipsoid>();

        [SerializeField]
        [Range(0f, 1f)]
        [Tooltip("Help from outside after a tumble, towards the wanted velocity and attitude: 0 none, 1 enough for 2 m/s gusts.")]
        private float m_Aid;

        [SerializeField]
        [Tooltip("Keeps commands within what the insect flies. Off: told to fly backwards, sideways or straight down, it tumbles.")]
        private bool m_GuardCommands = true;

        [SerializeField]
        [Tooltip("Wanted velocity without a pilot, m/s of the real insect along the world's axes; 0 hovers.")]
        private Vector3 m_Velocity;

        [SerializeField]
        [Tooltip("Without a pilot the nose follows the way; off: it keeps to Heading.")]
        private bool m_FollowsWay = true;

        [SerializeField]
        [Range(-180f, 180f)]
        [Tooltip("Wanted heading without a pilot, degrees about the world's up from Z; where Follows Way is off.")]
        private float m_Heading;

        private PilotSeat m_Seat;

        /// <summary>Trims and gains; null does not fly. Taken over at the next step.</summary>
        public FlightTrims Trims
        {
            get => m_Trims;
            set => m_Trims = value;
        }

        /// <summary>Parts of the body. Taken over when the component is enabled.</summary>
        public List<BodyEllipsoid> Parts => m_Parts;

        /// <summary>Outer help towards wanted velocity and attitude, 0 to 1 (clamped); 0 flies by the wings alone.</summary>
        public float Aid
        {
            get => NumberRange.Clamp(m_Aid, 0f, 1f, 0f);
            set => m_Aid = NumberRange.Clamp(value, 0f, 1f, 0f);
        }

        /// <summary>
        /// True keeps every command, whoever gives it, within what the insect flies: ahead, nose first, within its climbs, no faster than
        /// it follows. False follows whatever is commanded; an insect that is told to fly backwards, sideways or straight down, or whose
        /// wanted velocity jumps, may tumble and fall for metres. An insect that tumbles rights itself, before it heeds commands again,
        /// only while this is true.
        /// </summary>
        public bool GuardCommands
        {
            get => m_GuardCommands;
            set => m_GuardCommands = value;
        }

        /// <summary>
        /// Pilot that says where to fly: the one that was set, or else the first <see cref="FlightPilot"/> on this object, looked for four
        /// times a second; null where there is none, and then <see cref="Velocity"/> counts. Pilots that are disabled or destroyed are not
        /// asked. One that throws an exception is asked no more until it is disabled and enabled, or a pilot is set; the insect hovers.
        /// </summary>
        public IFlightPilot Pilot
        {
            get => Seat.Pilot;
            set => Seat.Pilot = value;
        }

        /// <summary>Wanted velocity without a pilot, m/s of the real insect along the world's axes.</summary>
        public Vector3 Velocity
        {
            get => m_Velocity;
            set => m_Velocity = value;
        }

        /// <summary>Wanted heading without a pilot, radians about the world's up; not a number follows the way.</summary>
        public float Heading
        {
            get => m_FollowsWay ? float.NaN : math.radians(m_Heading);
            set
            {
                m_FollowsWay = !math.isfinite(value);
                m_Heading = m_FollowsWay ? 0f : math.degrees(value);
            }
        }

        /// <summary>State of the flight: flying, tumbling, landing or perched.</summary>
        public FlightState State { get; private set; }

        /// <summary>Reason why the insect does not fly as it should.</summary>
        public FlightProblem Problem { get; private set; }

        /// <summary>True where the pilot has thrown an exception and is asked no more.</summary>
        internal bool HasPilotFailed => m_Seat != null && m_Seat.HasFailed;

        private PilotSeat Seat => m_Seat ??= new PilotSeat(this);

        /// <summary>Limits of the insect's flight; all 0 until it flies.</summary>
        public FlightLimits Limits { get; private set; }

        /// <summary>Centre of mass, world units.</summary>
        public Vector3 Position { get; private set; }

        /// <summary>Velocity of the centre of mass, m/s of the real insect; bobs with the beat.</summary>
        public Vector3 BodyVelocity { get; private set; }

        /// <summary>Power of the aid in the last step, watts of the real insect.</summary>
        public float AidPower { get; private set; }

        /// <summary>Force of air and aid, mean over the last step, in weights of the insect along the world's axes.</summary>
        internal Vector3 Force { get; private set; }

        /// <summary>Tumble that lasts, or the last one there was, in an earlier flight too; all 0 where there was none.</summary>
        public FlightTumble Tumble => m_Tumbles.Last;

        /// <summary>Number of tumbles so far, with the one that lasts; a flight that starts over goes on counting.</summary>
        public int TumbleCount => m_Tumbles.Count;

        /// <summary>Raised when the insect begins to tumble.</summary>
        public event Action<InsectFlight> TumbleBegan;

        /// <summary>Raised when the insect tumbles no more; <see cref="Tumble"/> says how long and how far it did.</summary>
        public event Action<InsectFlight> TumbleEnded;

        /// <summary>Raised when the insect has landed.</summary>
        public event Action<InsectFlight> Landed;

        /// <summary>Raised when the insect takes off.</summary>
        public event Action<InsectFlight> TookOff;

        /// <summary>
        /// Makes the flight model of the insect as it is set up now, in play or not, to bake trims for it with <see cref="TrimBake"/>.
        /// Dispose it.
        /// </summary>
        /// <exception cref="InvalidOperationException">The wings have a problem, or masses or body are not possible; the message says
        /// which.</exception>
        public FlightModel CreateModel() => SceneModel.Create(GetComponent<InsectWings>(), m_Parts);

        /// <summary>Reads the trim that is nearest to how the insect flies now.</summary>
        /// <param name="drive">Its beat.</param>
        /// <param name="wanted">Velocity that the feedback follows, m/s.</param>
        /// <returns>False where it does not fly.</returns>
        internal bool TryReadTrim(out WingDrive drive, out Vector3 wanted)
        {
            drive = default;
            wanted = m_Reference.Velocity;
            if (m_Table == null || m_Perching.Holds)
                return false;
            float3 air = m_Reference.Velocity - m_Reference.Wind;
            drive = m_Table.DriveNear(math.length(air.xz), air.y);
            return true;
        }

        private void OnEnable()
        {
            Seat.Restart();
            m_Start = default;
            m_Wings = GetComponent<InsectWings>();
            if (m_Wings != null)
                m_Wings.Flyer = m_Link ??= new Link(this);
        }

        private void OnDisable()
        {
            if (m_Wings != null && ReferenceEquals(m_Wings.Flyer, m_Link))
                m_Wings.Flyer = null;
            Detach();
        }

        private void OnDestroy() => Detach();

        private void OnValidate()
        {
            Aid = m_Aid;
        }

        private void Fail(FlightProblem problem, string why)
        {
            if (Problem == problem)
                return;
            Problem = problem;
            Debug.LogWarning($"'{name}' does not fly: {why}", this);
        }
    }
}
