using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Play
{
    /// <summary>Acts of users on insects that fly.</summary>
    public sealed class FlightActsTests : FlightFixture
    {
        private readonly Dictionary<string, FlightTrims> m_Trims = new Dictionary<string, FlightTrims>();

        [SetUp]
        public void LookAside()
        {
            Camera camera = Keep(new GameObject("camera")).AddComponent<Camera>();
            WingSystem.DetailCameras.Add(camera);
        }

        [TearDown]
        public void LetTimeRun() => Time.timeScale = 1f;

        [UnityTest]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public IEnumerator RandomActs_HarmNobody() => Act(150, 7);

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
                {
                    flights.Add(Hatch(species[random.NextInt(species.Length)]));
                    m_Trims[flights[^1].name] = flights[^1].Trims;
                }

                int at = random.NextInt(flights.Count);
                if (Do(random.NextInt(20), flights[at], ref random))
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

        private bool Do(int act, InsectFlight flight, ref Random random)
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
                case 10:
                    flight.Aid = random.NextInt(5) == 0 ? float.NaN : random.NextFloat();
                    break;
                case 11:
                    flight.Trims = flight.Trims == null ? m_Trims[flight.name] : random.NextBool() ? null : m_Trims.Values.First();
                    break;
                case 12:
                    if (flight.TryGetComponent(out Rigidbody body))
                        Object.Destroy(body);
                    else
                        flight.gameObject.AddComponent<Rigidbody>().isKinematic = random.NextBool();
                    break;
                case 13:
                    if (flight.TryGetComponent(out FlightPilot pilot))
                        Object.Destroy(pilot);
                    else
                        AddPilot(flight.gameObject, random.NextInt(4));
                    break;
                case 14:
                    if (flight.TryGetComponent(out PerchPilot percher))
                    {
                        percher.LandOn(new PerchSpot
                        {
                            position = random.NextInt(5) == 0
                            ? float.NaN
                            : random.NextFloat3(-5f, 5f),
                            normal = random.NextFloat3Direction()
                        });
                    }
                    break;
                case 15:
                    if (flight.TryGetComponent(out FollowPilot follower))
                    {
                        follower.GoTo(
                            random.NextInt(5) == 0 ? new Vector3(0f, float.PositiveInfinity, 0f) : (Vector3)random.NextFloat3(-20f, 20f));
                    }
                    break;
                case 16:
                    flight.GetComponent<InsectWings>().UpdateMode = (WingUpdateMode)random.NextInt(4);
                    break;
                case 17:
                    InsectWings rebuilt = flight.GetComponent<InsectWings>();
                    if (random.NextBool())
                        rebuilt.Rebuild();
                    else
                        rebuilt.Quality.patches = random.NextInt(24, 80);
                    break;
                case 18:
                    flight.GetComponent<InsectWings>().Air.wind = random.NextFloat3(-20f, 20f);
                    break;
                default:
                    flight.GetComponent<InsectWings>().Quality.culling = (WingCulling)random.NextInt(3);
                    break;
            }

            return false;
        }

        private static void AddPilot(GameObject insect, int kind)
        {
            if (kind == 0)
                insect.AddComponent<PerchPilot>();
            else if (kind == 1)
                insect.AddComponent<FollowPilot>();
            else if (kind == 2)
                insect.AddComponent<FlockPilot>();
            else
                insect.AddComponent<WanderPilot>().StayAroundStart();
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
