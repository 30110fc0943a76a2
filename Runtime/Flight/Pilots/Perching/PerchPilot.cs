using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Lands now and then: on a mark (<see cref="PerchMark"/>) or on a surface below, folds the wings as the species does, basks, and takes
    /// off when its time is up or something comes near. Between landings the pilot below this one on the object flies; without one the
    /// insect stays where it is.
    /// </summary>
    [AddComponentMenu("Alate/Perch Pilot")]
    [DisallowMultipleComponent]
    public sealed class PerchPilot : FlightPilot
    {
        /// <summary>Seconds between two looks for a spot, or at what is watched.</summary>
        private const float k_LookTime = 0.2f;

        /// <summary>Seconds in which it flees from what has frightened it.</summary>
        private const float k_FrightTime = 1f;

        [SerializeField]
        private PerchSettings m_Settings = PerchSettings.Default;

        [SerializeField]
        [Tooltip("What the insect flees from: cameras, animals, hands.")]
        private List<Transform> m_Watched = new List<Transform>();

        [SerializeField]
        [Tooltip("Number that the lengths of flights and stays are drawn with. 0 takes another for each insect.")]
        private int m_Seed;

        private PerchPlan m_Plan;

        // The mark whose guest the insect is, and that of its last landing, until it is away and longer; null where that was on none.
        private PerchMark m_Mark, m_Last;
        private WingRest m_Rest;
        private InsectWings m_Wings;
        private float m_SinceLook, m_Fright;
        private int m_PlanSeed;
        private float3 m_Threat = float.NaN, m_FrightenedBy;

        // Surface of the last landing that was on no mark: what a ray met, or else what touched the insect on its last way down.
        private Collider m_Surface;
        private bool m_IsSeated;

        /// <summary>Settings of when the insect lands and what it does there.</summary>
        public ref PerchSettings Settings => ref m_Settings;

        /// <summary>Objects that the insect flees from.</summary>
        public List<Transform> Watched => m_Watched;

        /// <summary>Number that lengths of flights and stays are drawn with; 0 takes another for each insect.</summary>
        public int Seed
        {
            get => m_Seed;
            set => m_Seed = value;
        }

        /// <summary>Stage of the insect.</summary>
        public PerchStage Stage => m_Plan?.Stage ?? PerchStage.Between;

        /// <summary>Share to which the wings are folded, 0 to 1.</summary>
        public float Fold => m_Rest.Fold;

        private PerchPlan Plan
        {
            get
            {
                int seed = m_Seed != 0 ? m_Seed : GetHashCode();
                if (m_Plan == null)
                    m_Plan = new PerchPlan(seed);
                else if (m_PlanSeed != seed)
                    m_Plan.Draw(seed);
                m_PlanSeed = seed;
                return m_Plan;
            }
        }

        /// <summary>Goes for a spot now. A spot that is not finite is refused with a warning.</summary>
        /// <returns>Whether the insect goes there.</returns>
        public bool LandOn(PerchSpot spot)
        {
            if (!spot.IsPossible)
            {
                Warn(
                    $"'{name}' cannot land at {(Vector3)spot.position} with the normal {(Vector3)spot.normal}: both must be finite, "
                    + $"at most {OuterBounds.Distance}. It flies on.");
                return false;
            }

            if (!OuterBounds.Hold(spot.heading, OuterBounds.Turning))
                spot.heading = float.NaN;
            Leave();
            m_Last = null;
            m_Surface = null;
            Plan.Land(spot, Stand);
            return true;
        }

        /// <summary>
        /// Goes for a mark now, and goes along with it where it moves. One that is taken, or is not finite, is refused with a warning.
        /// </summary>
        /// <returns>Whether the insect goes there.</returns>
        public bool LandOn(PerchMark mark)
        {
            if (mark == null)
                throw new ArgumentNullException(nameof(mark));
            if (mark.Guest != this && !mark.IsFree)
            {
                Warn($"'{name}' cannot land on '{mark.name}': '{mark.Guest.name}' sits there, or goes there. It flies on.");
                return false;
            }

            if (!LandOn(mark.Spot))
                return false;
            m_Mark = m_Last = mark;
            mark.Guest = this;
            return true;
        }

        /// <summary>Takes off, or gives up landing.</summary>
        public void TakeOff() => Plan.TakeOff();

        /// <summary>
        /// Frightens the insect for a second: one that sits takes off, one that comes down gives up, and it flies away from a place.
        /// </summary>
        /// <param name="from">The place, world units; where it is not finite the insect just takes off.</param>
        public void Startle(Vector3 from)
        {
            if (OuterBounds.Hold(from, OuterBounds.Distance))
                (m_FrightenedBy, m_Fright) = (from, k_FrightTime);
            else
                Plan.TakeOff();
        }

        /// <inheritdoc/>
        public override FlightCommand Command(in FlightSituation situation)
        {
            PerchSettings settings = m_Settings.Clamped();
            m_SinceLook += situation.deltaTime;
            if (m_SinceLook >= k_LookTime)
                Look(situation, settings);
            Follow(situation.deltaTime);
            FlightCommand between = default;
            if (Plan.Stage == PerchStage.Between)
                between = Below() is { } below && below != null ? below.Command(situation) : FlightCommand.Fly(default);
            FlightCommand command = Plan.Next(situation, settings, m_Fright > 0f ? m_FrightenedBy : m_Threat, between);
            m_Fright = math.max(m_Fright - situation.deltaTime, 0f);
            m_IsSeated = situation.state == FlightState.Perched;
            if (Plan.Stage == PerchStage.Between || Plan.Stage == PerchStage.TakingOff)
                Leave();
            FoldWings(situation, settings);
            return command;
        }

        /// <summary>Height of the centre of mass over the feet, metres of the insect.</summary>
        private float Stand => -(Wings == null || Wings.Preset == null ? PresetRest.Default : Wings.Preset.Rest).feet.y;

        private InsectWings Wings
        {
            get
            {
                if (m_Wings == null)
                    m_Wings = GetComponentInParent<InsectWings>();
                return m_Wings;
            }
        }

        private void Look(in FlightSituation situation, in PerchSettings settings)
        {
            m_SinceLook = 0f;
            m_Threat = float.NaN;
            foreach (Transform watched in m_Watched)
            {
                if (watched != null && math.distance(watched.position, situation.position) < settings.fleeDistance)
                    m_Threat = watched.position;
            }

            if (Plan.WantsSpot)
                LookForSpot(situation, settings);
        }

        private void LookForSpot(in FlightSituation situation, in PerchSettings settings)
        {
            var mark = PerchMark.FindNearest(situation.position, settings.searchDistance, m_Last);
            if (mark != null)
                LandOn(mark);
            else if (settings.landsOnSurfaces && FindSurface(situation, settings, out PerchSpot spot, out Collider surface) && LandOn(spot))
                m_Surface = surface;
        }

        private void OnCollisionEnter(Collision collision) => Touched(collision.collider);

        private void OnTriggerEnter(Collider other) => Touched(other);

        /// <summary>Tells the insect that a collider touches it.</summary>
        internal void Touched(Collider by)
        {
            if (!isActiveAndEnabled || Stage != PerchStage.Perched || BelongsToPerch(by))
                return;
            if (!m_IsSeated && m_Mark == null && m_Surface == null)
                m_Surface = by;
            else if (m_IsSeated && m_Settings.leavesWhenTouched)
                Startle(by.transform.position);
        }

        // What it sits on, and the insect itself.
        private bool BelongsToPerch(Collider by)
        {
            Transform touching = by.transform;
            bool isMark = m_Mark != null && (touching.IsChildOf(m_Mark.transform) || m_Mark.transform.IsChildOf(touching));
            return isMark || by == m_Surface || touching.IsChildOf(Wings == null ? transform : Wings.transform);
        }

        // What is gone from under an insect lets it fly off; what it leaves moves on below it.
        private void Follow(float deltaTime)
        {
            if (!(m_Mark is null) && m_Mark == null)
            {
                m_Mark = null;
                Plan.TakeOff();
            }

            if (TryFindPerch(out PerchSpot spot))
                Plan.Follow(spot, deltaTime);
        }

        /// <inheritdoc/>
        internal override bool TryFindPerch(out PerchSpot spot)
        {
            bool isUnder = Stage != PerchStage.Between && m_Last != null;
            spot = isUnder ? m_Last.Spot : default;
            return isUnder && spot.IsPossible;
        }

        // Ahead and down: a place that the insect can turn to.
        private static bool FindSurface(
            in FlightSituation situation, in PerchSettings settings, out PerchSpot spot, out Collider surface)
        {
            var ahead = new Vector3(Elementary.Sin(situation.heading), -1f, Elementary.Cos(situation.heading));
            spot = default;
            surface = null;
            if (!Physics.Raycast(
                situation.position, ahead, out RaycastHit hit, settings.searchDistance, settings.surfaces, QueryTriggerInteraction.Ignore))
            {
                return false;
            }
            surface = hit.collider;
            spot = new PerchSpot { position = hit.point, normal = hit.normal, heading = situation.heading };
            return Vector3.Angle(hit.normal, Vector3.up) <= settings.steepest;
        }

        private void FoldWings(in FlightSituation situation, in PerchSettings settings)
        {
            m_Rest.Step(situation.deltaTime, situation.state == FlightState.Perched && Plan.Stage == PerchStage.Perched, settings);
            if (Wings != null)
                Wings.Steering.fold = m_Rest.Fold;
        }

        private void Leave()
        {
            if (m_Mark == null)
                return;
            if (m_Mark.Guest == this)
                m_Mark.Guest = null;
            m_Mark = null;
        }

        private void OnDisable()
        {
            Leave();
            m_Plan = null;
            m_Surface = null;
            m_Fright = 0f;
            m_IsSeated = false;
            m_Rest = default;
            if (m_Wings != null)
                m_Wings.Steering.fold = 0f;
        }
    }
}
