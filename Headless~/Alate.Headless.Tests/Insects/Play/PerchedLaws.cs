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

        private InsectFlight m_Flight;
        private PerchPilot m_Pilot;

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
        public IEnumerator ATouch_LetsASittingInsectFlyAway_FromWhatTouchesIt([Values(-1f, 1f)] float side)
        {
            PerchMark mark = null;
            yield return Sits(made => mark = made);
            SphereCollider hand = Keep(new GameObject("hand")).AddComponent<SphereCollider>();
            hand.transform.position = m_Flight.Position + new Vector3(side, 0f, 0f);
            Vector3 seat = m_Flight.Position;
            m_Pilot.Touched(hand);
            for (int frame = 0; frame < 300 && m_Flight.State != FlightState.Flying; frame++)
                yield return null;
            yield return Frames(60);
            Assert.That(m_Flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(-side * (m_Flight.Position - seat).x, Is.GreaterThan(0.3f), "away from the hand");
            Assert.That(mark.IsFree);
        }

        // Its perch, a leaf of it, its own wings; and nothing at all where the option is off.
        [UnityTest]
        public IEnumerator WhatItSitsOn_AndItself_DoNotFrightenIt([Values(0, 1, 2, 3)] int what)
        {
            PerchMark mark = null;
            yield return Sits(made => mark = made);
            Transform place = what == 0 ? mark.transform : what == 2 ? m_Flight.GetComponent<InsectWings>().Wings[0].Renderer.transform
                : new GameObject("leaf").transform;
            if (what == 1)
                place.SetParent(mark.transform, false);
            m_Pilot.Settings.leavesWhenTouched = what != 3;
            m_Pilot.Touched(place.gameObject.AddComponent<SphereCollider>());
            yield return Frames(60);
            Assert.That(m_Flight.State, Is.EqualTo(FlightState.Perched));
            m_Pilot.Startle(new Vector3(float.NaN, 0f, 0f));
            yield return Frames(60);
            Assert.That(m_Flight.State, Is.EqualTo(FlightState.Flying), "from nowhere in particular");
            if (what == 3)
                UnityEngine.Object.Destroy(place.gameObject);
        }

        // Of a spot that a script names nobody knows the collider.
        [UnityTest]
        public IEnumerator WhatItMeetsOnItsWayDown_IsItsPerch()
        {
            m_Flight = Hatch();
            m_Pilot = m_Flight.gameObject.AddComponent<PerchPilot>();
            m_Pilot.Settings.stayTime = 600f;
            SphereCollider ground = Keep(new GameObject("ground")).AddComponent<SphereCollider>();
            yield return Frames(2);
            m_Pilot.LandOn(new PerchSpot { position = m_Flight.Position + new Vector3(0f, -0.8f, 4f), normal = Vector3.up });
            for (int frame = 0; frame < 1500 && m_Pilot.Stage != PerchStage.Perched; frame++)
                yield return null;
            Assert.That(m_Flight.State, Is.Not.EqualTo(FlightState.Perched), "on its last way down");
            m_Pilot.Touched(ground);
            yield return Frames(150);
            m_Pilot.Touched(ground);
            yield return Frames(60);
            Assert.That(m_Flight.State, Is.EqualTo(FlightState.Perched));
            m_Pilot.Touched(Keep(new GameObject("hand")).AddComponent<SphereCollider>());
            yield return Frames(60);
            Assert.That(m_Flight.State, Is.EqualTo(FlightState.Flying));
        }

        [UnityTest]
        public IEnumerator AFlyingInsect_FleesForASecond_FromWhatStartlesIt([Values(-1f, 1f)] float side)
        {
            m_Flight = Hatch();
            m_Pilot = m_Flight.gameObject.AddComponent<PerchPilot>();
            m_Pilot.Settings.flightTime = 600f;
            yield return Frames(50);
            Vector3 before = m_Flight.Position;
            m_Pilot.Startle(before + new Vector3(side, 0f, 0f));
            yield return Frames(60);
            Assert.That(-side * (m_Flight.Position - before).x, Is.GreaterThan(0.3f));
        }

        private IEnumerator Sits(System.Action<PerchMark> tell)
        {
            m_Flight = Hatch();
            m_Pilot = m_Flight.gameObject.AddComponent<PerchPilot>();
            m_Pilot.Settings.stayTime = 600f;
            PerchMark mark = Keep(new GameObject("mark")).AddComponent<PerchMark>();
            mark.transform.position = m_Flight.Position + new Vector3(0f, -0.8f, 4f);
            tell(mark);
            yield return Frames(2);
            m_Pilot.LandOn(mark);
            for (int frame = 0; frame < 1500 && m_Flight.State != FlightState.Perched; frame++)
                yield return null;
            yield return Frames(30);
            Assert.That(m_Flight.State, Is.EqualTo(FlightState.Perched));
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
