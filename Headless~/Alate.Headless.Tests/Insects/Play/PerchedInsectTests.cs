using System;
using System.Collections;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Play
{
    /// <summary>Insects of the catalogue fly to slopes, sit on them with their feet on the spot, and fly off; no wing passes through the slope.</summary>
    public sealed class PerchedInsectTests : PlayFixture
    {
        /// <summary>Seconds within which an insect has landed, sits, its wings folded or basking, and is away.</summary>
        private const float k_Landing = 60f, k_Sitting = 3f, k_Leaving = 1.5f;

        /// <summary>Seconds after which the wings of an insect that sits are folded.</summary>
        private const float k_Folding = 0.7f;

        /// <summary>Distance from the spot within which the wings are looked at, wing lengths.</summary>
        private const float k_Near = 4f;

        [UnityTest]
        public IEnumerator OnASlope_AnInsectSits_AndNoWingIsBelowIt([Values("monarch", "swallowtail", "firefly")] string name) => Perch(name, 0.02f, 1);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator OnFiftySlopes_AnInsectSits_AndNoWingIsBelowThem(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string name, [Values(0.01f, 0.02f)] float step) => Perch(name, step, 50);

        private IEnumerator Perch(string name, float step, int count)
        {
            Time.captureDeltaTime = step;
            InsectDefinition species = InsectCatalogue.Find(name);
            WingPreset preset = species.Wings[0].CreatePreset();
            var measure = new PerchMeasure(species, preset);
            float fastest = 0f, lowest = float.PositiveInfinity, offSpot = 0f;
            for (int k = 1; k <= count; k++)
            {
                InsectFlight flight = Hatch(species);
                PerchPilot pilot = flight.GetComponent<PerchPilot>();
                yield return Frames(20);
                PerchSpot spot = SlopeBelow(flight, Random.CreateFromIndex((uint)k));
                Assert.That(pilot.LandOn(spot));
                measure.Begin(flight, spot);
                Vector3 before = flight.Position;
                for (int frame = 0; frame < k_Landing / step && flight.State != FlightState.Perched; frame++)
                {
                    measure.Add();
                    before = flight.Position;
                    yield return null;
                }

                Assert.That(flight.State, Is.EqualTo(FlightState.Perched), $"spot {k}, after {k_Landing} s");
                fastest = math.max(fastest, (flight.Position - before).magnitude / (InsectDefinition.UnitsPerMetre * step));
                for (int frame = 0; frame < k_Sitting / step; frame++)
                {
                    yield return null;
                    measure.Add();
                    if (frame < k_Folding / step)
                        continue;
                    offSpot = math.max(offSpot, measure.FeetOffSpot());
                    Assert.That(Math.Abs(measure.LowestOfBody()), Is.LessThan(0.01f * measure.BodyLength), $"spot {k}: the body's lowest point is that of its feet");
                }

                Assert.That(flight.State, Is.EqualTo(FlightState.Perched), $"spot {k}");
                pilot.TakeOff();
                for (int frame = 0; frame < k_Leaving / step; frame++)
                {
                    yield return null;
                    measure.Add();
                }

                Assert.That(flight.State, Is.EqualTo(FlightState.Flying), $"spot {k}");
                Assert.That(math.distance(flight.Position, spot.position), Is.GreaterThan(0.5f * measure.BodyLength + preset.WingLength), $"spot {k}: away");
                Assert.That(measure.LowestOfWings, Is.GreaterThan(0f), $"spot {k}: wings");
                lowest = math.min(lowest, measure.LowestOfWings);
                UnityEngine.Object.Destroy(flight.gameObject);
                yield return null;
            }

            TestContext.Out.WriteLine(FormattableString.Invariant(
                $"{name}, {step} s: lowest wing {100f * lowest:0.0} mm over {count} slopes, feet {100f * offSpot:0.000} mm off, {fastest:0.00} m/s in the last step before the spot"));
            Assert.That(offSpot, Is.LessThan(0.01f * measure.BodyLength), "feet");
            Assert.That(fastest, Is.LessThan(0.3f), "m/s");
        }

        // Within a metre of the insect, as a slope that it is above.
        private static PerchSpot SlopeBelow(InsectFlight flight, Random random)
        {
            float slope = math.radians(random.NextFloat(0f, 45f)), way = random.NextFloat(0f, 2f * math.PI), from = random.NextFloat(0f, 2f * math.PI);
            var normal = new float3(math.sin(slope) * math.sin(way), math.cos(slope), math.sin(slope) * math.cos(way));
            float3 off = new float3(math.sin(from), 0f, math.cos(from)) * random.NextFloat(0f, 1.2f) + new float3(0f, random.NextFloat(0.35f, 0.8f), 0f);
            off -= math.min(math.dot(off, normal) - 0.3f, 0f) * normal;
            return new PerchSpot
            {
                position = (float3)flight.Position - InsectDefinition.UnitsPerMetre * off,
                normal = normal,
                heading = random.NextFloat(-math.PI, math.PI),
            };
        }

        private InsectFlight Hatch(InsectDefinition species)
        {
            InsectWings wings = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            PerchPilot pilot = wings.gameObject.AddComponent<PerchPilot>();
            pilot.Seed = 1;
            pilot.Settings.flightTime = pilot.Settings.stayTime = 600f;
            return CatalogueFlight.AddTo(wings, species);
        }

        /// <summary>Heights over a slope of an insect's wings, body and feet, world units.</summary>
        private sealed class PerchMeasure
        {
            private readonly Vector3[] m_Body;
            private readonly Vector3 m_Feet;
            private readonly float m_WingLength;
            private InsectFlight m_Flight;
            private InsectWings m_Wings;
            private PerchSpot m_Spot;

            public PerchMeasure(InsectDefinition species, WingPreset preset)
            {
                m_Body = Array.ConvertAll(species.Body.CreateSurface(1f).positions, place => InsectDefinition.UnitsPerMetre * place);
                m_Feet = InsectDefinition.UnitsPerMetre * preset.Rest.feet;
                m_WingLength = InsectDefinition.UnitsPerMetre * preset.WingLength;
                BodyLength = m_Body.Max(place => place.z) - m_Body.Min(place => place.z);
            }

            public float BodyLength { get; }

            public float LowestOfWings { get; private set; }

            public void Begin(InsectFlight flight, in PerchSpot spot)
            {
                m_Flight = flight;
                m_Wings = flight.GetComponent<InsectWings>();
                m_Spot = spot;
                LowestOfWings = float.PositiveInfinity;
            }

            public void Add()
            {
                if (math.distance(m_Flight.Position, m_Spot.position) > k_Near * m_WingLength)
                    return;
                for (int k = 0; k < m_Wings.Wings.Count; k++)
                {
                    Matrix4x4 place = m_Wings.Wings[k].Renderer.transform.localToWorldMatrix;
                    foreach (Vector3 vertex in Shown(m_Wings, k).vertices)
                        LowestOfWings = math.min(LowestOfWings, Height(place.MultiplyPoint3x4(vertex)));
                }
            }

            public float FeetOffSpot() => math.distance(m_Flight.transform.TransformPoint(m_Feet), m_Spot.position);

            public float LowestOfBody() => m_Body.Min(place => Height(m_Flight.transform.TransformPoint(place)));

            private float Height(Vector3 place) => math.dot((float3)place - m_Spot.position, m_Spot.normal);
        }
    }
}
