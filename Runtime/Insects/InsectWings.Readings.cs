using System;
using UnityEngine;
using UnityEngine.Events;

namespace Alate
{
    /// <summary>Events and readings of the wings. All numbers are 0 while the wings do not live.</summary>
    public sealed partial class InsectWings
    {
        [SerializeField]
        [Tooltip("Called at the start of each beat of the first wing, at the end of the frame; for sound and the like.")]
        private UnityEvent m_OnWingBeat = new UnityEvent();

        /// <summary>Raised at the start of each beat of the first wing, once a frame at most, after the meshes were deformed.</summary>
        public event Action<InsectWings> WingBeat;

        /// <summary>Counterpart of <see cref="WingBeat"/> for the inspector.</summary>
        public UnityEvent OnWingBeat => m_OnWingBeat;

        /// <summary>Frequency of the first wing's current beat, hertz.</summary>
        public float Frequency => Live == null ? 0f : Read(0).Frequency;

        /// <summary>Range of flapping of the first wing's current beat, degrees from lowest to highest.</summary>
        public float FlapRange => Live == null ? 0f : 2f * Mathf.Rad2Deg * Read(0).Amplitude.x;

        /// <summary>Phase of the first wing's beat, degrees, 0 at the top.</summary>
        public float Phase => Live == null ? 0f : Mathf.Rad2Deg * Read(0).Phase;

        /// <summary>Pitch of the body against the horizon, degrees, nose up positive (AoA of Eq. 6–7).</summary>
        public float AngleOfAttack => Live == null ? 0f : Mathf.Rad2Deg * Live.Pitch;

        /// <summary>
        /// Reason why the processor deforms the wings though <see cref="InsectQuality.skinning"/> asks for the graphics card; empty where
        /// there is none.
        /// </summary>
        public string SkinningObstacle => Live?.Obstacle ?? "";

        /// <summary>Level of detail with which the wings are computed now.</summary>
        public WingDetail Detail => Live == null ? WingDetail.Frozen : Live.Detail;

        /// <summary>Air force on all wings of the real insect, newtons, world axes; mean over the last step.</summary>
        public Vector3 AirForce
        {
            get
            {
                Vector3 sum = default;
                for (int wing = 0; Live != null && wing < Live.wings.Length; wing++)
                    sum += AirForceOf(wing);
                return sum;
            }
        }

        /// <summary>
        /// Moment of the air on all wings of the real insect about its own origin, newton metres, world axes; mean over the last step. Its
        /// sense is Unity's: a positive component turns as <see cref="Rigidbody.AddTorque(Vector3)"/> does.
        /// </summary>
        public Vector3 AirMoment
        {
            get
            {
                Vector3 sum = default;
                for (int wing = 0; Live != null && wing < Live.wings.Length; wing++)
                    sum += AirMomentOf(wing);
                return sum;
            }
        }

        /// <summary>Part of <see cref="AirForce"/> against gravity, newtons.</summary>
        public float Lift => Live == null ? 0f : Vector3.Dot(AirForce, -Physics.gravity.normalized);

        /// <summary>
        /// Part of <see cref="AirForce"/> against the flight through the air, newtons; 0 while the insect stands in still air.
        /// </summary>
        public float Drag
        {
            get
            {
                if (Live == null)
                    return 0f;
                Vector3 through = Live.flight.velocity - Live.flight.wind;
                return -Vector3.Dot(AirForce, through.normalized);
            }
        }

        /// <summary>
        /// Lift over the weight of the real insect: times mass and gravity of a Rigidbody it is the force that carries it.
        /// </summary>
        public float LiftOverWeight
        {
            get
            {
                float weight = Live == null ? 0f : Live.wings[0].values.size.insectMass * Physics.gravity.magnitude;
                return weight > 0f ? Lift / weight : 0f;
            }
        }

        /// <summary>Air force on one wing of the real insect, newtons, world axes; mean over the last step.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing.</exception>
        public Vector3 AirForceOf(int wing)
        {
            CheckWing(wing);
            if (Live == null)
                return default;
            LiveWing live = Live.wings[wing];
            return live.placed.ToWorld(Read(wing).AirForce) * (live.values.size.wingMass * live.values.size.wingLength);
        }

        /// <summary>
        /// Moment of the air on one wing of the real insect about the insect's origin, newton metres, world axes; mean over the last step.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing.</exception>
        public Vector3 AirMomentOf(int wing)
        {
            CheckWing(wing);
            if (Live == null)
                return default;
            LiveWing live = Live.wings[wing];
            return live.placed.AxisToWorld(Read(wing).AirMoment)
                * (live.values.size.wingMass * live.values.size.wingLength * live.values.size.wingLength);
        }

        /// <summary>Power that all wings of the real insect give to the air, watts; mean over the last step.</summary>
        public float AirPower
        {
            get
            {
                float sum = 0f;
                for (int wing = 0; Live != null && wing < Live.wings.Length; wing++)
                {
                    PresetSize size = Live.wings[wing].values.size;
                    sum += Read(wing).AirPower * (size.wingMass * size.wingLength * size.wingLength);
                }

                return sum;
            }
        }

        /// <summary>
        /// Largest stretch of any wing's membrane between its joints, in the last step; 0.1 is 10 %. Wings look torn above 0.1.
        /// </summary>
        public float Stretch
        {
            get
            {
                float largest = 0f;
                for (int wing = 0; Live != null && wing < Live.wings.Length; wing++)
                    largest = Mathf.Max(largest, Read(wing).Stretch);
                return largest;
            }
        }

        /// <summary>Full state of a wing, in its own frame; see <see cref="WingReading"/>. Waits for jobs that are under way.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing.</exception>
        /// <exception cref="InvalidOperationException">The wings do not live; see <see cref="State"/>.</exception>
        public WingReading Read(int wing)
        {
            CheckWing(wing);
            if (Live == null)
                throw new InvalidOperationException($"The wings of '{name}' do not live: {State}.");
            return WingSystem.Loop.World.Read(Live.wings[wing].handle);
        }

        /// <summary>
        /// World position of a joint as drawn: between two steps, in agreement with the mesh. The origin where the wing does not live.
        /// </summary>
        /// <param name="wing">In the list.</param>
        /// <param name="chain">0 is the leading edge.</param>
        /// <param name="joint">0 is the root.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing, or no such chain or joint of a wing that lives.</exception>
        public Vector3 JointPosition(int wing, int chain, int joint)
        {
            CheckWing(wing);
            if (Live == null || Live.wings[wing].transform == null)
                return default;
            LiveWing live = Live.wings[wing];
            return live.transform.TransformPoint(live.rig.Frame.ToMesh(Read(wing).JointPosition(chain, joint, DrawnAlpha)));
        }

        /// <summary>
        /// Bounds of a wing's mesh part as last deformed, in the space of its renderer; somewhat larger where the graphics card deforms it.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such wing.</exception>
        public Bounds BoundsOf(int wing)
        {
            CheckWing(wing);
            return Live == null ? default : WingSystem.Loop.World.Bounds(Live.wings[wing].handle);
        }

        /// <summary>Time within the last step at which the wings were last drawn, 0 its start, 1 its end.</summary>
        internal float DrawnAlpha => WingSystem.Loop.DrawnAlpha(Live.Clock);

        /// <summary>Phase of the first wing's beat as the wings were last drawn, degrees.</summary>
        internal float DrawnPhase => Phase - 360f * Frequency * WingSystem.Loop.DrawnBehind(Live.Clock);

        internal void TellBeat()
        {
            try
            {
                WingBeat?.Invoke(this);
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, this);
            }

            m_OnWingBeat.Invoke();
        }

        private void CheckWing(int wing)
        {
            int count = Live == null ? m_Wings.Count : Live.wings.Length;
            if (wing < 0 || wing >= count)
                throw new ArgumentOutOfRangeException(nameof(wing), wing, $"'{name}' has {count} wings.");
        }
    }
}
