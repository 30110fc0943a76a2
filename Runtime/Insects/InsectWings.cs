using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Serialization;

namespace Alate
{
    /// <summary>
    /// Makes the wings of an insect flex as they beat. Put it on the root of an insect: it finds the wings below and gives each a living
    /// copy of its mesh while the game plays; the authored meshes come back when it is disabled.
    /// </summary>
    [AddComponentMenu("Alate/Insect Wings")]
    [Icon("Packages/com.alate.insect-wings/Editor/Icons/InsectWings.png")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(ExecutionOrders.InsectWings)]
    public sealed partial class InsectWings : MonoBehaviour
    {
        private const float k_LeastPhase = 0f, k_MostPhase = 360f;

        [SerializeField]
        [Tooltip("The preset: how the wings are driven and how stiff they are. None: a monarch's.")]
        [FormerlySerializedAs("m_Species")]
        private WingPreset m_Preset;

        [SerializeField]
        [Tooltip("The wings, one entry each. Find Wings fills the list.")]
        private List<Wing> m_Wings = new List<Wing>();

        [SerializeField]
        [Tooltip("When the wings are stepped. Fixed Update: with the physics. Update: each frame. Unscaled Time: also while the game is "
            + "paused. Manual: by InsectWings.Step.")]
        private WingUpdateMode m_UpdateMode;

        [SerializeField]
        [Range(k_LeastPhase, k_MostPhase)]
        [Tooltip("Degrees of the beat at which the wings start; 0 is the top of the stroke. Give the insects of a swarm different ones.")]
        private float m_StartPhase;

        [SerializeField]
        private InsectSteering m_Steering = InsectSteering.Default;

        [SerializeField]
        private InsectMotion m_Motion = InsectMotion.Default;

        [SerializeField]
        private InsectAir m_Air = InsectAir.Default;

        [SerializeField]
        private InsectQuality m_Quality = InsectQuality.Default;

        [SerializeField]
        private InsectPreview m_Preview;

        // Found, not chosen: it must not follow into a clone, nor stay when the insect changes its carrier.
        private Rigidbody m_Carrier;

        /// <summary>The preset; null stands for a monarch. A preset that changes is followed from the next step on.</summary>
        public WingPreset Preset
        {
            get => m_Preset;
            set => m_Preset = value;
        }

        /// <summary>The wings. The list may be changed at any time; what changed is rebuilt in the next frame.</summary>
        public List<Wing> Wings => m_Wings;

        /// <summary>Time at which the wings are stepped.</summary>
        public WingUpdateMode UpdateMode
        {
            get => m_UpdateMode;
            set => m_UpdateMode = value;
        }

        /// <summary>
        /// Phase at which the wings start, degrees of the beat, 0 to 360 (clamped); takes effect with <see cref="ResetState"/>.
        /// </summary>
        public float StartPhase
        {
            get => NumberRange.Clamp(m_StartPhase, k_LeastPhase, k_MostPhase, 0f);
            set => m_StartPhase = NumberRange.Clamp(value, k_LeastPhase, k_MostPhase, 0f);
        }

        /// <summary>Changes to the preset's beat; for flight controllers.</summary>
        public ref InsectSteering Steering => ref m_Steering;

        /// <summary>Source of the body's motion, and the response to jumps.</summary>
        public ref InsectMotion Motion => ref m_Motion;

        /// <summary>Wind around the insect.</summary>
        public ref InsectAir Air => ref m_Air;

        /// <summary>Fineness of the computation.</summary>
        public ref InsectQuality Quality => ref m_Quality;

        /// <summary>Pose that the editor shows while the game does not play.</summary>
        public ref InsectPreview Preview => ref m_Preview;

        /// <summary>Velocity of the body, world units per second, with <see cref="VelocitySource.Script"/>.</summary>
        public Vector3 Velocity { get; set; }

        /// <summary>Turning of the body, radians per second about the world's axes, with <see cref="VelocitySource.Script"/>.</summary>
        public Vector3 AngularVelocity { get; set; }

        /// <summary>State of the wings: living, or the reason why not.</summary>
        public InsectState State => Problem.State;

        /// <summary>State together with the remedy.</summary>
        public InsectProblem Problem { get; private set; }

        /// <summary>Raised in the editor when an insect was loaded or edited.</summary>
        internal static event Action<InsectWings> Validated;

        internal LiveInsect Live { get; set; }

        /// <summary>Flight that carries the insect by its wings; null where something else moves it.</summary>
        internal IFlyingInsect Flyer { get; set; }

        internal InsectMotion MotionSettings => m_Motion.Clamped();

        internal int SubstepsPerBeat => m_Quality.Clamped().substepsPerBeat;

        internal int Patches => m_Quality.Clamped().patches;

        /// <summary>Rigidbody for <see cref="VelocitySource.Rigidbody"/>; null where there is none.</summary>
        internal Rigidbody Body
        {
            get
            {
                if (m_Motion.body != null)
                    return m_Motion.body;
                if (m_Carrier == null)
                    m_Carrier = GetComponentInParent<Rigidbody>();
                return m_Carrier;
            }
        }

        /// <summary>
        /// Advances the wings by some time, seconds, in <see cref="WingUpdateMode.Manual"/>; they are drawn at the end of the frame. Steps
        /// longer than a quarter of a second are cut.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The time is negative or not finite.</exception>
        /// <exception cref="InvalidOperationException">The update mode is not Manual.</exception>
        public void Step(float dt)
        {
            if (!(dt >= 0f) || float.IsInfinity(dt))
                throw new ArgumentOutOfRangeException(nameof(dt), dt, "Must be 0 or more and finite, seconds.");
            if (m_UpdateMode != WingUpdateMode.Manual)
                throw new InvalidOperationException($"'{name}' is stepped by {m_UpdateMode}; set UpdateMode to Manual to step it by hand.");
            if (dt > 0f && isActiveAndEnabled)
                WingSystem.Loop?.StepByHand(this, dt);
        }

        /// <summary>Puts the wings back to the start of their beat, unbent, at <see cref="StartPhase"/>.</summary>
        public void ResetState()
        {
            if (Live != null)
                WingSystem.Loop.Restart(Live);
        }

        /// <summary>
        /// Moves without motion: tells the wings that the insect jumps to another place in this frame, so that the jump is not felt.
        /// </summary>
        /// <param name="keepMotion">Whether the wings beat on; otherwise they start over.</param>
        public void Teleport(bool keepMotion = true)
        {
            if (Live == null)
                return;
            Live.motion.Interrupt();
            if (!keepMotion)
                ResetState();
        }

        /// <summary>
        /// Fills the list of wings with those found below this object by names and symmetry. Wings that were in the list keep their
        /// settings; entries without a renderer go, and those for other parts of a renderer in which wings are found.
        /// </summary>
        /// <returns>How many were found.</returns>
        public int FindWings()
        {
            List<Wing> found = WingFinder.Find(transform), merged = WingList.Merge(m_Wings, found);
            m_Wings.Clear();
            m_Wings.AddRange(merged);
            return found.Count;
        }

        /// <summary>
        /// Takes up changes that a script made to the content of the authored meshes. In the next frame this insect is rebuilt, with all
        /// that have the same meshes, wings, skeletons and number of patches.
        /// </summary>
        public void Rebuild()
        {
            for (int mesh = 0; Live != null && mesh < Live.meshes.Count; mesh++)
                Live.meshes[mesh].template.IsOutdated = true;
        }

        /// <summary>Finds the first problem that keeps the wings from living, as far as can be seen without playing.</summary>
        internal InsectProblem FindProblem() => InsectCheck.Find(this);

        /// <summary>Takes over a state, and logs it where it is a new problem.</summary>
        internal void Report(in InsectProblem problem)
        {
            bool isNew = problem.State != Problem.State || problem.Wing != Problem.Wing;
            Problem = problem.IsProblem ? problem.Of(name) : problem;
            if (isNew && Problem.IsProblem)
                Debug.LogWarning(Problem.Message, this);
        }

        private void Reset() => FindWings();

        private void OnEnable()
        {
            foreach (Wing wing in m_Wings)
                InsectCheck.Repair(wing);
            WingSystem.Enter(this);
        }

        private void OnDisable()
        {
            WingSystem.Leave(this);
            Report(InsectProblem.Inactive);
        }

        private void OnTransformParentChanged() => m_Carrier = null;

        private void OnValidate()
        {
            StartPhase = m_StartPhase;
            foreach (Wing wing in m_Wings)
                wing?.FillIn();
            m_Steering = m_Steering.Clamped();
            m_Motion = m_Motion.Clamped();
            m_Quality = m_Quality.Clamped();
            Validated?.Invoke(this);
        }
    }
}
