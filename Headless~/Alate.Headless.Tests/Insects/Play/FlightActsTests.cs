using System.Collections;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Play
{
    /// <summary>What users do to insects that fly.</summary>
    public sealed class FlightActsTests : FlightFixture
    {
        [TearDown]
        public void LetTimeRun() => Time.timeScale = 1f;

        [UnityTest]
        public IEnumerator RandomActs_HarmNobody() => Act(300, 7);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator FiveThousandRandomActs_HarmNobody() => Act(5000, 1);

        [UnityTest]
        public IEnumerator WithTimeAtRest_AnInsectStandsInTheAir_AndFliesOn()
        {
            InsectFlight flight = Hatch();
            yield return Frames(60);
            Time.timeScale = 0f;
            yield return Frames(2);
            Vector3 place = flight.transform.position;
            yield return Frames(30);
            Assert.That(flight.transform.position, Is.EqualTo(place));
            Time.timeScale = 1f;
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.transform.position, Is.Not.EqualTo(place));
        }

        [UnityTest]
        public IEnumerator FromAPool_AnInsectFliesAnew_WhereItIsPut()
        {
            InsectFlight flight = Hatch();
            yield return Frames(60);
            flight.gameObject.SetActive(false);
            yield return Frames(10);
            var place = new Vector3(30f, 5f, 10f);
            flight.transform.position = place;
            flight.gameObject.SetActive(true);
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(10f));
        }

        private IEnumerator Act(int acts, uint seed)
        {
            var random = new Random(seed);
            var flights = new List<InsectFlight>();
            string[] species = ["monarch", "firefly", "fishfly"];
            for (int act = 0; act < acts; act++)
            {
                if (flights.Count < 4)
                    flights.Add(Hatch(species[random.NextInt(species.Length)]));
                int at = random.NextInt(flights.Count);
                if (Do(random.NextInt(11), flights[at], ref random))
                    flights.RemoveAt(at);
                yield return null;
                foreach (InsectFlight flight in flights)
                    Assert.That(math.all(math.isfinite((float3)flight.transform.position)), $"act {act}");
            }

            foreach (InsectFlight flight in flights)
                Object.Destroy(flight.gameObject);
            yield return Frames(3);
            Assert.That(WingSystem.InsectCount, Is.Zero);
        }

        private static bool Do(int act, InsectFlight flight, ref Random random)
        {
            switch (act)
            {
                case 0:
                    flight.enabled = !flight.enabled;
                    break;
                case 1:
                    flight.gameObject.SetActive(!flight.gameObject.activeSelf);
                    break;
                case 2:
                    InsectWings wings = flight.GetComponent<InsectWings>();
                    wings.enabled = !wings.enabled;
                    break;
                case 3:
                    Object.Destroy(flight.gameObject);
                    return true;
                case 4:
                    flight.transform.position = random.NextFloat3(-50f, 50f);
                    break;
                case 5:
                    flight.transform.localScale = random.NextFloat(0.1f, 3f) * Vector3.one;
                    break;
                case 6:
                    flight.transform.rotation = random.NextQuaternionRotation();
                    break;
                case 7:
                    flight.Pilot = random.NextBool() ? new Waverer { spot = random.NextFloat3(-5f, 5f), sits = random.NextBool() } : null;
                    break;
                case 8:
                    flight.Velocity = random.NextInt(5) == 0 ? new Vector3(float.NaN, 0f, 0f) : (Vector3)random.NextFloat3(-2f, 2f);
                    break;
                case 9:
                    Time.timeScale = random.NextInt(4) == 0 ? 0f : random.NextFloat(0.2f, 2f);
                    break;
                default:
                    flight.Aid = random.NextFloat();
                    break;
            }

            return false;
        }

        private sealed class Waverer : IFlightPilot
        {
            public bool sits;
            public float3 spot;

            public FlightCommand Command(in FlightSituation situation)
            {
                var command = FlightCommand.Fly(default);
                command.wish = sits ? FlightWish.Perch : FlightWish.Fly;
                command.spot = new PerchSpot { position = spot, normal = Vector3.up, heading = 1f };
                return command;
            }
        }
    }
}
