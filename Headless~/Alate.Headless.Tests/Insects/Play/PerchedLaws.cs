using System.Collections;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>An insect that sits: what moves it, and what its pilot forgets; and the phase at which it begins to fly.</summary>
    public sealed class PerchedLaws : FlightFixture
    {
        private const float k_Unit = InsectDefinition.UnitsPerMetre;

        [SetUp]
        public void StepOnceAFrame() => Time.captureDeltaTime = Time.fixedDeltaTime;

        // A contact that shifts its Rigidbody by less than a wing moves nothing; one that throws it farther is somebody who places it.
        [UnityTest]
        public IEnumerator ASittingInsect_StaysWhereContactsShiftIt_AndGoesWhereItIsPut([Values(0.3f, 3f)] float wings)
        {
            InsectFlight flight = Hatch();
            Rigidbody body = flight.gameObject.AddComponent<Rigidbody>();
            flight.Pilot = new Sitter { spot = new PerchSpot { position = flight.Position - 0.6f * Vector3.up, normal = Vector3.up } };
            yield return Frames(150);
            Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
            Vector3 seat = flight.transform.position, moved = wings * 0.06f * k_Unit * Vector3.right;
            body.position += moved;
            yield return Frames(2);
            Vector3 way = flight.transform.position - seat;
            Assert.That((way - (wings > 1f ? moved : Vector3.zero)).magnitude, Is.LessThan(0.02f * k_Unit));
        }

        [UnityTest]
        public IEnumerator APerchPilotThatIsSwitchedOff_ForgetsItsFold()
        {
            InsectFlight flight = Hatch();
            PerchPilot pilot = flight.gameObject.AddComponent<PerchPilot>();
            yield return Frames(2);
            pilot.LandOn(new PerchSpot { position = flight.Position + new Vector3(0f, -0.8f, 4f), normal = Vector3.up });
            for (int frame = 0; frame < 1500 && !(pilot.Fold > 0.9f); frame++)
                yield return null;
            Assert.That(pilot.Fold, Is.GreaterThan(0.9f), "it sits with closed wings");
            pilot.enabled = false;
            Assert.That((pilot.Fold, flight.GetComponent<InsectWings>().Steering.fold), Is.EqualTo((0f, 0f)));
        }

        [UnityTest]
        public IEnumerator AFlight_BeginsAtThePhaseOfTheInsect([Values(0f, 90f, 270f)] float degrees)
        {
            InsectFlight flight = Hatch();
            InsectWings insect = flight.GetComponent<InsectWings>();
            insect.StartPhase = degrees;
            insect.UpdateMode = WingUpdateMode.Manual;
            yield return Frames(2);
            for (int wing = 0; wing < 2; wing++)
                Assert.That(math.degrees(insect.Read(wing).Phase), Is.EqualTo(degrees).Within(1f));
        }

        private sealed class Sitter : IFlightPilot
        {
            public PerchSpot spot;

            public FlightCommand Command(in FlightSituation situation) =>
                new FlightCommand { wish = FlightWish.Perch, spot = spot, heading = spot.heading };
        }
    }
}
