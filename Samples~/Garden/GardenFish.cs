using Alate.Catalogue;
using Alate.Flight;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>A snailfish that swims round the garden by its own fins: its pilot keeps it on a circle at a depth.</summary>
    internal sealed class GardenFish : IFlightPilot
    {
        /// <summary>Middle of its path, world units from the middle of the garden, and depth.</summary>
        private const float k_Radius = 20f, k_Depth = -3f;

        /// <summary>Metres per second of the real fish, and how slowly it gets there, m/s².</summary>
        private const float k_Speed = 0.2f, k_Start = 0.02f;

        /// <summary>Rate at which it gets back to its path, 1/s, and fastest, m/s.</summary>
        private const float k_Rate = 0.15f, k_Aside = 0.03f;

        private readonly InsectWings m_Fins;
        private readonly Transform m_Parent;
        private float m_Speed;

        /// <param name="parent">Of the fish.</param>
        public GardenFish(Transform parent)
        {
            InsectDefinition snailfish = InsectCatalogue.Find("snailfish");
            m_Parent = parent;
            m_Fins = InsectFactory.Create(snailfish, InsectVariant.Flight);
            m_Fins.transform.SetParent(parent, false);
            m_Fins.transform.localPosition = new Vector3(-k_Radius, k_Depth, 0f);
            CatalogueFlight.AddTo(m_Fins, snailfish).Pilot = this;
        }

        /// <inheritdoc/>
        public FlightCommand Command(in FlightSituation situation)
        {
            // Fish start slowly: water carries them, but their fins push little.
            m_Speed = Mathf.Min(m_Speed + k_Start * situation.deltaTime, k_Speed);
            float3 off = situation.position - (float3)m_Parent.position;
            float2 outward = math.normalizesafe(off.xz, new float2(-1f, 0f));
            var way = new float2(outward.y, -outward.x);
            float back = math.clamp(k_Rate * (k_Radius - math.length(off.xz)) / situation.unitsPerMetre, -k_Aside, k_Aside);
            float up = math.clamp(k_Rate * (k_Depth - off.y) / situation.unitsPerMetre, -k_Aside, k_Aside);
            float2 along = m_Speed * way + back * outward;
            return FlightCommand.Fly(new float3(along.x, up, along.y), math.atan2(way.x, way.y));
        }

        /// <summary>Ends the fish.</summary>
        public void Destroy() => Object.Destroy(m_Fins.gameObject);
    }
}
