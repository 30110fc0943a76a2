using System;
using System.Collections;
using System.Reflection;
using System.Text.RegularExpressions;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Pilots that come, go, and fail.</summary>
    public sealed class FlightPilotTests : FlightFixture
    {
        [UnityTest]
        public IEnumerator APilotThatThrows_IsToldOnce_AndTheOthersFlyOn()
        {
            InsectFlight flight = Hatch(), other = Hatch();
            Steered broken = flight.gameObject.AddComponent<Steered>();
            broken.fails = true;
            other.gameObject.AddComponent<Steered>().velocity = new float3(0f, 0f, 1f);
            LogAssert.Expect(LogType.Exception, new Regex("The pilot Steered of 'Monarch' threw an exception, and is asked no more.*"));
            yield return Frames(120);
            Assert.That(broken.asked, Is.EqualTo(1));
            Assert.That(flight.HasPilotFailed);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.transform.position.magnitude, Is.LessThan(5f));
            Assert.That(other.transform.position.z, Is.GreaterThan(5f));

            broken.fails = false;
            broken.velocity = new float3(0f, 0f, 1f);
            broken.enabled = false;
            yield return Frames(30);
            broken.enabled = true;
            yield return Frames(120);
            Assert.That(flight.HasPilotFailed, Is.False);
            Assert.That(flight.transform.position.z, Is.GreaterThan(5f));
        }

        [UnityTest]
        public IEnumerator APilotThatIsOff_IsNotAsked_TheNextOneSteers()
        {
            InsectFlight flight = Hatch();
            Steered first = flight.gameObject.AddComponent<Steered>(), second = flight.gameObject.AddComponent<Steered>();
            yield return Frames(30);
            Assert.That(flight.Pilot, Is.SameAs(first));
            first.enabled = false;
            int asked = first.asked;
            yield return Frames(30);
            Assert.That(first.asked, Is.EqualTo(asked));
            Assert.That(flight.Pilot, Is.SameAs(second));
            first.enabled = true;
            yield return Frames(30);
            Assert.That(flight.Pilot, Is.SameAs(first));
            UnityEngine.Object.Destroy(first);
            yield return Frames(3);
            Assert.That(flight.Pilot, Is.SameAs(second));
        }

        [UnityTest]
        public IEnumerator APilotThatAScriptSets_ComesBeforeComponents_WhileItIsOn()
        {
            InsectFlight flight = Hatch();
            Steered found = flight.gameObject.AddComponent<Steered>(), set = Keep(new GameObject("pilot")).AddComponent<Steered>();
            flight.Pilot = set;
            yield return Frames(30);
            Assert.That((found.asked, flight.Pilot), Is.EqualTo((0, (IFlightPilot)set)));
            set.enabled = false;
            yield return Frames(30);
            Assert.That(flight.Pilot, Is.SameAs(found));
            set.enabled = true;
            yield return Frames(3);
            Assert.That(flight.Pilot, Is.SameAs(set));
        }

        [UnityTest]
        public IEnumerator APilotThatComesLater_Steers()
        {
            InsectFlight flight = Hatch();
            yield return Frames(60);
            Assert.That(flight.Pilot, Is.Null);
            flight.gameObject.AddComponent<Steered>();
            yield return Frames(30);
            Assert.That(flight.Pilot, Is.Not.Null);
        }

        [UnityTest]
        public IEnumerator APilotMaySwitchInsectsOff_EvenItsOwn([Values] bool own)
        {
            InsectFlight flight = Hatch(), other = Hatch(), last = Hatch();
            yield return Frames(30);
            flight.gameObject.AddComponent<Steered>().ends = own ? flight.gameObject : other.gameObject;
            yield return Frames(60);
            Assert.That(flight.gameObject.activeSelf, Is.EqualTo(!own));
            Assert.That(other.gameObject.activeSelf, Is.EqualTo(own));
            Assert.That(last.State, Is.EqualTo(FlightState.Flying));
        }

        [UnityTest]
        public IEnumerator AListenerThatThrows_DoesNotKeepTheInsectFromSitting()
        {
            InsectFlight flight = Hatch();
            yield return Frames(30);
            flight.Landed += _ => throw new ArithmeticException("a listener");
            flight.Pilot = new Steerer { sits = true };
            LogAssert.Expect(LogType.Exception, new Regex("a listener"));
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
        }

        [UnityTest]
        public IEnumerator ASpotThatIsNoNumber_IsNotSatOn()
        {
            InsectFlight flight = Hatch();
            yield return Frames(30);
            flight.Pilot = new Steerer { sits = true, spot = new float3(0f, float.NaN, 0f) };
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(math.all(math.isfinite((float3)flight.transform.position)));
        }

        [UnityTest]
        public IEnumerator APerchedInsectThatIsMoved_SitsWhereItWasPut()
        {
            InsectFlight flight = Hatch();
            var pilot = new Steerer { sits = true, spot = new float3(1f, 2f, 3f) };
            flight.Pilot = pilot;
            yield return Frames(150);
            Vector3 place = flight.transform.position;
            flight.transform.SetPositionAndRotation(
                place + new Vector3(5f, 1f, 0f), Quaternion.Euler(0f, 90f, 0f) * flight.transform.rotation);
            Quaternion turned = flight.transform.rotation;
            yield return Frames(30);
            Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
            Assert.That((flight.transform.position - place - new Vector3(5f, 1f, 0f)).magnitude, Is.LessThan(1e-3f));
            Assert.That(Quaternion.Angle(flight.transform.rotation, turned), Is.LessThan(0.1f));
            pilot.sits = false;
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.GreaterThan(3f));
        }

        [UnityTest]
        public IEnumerator TrimsThatDoNotFit_AreToldOnce_AndCostNothing_UntilTheyFit()
        {
            InsectFlight flight = Hatch();
            FlightTrims trims = flight.Trims;
            flight.Trims = Hatch("firefly").Trims;
            LogAssert.Expect(LogType.Warning, new Regex("'Monarch' does not fly: its trims were made for other numbers"));
            yield return Frames(30);
            Assert.That(flight.Problem, Is.EqualTo(FlightProblem.OtherNumbers));
            FrameLoop loop = WingSystem.Loop;
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int round = 0; round < 10; round++)
                loop.FixedStep(0.02f);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);

            flight.Trims = trims;
            yield return Frames(30);
            Assert.That((flight.Problem, flight.State), Is.EqualTo((FlightProblem.None, FlightState.Flying)));
        }

        // A play that begins in the frame and at the time in which the last one looked, as without a reload of the domain.
        [UnityTest]
        public IEnumerator AFlock_LooksOnceAStep_AndForgetsAllAtTheEndOfAPlay()
        {
            var pilots = new FlockPilot[2];
            for (int k = 0; k < 2; k++)
            {
                InsectFlight flight = Hatch();
                flight.transform.position = new Vector3(0.5f * k, 0f, 0f);
                pilots[k] = flight.gameObject.AddComponent<FlockPilot>();
            }

            yield return Frames(10);
            Flock.Update();
            Assert.That(System.Array.ConvertAll(pilots, pilot => pilot.NeighbourCount), Is.EqualTo(new[] { 1, 1 }));
            pilots[0].View = default;
            Flock.Update();
            Assert.That(pilots[0].NeighbourCount, Is.Zero, "once a step");
            typeof(Flock).GetMethod("Forget", BindingFlags.NonPublic | BindingFlags.Static).Invoke(null, null);
            Assert.That(Flock.Pilots, Is.Empty);
            foreach (FlockPilot pilot in pilots)
                Flock.Enter(pilot);
            Flock.Update();
            Assert.That(pilots[0].NeighbourCount, Is.EqualTo(1), "it looks again");
        }

        [UnityTest]
        public IEnumerator ThePresetThatTrimsWereMadeFor_LetsAnInsectFly()
        {
            InsectFlight flight = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            WingPreset flown = wings.Preset;
            wings.Preset = Keep(UnityEngine.Object.Instantiate(flown));
            wings.Preset.Beat.maxFrequency *= 1.5f;
            LogAssert.Expect(LogType.Warning, new Regex("other numbers"));
            yield return Frames(30);
            wings.Preset = flown;
            yield return Frames(30);
            Assert.That((flight.Problem, flight.State), Is.EqualTo((FlightProblem.None, FlightState.Flying)));
        }

        private sealed class Steered : FlightPilot
        {
            public float3 velocity;
            public bool fails;
            public int asked;
            public GameObject ends;

            public override FlightCommand Command(in FlightSituation situation)
            {
                asked++;
                if (fails)
                    throw new ArithmeticException("lost");
                if (ends != null)
                    ends.SetActive(false);
                return FlightCommand.Fly(velocity);
            }

            private void OnEnable()
            {
            }
        }

        private sealed class Steerer : IFlightPilot
        {
            public bool sits;
            public float3 spot;

            public FlightCommand Command(in FlightSituation situation) => new FlightCommand
            {
                wish = sits ? FlightWish.Perch : FlightWish.Fly,
                spot = new PerchSpot { position = spot, normal = Vector3.up },
            };
        }
    }
}
