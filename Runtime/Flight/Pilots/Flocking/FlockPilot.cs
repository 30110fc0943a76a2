using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Flies with its neighbours: keeps apart, flies as they fly, and to their middle. The pilot below this one on the object gives the
    /// way; without one the insect flies on.
    /// </summary>
    [AddComponentMenu("Alate/Flock Pilot")]
    [DisallowMultipleComponent]
    public sealed class FlockPilot : FlightPilot
    {
        /// <summary>Fastest flight over the wanted speed.</summary>
        private const float k_Hurry = 1.3f;

        [SerializeField]
        private FlockSettings m_Settings = FlockSettings.Default;

        [SerializeField]
        private ObstacleSettings m_Obstacles = ObstacleSettings.Default;

        /// <summary>Settings of the flight among others.</summary>
        public ref FlockSettings Settings => ref m_Settings;

        /// <summary>Settings by which the insect avoids colliders in its way.</summary>
        public ref ObstacleSettings Obstacles => ref m_Obstacles;

        /// <summary>Neighbours of the same group that the insect sees.</summary>
        public int NeighbourCount => View.count;

        internal FlockMember Member { get; private set; }

        internal FlockView View { get; set; }

        /// <inheritdoc/>
        public override FlightCommand Command(in FlightSituation situation)
        {
            FlockSettings settings = m_Settings.Clamped();
            float unit = situation.unitsPerMetre;
            Flock.Update();
            Member = new FlockMember
            {
                position = situation.position,
                velocity = situation.referenceVelocity * unit,
                sight = settings.sight * situation.wingLength * unit,
                room = settings.room * situation.wingLength * unit,
                group = settings.group,
            };

            FlightPilot below = Below();
            float3 own = below != null
                ? below.Command(situation).velocity
                : settings.speed * math.normalizesafe(situation.referenceVelocity, Ahead(situation.heading));
            float speed = math.max(math.length(own), 0.3f);
            float3 wanted = own + settings.separation * speed * View.apart;
            if (View.count > 0)
            {
                wanted += settings.alignment * (View.velocity / unit - situation.referenceVelocity);
                wanted += settings.cohesion * speed * math.clamp((View.centre - situation.position) / Member.sight, -1f, 1f);
            }

            wanted = math.normalizesafe(wanted) * math.min(math.length(wanted), k_Hurry * speed);
            return FlightCommand.Fly(Avoid(wanted, situation, m_Obstacles));
        }

        private static float3 Ahead(float heading) => new float3(Elementary.Sin(heading), 0f, Elementary.Cos(heading));

        private void OnEnable()
        {
            // Out of everybody's sight until it was asked for its first command.
            Member = new FlockMember { position = 1e6f * new float3(1f, 1f, 1f), group = int.MinValue };
            View = default;
            Flock.Enter(this);
        }

        private void OnDisable() => Flock.Leave(this);
    }
}
