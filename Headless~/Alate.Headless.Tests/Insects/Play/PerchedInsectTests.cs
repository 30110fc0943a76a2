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
    /// <summary>Insects of the catalogue sit on slopes with their feet on the spot and their folded wings above it, and take off.</summary>
    public sealed class PerchedInsectTests : PlayFixture
    {
        private const float k_Step = 0.02f;

        /// <summary>Frames in which the body settles, turned by up to half a circle, and the wings fold; then the insect basks; then it takes off.</summary>
        private const int k_Settling = 60, k_Basking = 150, k_Leaving = 75;

        [UnityTest]
        public IEnumerator OnASlope_TheFeetAreOnTheSpot_NoWingIsBelowIt_AndTheInsectTakesOff([Values("monarch", "firefly")] string name) => Sit(name);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator OnASlope_AnyOtherInsect_SitsAsWell([Values("swallowtail", "fishfly", "painted-lichen-moth", "dragonfly")] string name) => Sit(name);

        private IEnumerator Sit(string name)
        {
            Time.captureDeltaTime = k_Step;
            InsectFlight flight = Hatch(name, out Sitter pilot);
            InsectDefinition species = InsectCatalogue.Find(name);
            Vector3[] body = species.Body.CreateSurface(1f).positions;
            float length = InsectDefinition.UnitsPerMetre * (body.Max(place => place.z) - body.Min(place => place.z));
            Vector3 feet = InsectDefinition.UnitsPerMetre * species.Wings[0].CreatePreset().Rest.feet;
            for (uint seed = 1; seed <= 3; seed++)
            {
                yield return Frames(20);
                PerchSpot spot = SlopeBelow(flight, Random.CreateFromIndex(seed), length);
                pilot.spot = spot;
                pilot.sits = true;
                float offSpot = 0f, lowestWing = float.PositiveInfinity, lowestBody = float.PositiveInfinity;
                for (int frame = 0; frame < k_Settling + k_Basking; frame++)
                {
                    yield return null;
                    if (frame < k_Settling)
                        continue;
                    offSpot = math.max(offSpot, math.distance(flight.transform.TransformPoint(feet), spot.position));
                    lowestWing = math.min(lowestWing, LowestWing(flight, spot));
                    lowestBody = math.min(lowestBody, body.Min(place => Height(spot, flight.transform.TransformPoint(InsectDefinition.UnitsPerMetre * place))));
                }

                Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
                Assert.That(offSpot, Is.LessThan(0.01f * length), "feet");
                Assert.That(Math.Abs(lowestBody), Is.LessThan(0.01f * length), "the body's lowest point is that of its feet");
                Assert.That(lowestWing, Is.GreaterThan(0f), "wings");

                pilot.sits = false;
                float lowest = float.PositiveInfinity, lowestTip = float.PositiveInfinity;
                for (int frame = 0; frame < k_Leaving; frame++)
                {
                    yield return null;
                    lowest = math.min(lowest, Height(spot, flight.Position));
                    lowestTip = math.min(lowestTip, LowestWing(flight, spot));
                }

                TestContext.Out.WriteLine(FormattableString.Invariant(
                    $"{name}: feet {100f * offSpot:0.000} mm off, lowest wing {100f * lowestWing:0.0} mm over the surface while it sits, {100f * lowestTip:0.0} mm when it leaves, lowest centre {100f * lowest:0.0} mm"));
                Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
                Assert.That(lowest, Is.GreaterThan(-0.5f * InsectDefinition.UnitsPerMetre * species.Wings[0].CreatePreset(ModelReading.Physical, InsectVariant.Flight).WingLength), "hovering monarchs sink before they climb");
                Assert.That(math.distance(flight.Position, spot.position), Is.GreaterThan(length));
            }
        }

        private static PerchSpot SlopeBelow(InsectFlight flight, Random random, float length)
        {
            float slope = math.radians(random.NextFloat(0f, 45f)), way = random.NextFloat(0f, 2f * math.PI);
            return new PerchSpot
            {
                position = (float3)flight.Position - new float3(0f, 0.5f * length, 0f),
                normal = new float3(math.sin(slope) * math.sin(way), math.cos(slope), math.sin(slope) * math.cos(way)),
                heading = random.NextFloat(-math.PI, math.PI),
            };
        }

        private static float Height(in PerchSpot spot, Vector3 place) => math.dot((float3)place - spot.position, spot.normal);

        private static float LowestWing(InsectFlight flight, PerchSpot spot)
        {
            InsectWings wings = flight.GetComponent<InsectWings>();
            float lowest = float.PositiveInfinity;
            for (int k = 0; k < wings.Wings.Count; k++)
            {
                Matrix4x4 place = wings.Wings[k].Renderer.transform.localToWorldMatrix;
                foreach (Vector3 vertex in Shown(wings, k).vertices)
                    lowest = math.min(lowest, Height(spot, place.MultiplyPoint3x4(vertex)));
            }

            return lowest;
        }

        // The pilot sits at once where it is asked to; the wings fold and bask as Perch Pilot has them.
        private InsectFlight Hatch(string name, out Sitter sitter)
        {
            InsectDefinition species = InsectCatalogue.Find(name);
            InsectWings wings = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            InsectFlight flight = CatalogueFlight.AddTo(wings, species);
            flight.Pilot = sitter = new Sitter(wings);
            return flight;
        }

        private sealed class Sitter : IFlightPilot
        {
            private readonly InsectWings m_Wings;
            private WingRest m_Rest;

            public Sitter(InsectWings wings) => m_Wings = wings;

            public bool sits;
            public PerchSpot spot;

            public FlightCommand Command(in FlightSituation situation)
            {
                m_Rest.Step(situation.deltaTime, sits, PerchSettings.Default);
                m_Wings.Steering.fold = m_Rest.Fold;
                var ahead = new float3(math.sin(situation.heading), 0f, math.cos(situation.heading));
                FlightCommand command = sits ? FlightCommand.Fly(default) : FlightCommand.Fly(0.65f * math.normalizesafe(ahead + 1.2f * spot.normal * new float3(1f, 0f, 1f)) + new float3(0f, 0.3f, 0f));
                command = NoseFirst.Limit(command, situation);
                command.wish = sits ? FlightWish.Perch : FlightWish.Fly;
                command.spot = spot;
                return command;
            }
        }
    }
}
