using System;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Visit of one insect to a slope: its flight there, its stay and its start, with the heights of wings, body and feet over the slope.
    /// </summary>
    internal sealed class PerchVisit
    {
        /// <summary>Seconds within which an insect has landed, sits, its wings folded or basking, and is away.</summary>
        private const float k_Landing = 60f, k_Sitting = 3f, k_Leaving = 1.5f;

        /// <summary>Seconds after which the wings of an insect that sits are folded.</summary>
        private const float k_Folding = 0.7f;

        /// <summary>Distance from the spot within which the wings are looked at, wing lengths.</summary>
        private const float k_Near = 4f;

        private readonly Vector3[] m_Body;
        private readonly Vector3 m_Feet;
        private readonly float m_WingLength, m_BodyLength;
        private readonly InsectWings m_Wings;
        private readonly PerchPilot m_Pilot;
        private PerchSpot m_Place;
        private PerchMark m_Mark;
        private Vector3 m_Before;
        private Stage m_Stage;
        private float m_Time;

        public PerchVisit(int seed, InsectFlight flight, InsectDefinition species, WingPreset preset)
        {
            Seed = seed;
            Flight = flight;
            m_Wings = flight.GetComponent<InsectWings>();
            m_Pilot = flight.GetComponent<PerchPilot>();
            m_Body = Array.ConvertAll(species.Body.CreateSurface(1f).positions, place => InsectDefinition.UnitsPerMetre * place);
            m_Feet = InsectDefinition.UnitsPerMetre * preset.Rest.feet;
            m_WingLength = InsectDefinition.UnitsPerMetre * preset.WingLength;
            m_BodyLength = m_Body.Max(place => place.z) - m_Body.Min(place => place.z);
        }

        private enum Stage
        {
            Landing,
            Sitting,
            Leaving,
            Over,
        }

        public int Seed { get; }

        public InsectFlight Flight { get; }

        public bool IsOver => m_Stage == Stage.Over;

        /// <summary>True where the insect tumbled on the way to the slope, which ends the visit.</summary>
        public bool HasTumbled { get; private set; }

        public float LowestOfWings { get; private set; } = float.PositiveInfinity;

        public float FeetOffSpot { get; private set; }

        /// <summary>Speed of the last step before the spot, m/s.</summary>
        public float LastSpeed { get; private set; }

        private PerchSpot Spot => m_Mark != null ? m_Mark.Spot : m_Place;

        // From the spot; from one that moves as it is drawn.
        private Vector3 Off => (m_Mark != null ? Flight.transform.position : Flight.Position) - (Vector3)Spot.position;

        public void Begin(in PerchSpot spot)
        {
            m_Place = spot;
            m_Before = Off;
            Assert.That(m_Pilot.LandOn(spot), $"spot {Seed}");
        }

        /// <summary>Begins a visit to a mark that moves.</summary>
        public void Begin(PerchMark mark)
        {
            m_Mark = mark;
            m_Before = Off;
            Assert.That(m_Pilot.LandOn(mark), $"mark {Seed}");
        }

        /// <summary>Measures a frame, and asserts what must hold in it.</summary>
        public void Add(float step)
        {
            if (IsOver)
                return;
            m_Time += step;
            MeasureWings();
            if (m_Stage == Stage.Landing)
                Land(step);
            else if (m_Stage == Stage.Sitting)
                Sit();
            else
                Leave();
            m_Before = Off;
        }

        private void Land(float step)
        {
            Assert.That(m_Time, Is.LessThan(k_Landing), $"spot {Seed}: seconds to land");
            if (Flight.State == FlightState.Tumbling)
            {
                HasTumbled = true;
                Enter(Stage.Over);
            }
            else if (Flight.State == FlightState.Perched)
            {
                // A position is that of a fixed step, and the same in all frames of one; what is drawn moves in each frame.
                float since = m_Mark != null ? step : math.max(step, Time.fixedDeltaTime);
                LastSpeed = (Off - m_Before).magnitude / (InsectDefinition.UnitsPerMetre * since);
                Assert.That(LastSpeed, Is.LessThan(0.3f), $"spot {Seed}: m/s");
                Enter(Stage.Sitting);
            }
        }

        private void Sit()
        {
            Assert.That(Flight.State, Is.EqualTo(FlightState.Perched), $"spot {Seed}");
            if (m_Time > k_Folding)
            {
                FeetOffSpot = math.max(FeetOffSpot, math.distance(Flight.transform.TransformPoint(m_Feet), Spot.position));
                float lowest = m_Body.Min(place => Height(Flight.transform.TransformPoint(place)));
                Assert.That(FeetOffSpot, Is.LessThan(0.01f * m_BodyLength), $"spot {Seed}: feet");
                Assert.That(
                    Math.Abs(lowest), Is.LessThan(0.01f * m_BodyLength), $"spot {Seed}: the body's lowest point is that of its feet");
            }

            if (m_Time <= k_Sitting)
                return;
            m_Pilot.TakeOff();
            Enter(Stage.Leaving);
        }

        private void Leave()
        {
            Assert.That(Flight.State, Is.Not.EqualTo(FlightState.Tumbling), $"spot {Seed}: {m_Time:0.00} s after the start");
            if (m_Time <= k_Leaving)
                return;
            Assert.That(Flight.State, Is.EqualTo(FlightState.Flying), $"spot {Seed}");
            Assert.That(
                math.distance(Flight.Position, Spot.position), Is.GreaterThan(0.5f * m_BodyLength + m_WingLength), $"spot {Seed}: away");
            Assert.That(LowestOfWings, Is.GreaterThan(0f), $"spot {Seed}: wings");
            Enter(Stage.Over);
        }

        private void Enter(Stage stage)
        {
            m_Stage = stage;
            m_Time = 0f;
        }

        private void MeasureWings()
        {
            if (math.distance(Flight.Position, Spot.position) > k_Near * m_WingLength)
                return;
            foreach (Wing wing in m_Wings.Wings)
            {
                Matrix4x4 place = wing.Renderer.transform.localToWorldMatrix;
                foreach (Vector3 vertex in wing.Renderer.GetComponent<MeshFilter>().sharedMesh.vertices)
                {
                    Vector3 at = place.MultiplyPoint3x4(vertex);
                    if (IsOverIt(at))
                        LowestOfWings = math.min(LowestOfWings, Height(at));
                }
            }
        }

        // A slope has no end; a flower is as wide as the wings, and may later rise beside an insect that has left it.
        private bool IsOverIt(Vector3 place)
        {
            float3 off = (float3)place - Spot.position;
            return m_Mark == null || math.length(off - math.dot(off, Spot.normal) * Spot.normal) < m_WingLength;
        }

        private float Height(Vector3 place) => math.dot((float3)place - Spot.position, Spot.normal);
    }
}
