using System.Collections;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>An insect that flies off a perch has forgotten how it came there.</summary>
    public sealed class PerchStartTests : FlightFixture
    {
        /// <summary>World units a second: 4 m/s, which clips the commands of the last beats before the perch.</summary>
        private const float k_Gust = 40f;

        [UnityTest]
        public IEnumerator AfterAGust_ASwallowtailThatSat_FliesOff([Values(0, 2)] int from) => FliesOff(from, 1f);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AfterAGust_ASwallowtailThatSatForLong_FliesOff([Values(0, 1, 2, 3)] int from, [Values(1f, 4f)] float sat) =>
            FliesOff(from, sat);

        private IEnumerator FliesOff(int from, float sat)
        {
            Time.captureDeltaTime = 0.01f;
            InsectFlight flight = Hatch("swallowtail");
            var pilot = new Percher();
            flight.Pilot = pilot;
            yield return Frames(50);
            math.sincos(0.5f * math.PI * from, out float sin, out float cos);
            flight.GetComponent<InsectWings>().Air.wind = k_Gust * new float3(sin, 0f, cos);
            yield return Frames(12);
            flight.GetComponent<InsectWings>().Air.wind = default;
            pilot.spot = new PerchSpot
            {
                position = (float3)flight.Position
                - new float3(0f, 0.6f, 0f),
                normal = new float3(0f, 1f, 0f),
                heading = 0f
            };
            pilot.sits = true;
            yield return Frames((int)(100f * sat) + 100);
            Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
            pilot.sits = false;
            for (int frame = 0; frame < 200; frame++)
            {
                yield return null;
                Assert.That(flight.State, Is.Not.EqualTo(FlightState.Tumbling), $"{0.01f * frame:0.00} s after the start");
            }
        }

        private sealed class Percher : IFlightPilot
        {
            public PerchSpot spot;
            public bool sits;

            public FlightCommand Command(in FlightSituation situation) => sits
                ? new FlightCommand { wish = FlightWish.Perch, spot = spot, heading = spot.heading }
                : FlightCommand.Fly(new float3(0f, 0f, 0.5f));
        }
    }
}
