using Alate.Flight;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Play.Flight
{
    /// <summary>Wings know the flight that carries them for as long as it is enabled.</summary>
    public sealed class FlightLinkTests : PlayFixture
    {
        [Test]
        public void WingsHaveAFlyer_WhileTheFlightIsEnabled()
        {
            GameObject insect = Keep(new GameObject("insect"));
            insect.SetActive(false);
            InsectWings wings = insect.AddComponent<InsectWings>();
            wings.enabled = false;
            InsectFlight flight = insect.AddComponent<InsectFlight>();
            insect.SetActive(true);
            Assert.That(wings.Flyer, Is.Not.Null);

            flight.enabled = false;
            Assert.That(wings.Flyer, Is.Null);

            flight.enabled = true;
            Assert.That(wings.Flyer, Is.Not.Null, "enabled again");
        }
    }
}
