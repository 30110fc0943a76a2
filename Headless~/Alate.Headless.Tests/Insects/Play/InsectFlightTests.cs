using System;
using System.Collections;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    public sealed class InsectFlightTests : FlightFixture
    {
        [UnityTest]
        public IEnumerator AMonarch_FliesWhereItIsWanted_AtAnyScale([Values(1f, 0.1f)] float scale)
        {
            InsectFlight flight = Hatch();
            flight.transform.localScale = scale * Vector3.one;
            flight.Velocity = new Vector3(0f, 0f, 1f);
            yield return Frames(240);

            Assert.That(flight.Problem, Is.EqualTo(FlightProblem.None));
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Vector3 before = flight.Position;
            yield return Frames(60);
            Vector3 way = (flight.Position - before) / (InsectDefinition.UnitsPerMetre * scale);
            Assert.That(way.z, Is.EqualTo(60f * Time.deltaTime).Within(0.15f));
            Assert.That(Math.Abs(way.x), Is.LessThan(0.1f));
            Assert.That(Math.Abs(way.y), Is.LessThan(0.2f));
        }

        [UnityTest]
        public IEnumerator AnInsectThatFlies_BeginsItsBeatAtTheStartPhase([Values(0f, 90f, 270f)] float degrees)
        {
            InsectFlight flight = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            wings.StartPhase = degrees;
            yield return new WaitUntil(() => wings.Frequency > 0f);

            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            float most = 360f * wings.Frequency * 1.5f * Time.fixedDeltaTime;
            Assert.That(Mathf.Repeat(wings.Phase - degrees, 360f), Is.LessThanOrEqualTo(most));
        }

        // A flight that ends leaves the wings to the steering, which holds them as it says.
        [UnityTest]
        public IEnumerator WingsThatAreFolded_StaySo_WhenTheFlightIsDisabled([Values(0.7f, 1f)] float fold)
        {
            InsectFlight flight = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            yield return Frames(10);
            wings.Steering.fold = fold;
            yield return Frames(10);
            flight.enabled = false;
            yield return Frames(60);
            Vector3 tip = Tip();
            yield return Frames(3);

            Assert.That(Vector3.Distance(Tip(), tip), Is.LessThan(1e-3f));
            wings.Steering.fold = 0f;
            yield return Frames(60);
            tip = Tip();
            yield return Frames(3);
            Assert.That(Vector3.Distance(Tip(), tip), Is.GreaterThan(0.01f), "they beat again");

            Vector3 Tip() => wings.transform.InverseTransformPoint(wings.JointPosition(0, 0, wings.Read(0).JointsPerChain - 1));
        }

        // Without workers a step is computed where it is waited for: at the latest where the body is taken out, before its table is freed.
        [UnityTest]
        public IEnumerator AFlightThatIsDisabledWhileItsStepWaits_LeavesWingsThatBeat([Values(10, 11, 12, 13, 14, 15)] int frames)
        {
            InsectFlight flight = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            try
            {
                JobsUtility.JobWorkerCount = 0;
                yield return Frames(frames);
                flight.enabled = false;
                yield return Frames(10);
                Vector3 tip = wings.JointPosition(0, 0, wings.Read(0).JointsPerChain - 1);
                Assert.That(math.all(math.isfinite((float3)tip)));
                Assert.That(wings.Read(0).Frequency, Is.InRange(5f, 20f));
            }
            finally
            {
                JobsUtility.ResetJobWorkerCount();
            }
        }

        [UnityTest]
        public IEnumerator AWantedHeading_ComesBack_AndIsKeptInDegrees()
        {
            InsectFlight flight = Hatch();
            flight.Heading = 1.2f;
            Assert.That(flight.Heading, Is.EqualTo(1.2f).Within(1e-6f));
            float kept = new UnityEditor.SerializedObject(flight).FindProperty("m_Heading").floatValue;
            Assert.That(kept, Is.EqualTo(1.2f * Mathf.Rad2Deg).Within(1e-4f));
            flight.Heading = float.NaN;
            Assert.That(flight.Heading, Is.NaN);
            yield break;
        }

        // Four frames a step: what is shown goes from each step's attitude to the next, and never back.
        [UnityTest]
        public IEnumerator BetweenTwoSteps_TheAttitudeGoesForward()
        {
            // Frames end where steps do, wherever the tests before have left the clock: the way to the end of a step is all seen.
            Time.captureDeltaTime = Time.fixedTime + Time.fixedDeltaTime - Time.time;
            yield return null;
            Time.captureDeltaTime = 0.25f * Time.fixedDeltaTime;
            InsectFlight flight = Hatch();
            flight.Velocity = new Vector3(0f, 0f, 0.8f);
            yield return Frames(100);
            var shown = new List<Quaternion>();
            for (int frame = 0; frame < 81; frame++)
            {
                shown.Add(flight.transform.rotation);
                yield return null;
            }

            // A step begins in one frame of four: there the ways between are the longest.
            float frames = 0f, steps = 0f;
            for (int k = 1; k < shown.Count; k++)
                frames += Quaternion.Angle(shown[k - 1], shown[k]);
            for (int first = 0; first < 4; first++)
            {
                float way = 0f;
                for (int k = first + 4; k < shown.Count; k += 4)
                    way += Quaternion.Angle(shown[k - 4], shown[k]);
                steps = Mathf.Max(steps, way);
            }

            Assert.That(steps, Is.GreaterThan(10f), "a monarch nods with its beat");
            Assert.That(frames, Is.LessThan(1.1f * steps));
        }

        [UnityTest]
        public IEnumerator AMovedInsect_FliesOnFromThere()
        {
            InsectFlight flight = Hatch();
            yield return Frames(60);
            flight.transform.position = new Vector3(100f, 20f, -50f);
            yield return Frames(5);
            Assert.That((flight.transform.position - new Vector3(100f, 20f, -50f)).magnitude, Is.LessThan(1.5f));
        }

        [UnityTest]
        public IEnumerator APerchedInsect_Sits_UntilItTakesOff()
        {
            InsectFlight flight = Hatch();
            var pilot = new Percher(flight);
            yield return Frames(30);
            pilot.sits = true;
            yield return Frames(150);
            Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
            Vector3 place = flight.transform.position;
            yield return Frames(30);
            Assert.That(flight.transform.position, Is.EqualTo(place));
            pilot.sits = false;
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((pilot.Landed, pilot.TakenOff), Is.EqualTo((1, 1)));
        }

        [UnityTest]
        public IEnumerator OnTheWayDownAndUp_AnInsectMayTurnRound()
        {
            InsectFlight flight = Hatch();
            var pilot = new Percher(flight);
            yield return Frames(30);
            pilot.sits = true;
            yield return Frames(30);
            Assert.That(flight.State, Is.EqualTo(FlightState.Landing));
            pilot.sits = false;
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((pilot.Landed, pilot.TakenOff), Is.EqualTo((0, 0)));
            pilot.sits = true;
            yield return Frames(150);
            Assert.That((flight.State, pilot.Landed), Is.EqualTo((FlightState.Perched, 1)));
            Vector3 place = flight.transform.position;
            pilot.sits = false;
            for (int frame = 0; frame < 60 && flight.State == FlightState.Perched; frame++)
                yield return null;
            yield return Frames(5);
            pilot.sits = true;
            yield return Frames(100);
            Assert.That((flight.State, pilot.Landed, pilot.TakenOff), Is.EqualTo((FlightState.Perched, 2, 1)));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator WithoutTrims_ItSaysSo_AndBeatsOn()
        {
            InsectWings wings = Keep(InsectFactory.Create("monarch", InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            InsectFlight flight = wings.gameObject.AddComponent<InsectFlight>();
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("has no trims"));
            yield return Frames(30);
            Assert.That(flight.Problem, Is.EqualTo(FlightProblem.NoTrims));
            Assert.That(wings.Frequency, Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator WithoutABody_ItSaysSoOnce_AndBeatsOn()
        {
            InsectFlight flight = Hatch();
            flight.Parts.Clear();
            LogAssert.Expect(
                LogType.Warning, new System.Text.RegularExpressions.Regex("does not fly: A body needs at least one part with mass"));
            yield return Frames(30);
            Assert.That(flight.Problem, Is.EqualTo(FlightProblem.BadBody));
            Assert.That(flight.GetComponent<InsectWings>().Frequency, Is.GreaterThan(0f));
        }

        [UnityTest]
        public IEnumerator SwitchedOffAndOn_InAnyOrder_ItLivesOn()
        {
            var flights = new List<InsectFlight> { Hatch(), Hatch(), Hatch() };
            yield return Frames(20);
            flights[0].enabled = false;
            flights[1].GetComponent<InsectWings>().enabled = false;
            UnityEngine.Object.Destroy(flights[2].gameObject);
            yield return Frames(20);
            flights[0].enabled = true;
            flights[1].GetComponent<InsectWings>().enabled = true;
            yield return Frames(60);
            Assert.That(flights[0].State, Is.EqualTo(FlightState.Flying));
            Assert.That(flights[1].State, Is.EqualTo(FlightState.Flying));
            Assert.That(flights[1].BodyVelocity.magnitude, Is.LessThan(1f));
        }

        [UnityTest]
        public IEnumerator AFrame_AllocatesNothing()
        {
            for (int k = 0; k < 12; k++)
                Hatch();
            yield return Frames(60);
            FrameLoop loop = WingSystem.Loop;
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int round = 0; round < 10; round++)
            {
                loop.FixedStep(0.02f);
                loop.Frame(0.02f, 0.02f);
            }

            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        }

        private sealed class Percher : IFlightPilot
        {
            public bool sits;

            public Percher(InsectFlight flight)
            {
                flight.Pilot = this;
                flight.Landed += _ => Landed++;
                flight.TookOff += _ => TakenOff++;
            }

            public int Landed { get; private set; }

            public int TakenOff { get; private set; }

            public FlightCommand Command(in FlightSituation situation)
            {
                var command = FlightCommand.Fly(default);
                command.wish = sits ? FlightWish.Perch : FlightWish.Fly;
                command.spot = new PerchSpot { position = new Vector3(1f, 2f, 3f), normal = Vector3.up, heading = 1f };
                return command;
            }
        }
    }
}
