using System;
using System.Collections;
using System.Text.RegularExpressions;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Commands of pilots of flocks, volumes and marks of others, and who steers an insect.</summary>
    public sealed class PilotLaws : PlayFixture
    {
        private const float k_Unit = 10f, k_Length = 0.05f;

        [UnityTest]
        public IEnumerator AMember_IsSeenInWorldUnits()
        {
            FlockPilot pilot = Made();
            yield return null;
            pilot.Settings.group = 7;
            pilot.Settings.sight = 30f;
            pilot.Settings.room = 4f;
            pilot.Command(Situation());
            Assert.That(pilot.Member.position, Is.EqualTo(new float3(1f, 2f, 3f)));
            Assert.That(math.distance(pilot.Member.velocity, k_Unit * Situation().referenceVelocity), Is.LessThan(1e-5f));
            Assert.That(pilot.Member.sight, Is.EqualTo(30f * k_Length * k_Unit).Within(1e-4f));
            Assert.That(pilot.Member.room, Is.EqualTo(4f * k_Length * k_Unit).Within(1e-4f));
            Assert.That(pilot.Member.group, Is.EqualTo(7));
        }

        // On as it flies, or as it looks; besides 1.5 of the way from those that are too near, 0.4 of the others' velocity over its own,
        // and 0.3 of the way to their middle, at the speed of its own wish but at least 0.3 m/s; at most 1.3 of it.
        [UnityTest]
        public IEnumerator WhatItWants_IsASumOfItsNeighbours()
        {
            FlockPilot pilot = Made();
            FlightSituation situation = Situation();
            pilot.Settings.speed = 0.5f;
            pilot.Command(situation);
            float3 ahead = math.normalize(situation.referenceVelocity), own = 0.5f * ahead;
            Expect(pilot, situation, default, own);
            var apart = new float3(0.02f, 0.01f, 0.03f);
            Expect(pilot, situation, new FlockView { apart = apart }, own + 1.5f * 0.5f * apart);
            float3 others = situation.referenceVelocity + new float3(0.1f, -0.05f, 0.02f);
            float3 middle = situation.position + new float3(0.5f, 0.25f, -0.5f);
            var view = new FlockView { count = 3, velocity = k_Unit * others, centre = middle };
            float sight = 20f * k_Length * k_Unit;
            Expect(pilot, situation, view, own + 0.4f * (others - situation.referenceVelocity)
                + 0.3f * 0.5f * (middle - situation.position) / sight);
            view.count = 0;
            Expect(pilot, situation, view, own);
            view = new FlockView { count = 1, velocity = k_Unit * situation.referenceVelocity };
            view.centre = situation.position + 100f * sight * ahead;
            float3 far = own + 0.15f * new float3(1f, 0f, 1f);
            Expect(pilot, situation, view, 1.3f * 0.5f * math.normalize(far));
            view.centre = situation.position - 100f * sight * ahead;
            Expect(pilot, situation, view, own - 0.15f * new float3(1f, 0f, 1f));
            Expect(pilot, situation, new FlockView { apart = 5f * ahead }, 1.3f * 0.5f * ahead);

            Follower below = pilot.gameObject.AddComponent<Follower>();
            below.command = FlightCommand.Fly(0.1f * ahead);
            pilot.Command(situation);
            Expect(pilot, situation, default, 0.1f * ahead);
            Expect(pilot, situation, new FlockView { apart = apart }, 0.1f * ahead + 1.5f * 0.3f * apart);
            yield return null;
        }

        [UnityTest]
        public IEnumerator OneThatStands_WantsToFlyWhereItLooks()
        {
            FlockPilot pilot = Made();
            FlightSituation situation = Situation();
            situation.referenceVelocity = default;
            situation.heading = 0.8f;
            pilot.Settings.speed = 0.5f;
            float3 wanted = pilot.Command(situation).velocity;
            Assert.That(math.distance(wanted, 0.5f * new float3(math.sin(0.8f), 0f, math.cos(0.8f))), Is.LessThan(1e-3f));
            yield return null;
        }

        // A quarter of a second passes between two looks for a pilot, unless the one that flew is gone.
        [UnityTest]
        public IEnumerator WhoSteers_IsTheScriptsPilot_ElseTheFirstOnTheObject()
        {
            GameObject insect = Keep(new GameObject("insect"));
            var seat = new PilotSeat(insect.transform);
            FlightCommand without = Command(9f);
            Assert.That(Ask(seat, 0.0, without), Is.EqualTo(9f));
            Follower first = insect.AddComponent<Follower>(), second = insect.AddComponent<Follower>();
            (first.command, second.command) = (Command(1f), Command(2f));
            Assert.That(Ask(seat, 0.24, without), Is.EqualTo(9f));
            Assert.That(Ask(seat, 0.26, without), Is.EqualTo(1f));
            first.enabled = false;
            Assert.That(Ask(seat, 0.27, without), Is.EqualTo(2f), "who is off is not asked");
            first.enabled = true;
            Assert.That(Ask(seat, 0.3, without), Is.EqualTo(2f));
            Assert.That(Ask(seat, 0.53, without), Is.EqualTo(1f), "a quarter of a second after the last look");

            var script = new Script { command = Command(3f) };
            seat.Pilot = script;
            Assert.That(seat.Pilot, Is.SameAs(script));
            Assert.That(Ask(seat, 0.54, without), Is.EqualTo(3f));
            first.enabled = second.enabled = false;
            Assert.That(Ask(seat, 0.9, without), Is.EqualTo(3f));
            second.enabled = true;
            seat.Pilot = null;
            Assert.That(Ask(seat, 0.91, without), Is.EqualTo(2f), "at once");
            second.enabled = false;
            Assert.That(Ask(seat, 0.92, without), Is.EqualTo(9f));
            first.enabled = true;
            Assert.That(Ask(seat, 0.93, without), Is.EqualTo(9f));
            seat.Restart();
            Assert.That(Ask(seat, 0.94, without), Is.EqualTo(1f), "at once");
            yield return null;
        }

        [UnityTest]
        public IEnumerator OneThatThrows_IsAskedAgain_OnceItWasOff()
        {
            GameObject insect = Keep(new GameObject("insect"));
            var seat = new PilotSeat(insect.transform);
            Follower pilot = insect.AddComponent<Follower>();
            pilot.throws = true;
            LogAssert.Expect(LogType.Exception, new Regex("Follower of 'insect' threw an exception"));
            Assert.That(Ask(seat, 0.0, Command(9f)), Is.Zero);
            Assert.That(seat.HasFailed);
            (pilot.throws, pilot.command) = (false, Command(1f));
            Assert.That(Ask(seat, 0.1, Command(9f)), Is.Zero, "it hovers");
            Assert.That(Ask(seat, 9.0, Command(9f)), Is.Zero);
            pilot.enabled = false;
            Assert.That(Ask(seat, 9.1, Command(9f)), Is.EqualTo(9f));
            Assert.That(seat.HasFailed, Is.False);
            pilot.enabled = true;
            Assert.That(Ask(seat, 9.5, Command(9f)), Is.EqualTo(1f));
            yield return null;
        }

        // Closed while it sits; spread as soon as it wants to fly, though it still holds on.
        [UnityTest]
        public IEnumerator Wings_AreFolded_OnlyWhileItSitsAndWantsTo()
        {
            PerchPilot pilot = Keep(new GameObject("percher")).AddComponent<PerchPilot>();
            pilot.Settings.stayTime = 100f;
            FlightSituation situation = Situation();
            situation.unitsPerMetre = 1f;
            situation.referenceVelocity = situation.velocity = default;
            float height = 6.1e-3f + 1.2f * k_Length;
            Assert.That(pilot.LandOn(new PerchSpot { normal = Vector3.up, heading = 0f }));
            situation.position = new float3(0f, height, 0f) + 0.4f * math.normalize(new float3(0f, 0.45f, -1f));
            for (int step = 0; step < 5 && pilot.Stage != PerchStage.Perched; step++)
            {
                pilot.Command(situation);
                situation.position = new float3(0f, height, 0f);
            }

            Assert.That(pilot.Stage, Is.EqualTo(PerchStage.Perched));
            situation.state = FlightState.Landing;
            pilot.Command(situation);
            Assert.That(pilot.Fold, Is.Zero, "not down yet");
            situation.state = FlightState.Perched;
            for (int step = 0; step < 5; step++)
                pilot.Command(situation);
            Assert.That(pilot.Fold, Is.EqualTo(5f * 0.02f / 0.5f).Within(1e-4f));
            pilot.TakeOff();
            pilot.Command(situation);
            Assert.That(pilot.Stage, Is.EqualTo(PerchStage.TakingOff));
            Assert.That(pilot.Fold, Is.Zero);
            yield return null;
        }

        // Looked at five times a second: what is watched comes nearer than the distance, or does not.
        [UnityTest]
        public IEnumerator ItFlees_FromWhatComesNearerThanItsDistance([Values(4.9f, 5.1f)] float distance)
        {
            PerchPilot pilot = Keep(new GameObject("percher")).AddComponent<PerchPilot>();
            FlightSituation situation = Situation();
            Transform hand = Keep(new GameObject("hand")).transform;
            pilot.Watched.Add(null);
            pilot.Watched.Add(hand);
            hand.position = (Vector3)situation.position + distance * Vector3.left;
            pilot.LandOn(new PerchSpot { position = situation.position - new float3(0f, 5f, 0f), normal = Vector3.up, heading = 0f });
            Assert.That(pilot.Stage, Is.EqualTo(PerchStage.Approaching));
            int steps = 0;
            for (; steps < 15 && pilot.Stage == PerchStage.Approaching; steps++)
                pilot.Command(situation);
            Assert.That(steps, distance < 5f ? Is.InRange(10, 11) : Is.InRange(15, 15));
            yield return null;
        }

        // The bottom of the volume is where the insect starts, unless the volume goes with an object.
        [UnityTest]
        public IEnumerator AWanderersVolume_StandsOnItsStart_OrGoesWithAnObject()
        {
            WanderPilot pilot = Keep(new GameObject("wanderer")).AddComponent<WanderPilot>();
            pilot.Obstacles.avoid = false;
            pilot.transform.position = new Vector3(7f, 8f, 9f);
            pilot.Volume = new FlightVolume(VolumeShape.Ellipsoid, new Vector3(1f, 2f, 3f), new Vector3(30f, 10f, 20f));
            Assert.That(pilot.WorldVolume.centre, Is.EqualTo(new Vector3(1f, 2f, 3f)));
            pilot.StayAroundStart();
            Assert.That(pilot.Volume.centre, Is.EqualTo(new Vector3(0f, 5f, 0f)));
            Assert.That(pilot.WorldVolume.centre, Is.EqualTo(new Vector3(7f, 13f, 9f)), "where it stands, before it has started");
            pilot.Command(Situation());
            pilot.transform.position = new Vector3(70f, 80f, 90f);
            Assert.That(pilot.WorldVolume.centre, Is.EqualTo(new Vector3(1f, 7f, 3f)), "where its body was at the start");
            pilot.Around = Keep(new GameObject("flower")).transform;
            pilot.Around.position = new Vector3(4f, 4f, 4f);
            Assert.That(pilot.WorldVolume.centre, Is.EqualTo(new Vector3(4f, 9f, 4f)));
            Assert.That((pilot.WorldVolume.shape, pilot.WorldVolume.size), Is.EqualTo((VolumeShape.Ellipsoid, new Vector3(30f, 10f, 20f))));
            pilot.enabled = false;
            pilot.Around = null;
            pilot.enabled = true;
            Assert.That(pilot.WorldVolume.centre, Is.EqualTo(new Vector3(70f, 85f, 90f)), "it starts again");
            yield return null;
        }

        // Marks that are taken, farther than asked for, or just left do not count.
        [UnityTest]
        public IEnumerator OfPerchMarks_TheNearestFreeOneIsFound()
        {
            PerchMark near = Mark(2f), far = Mark(5f), beyond = Mark(9f);
            FlockPilot guest = Made();
            Assert.That(PerchMark.FindNearest(Vector3.zero, 8f, null), Is.SameAs(near));
            Assert.That(PerchMark.FindNearest(Vector3.zero, 8f, near), Is.SameAs(far));
            near.Guest = guest;
            Assert.That(near.IsFree, Is.False);
            Assert.That(PerchMark.FindNearest(Vector3.zero, 8f, null), Is.SameAs(far));
            Assert.That(PerchMark.FindNearest(new Vector3(10f, 0f, 0f), 8f, null), Is.SameAs(beyond));
            Assert.That(PerchMark.FindNearest(Vector3.zero, 4.9f, null), Is.Null);
            guest.enabled = false;
            Assert.That(near.IsFree);
            near.enabled = false;
            Assert.That(PerchMark.FindNearest(Vector3.zero, 8f, null), Is.SameAs(far));
            far.transform.rotation = Quaternion.Euler(0f, 30f, 0f);
            Assert.That((far.Spot.position.x, far.Spot.normal.y), Is.EqualTo((5f, 1f)));
            Assert.That(far.Spot.heading, Is.EqualTo(math.PI / 6f).Within(1e-5f));
            yield return null;
            PerchMark Mark(float x)
            {
                PerchMark mark = Keep(new GameObject("mark")).AddComponent<PerchMark>();
                mark.transform.position = new Vector3(x, 0f, 0f);
                return mark;
            }
        }

        // A mark has its guest from when it is chosen until the guest wants to go elsewhere; it is not chosen again at once.
        [UnityTest]
        public IEnumerator AMark_IsLeft_ByWhoGoesElsewhere([Values("lands", "takes off", "is off")] string leaves)
        {
            PerchMark mark = Keep(new GameObject("mark")).AddComponent<PerchMark>();
            mark.transform.position = new Vector3(1f, -6f, 3f);
            PerchPilot pilot = Keep(new GameObject("percher")).AddComponent<PerchPilot>();
            pilot.Settings.flightTime = 0f;
            pilot.Settings.fleeDistance = 0f;
            Assert.That(mark.IsFree);
            FlightSituation situation = Situation();
            for (int step = 0; step < 25; step++)
                pilot.Command(situation);
            Assert.That(mark.Guest, Is.SameAs(pilot));
            Assert.That(pilot.Stage, Is.EqualTo(PerchStage.Approaching));
            if (leaves == "lands")
                Assert.That(pilot.LandOn(new PerchSpot { position = new float3(9f, -9f, 9f), normal = Vector3.up }));
            else if (leaves == "takes off")
                pilot.TakeOff();
            else
                pilot.enabled = false;
            if (leaves == "takes off")
                pilot.Command(situation);
            Assert.That(mark.Guest == null && mark.IsFree);
            for (int step = 0; step < 25; step++)
                pilot.Command(situation);
            Assert.That(pilot.Stage, Is.EqualTo(leaves == "lands" ? PerchStage.Approaching : PerchStage.Between), "no other mark is there");
            Assert.That(mark.Guest == null);
            yield return null;
        }

        private static void Expect(FlockPilot pilot, in FlightSituation situation, in FlockView view, float3 wanted)
        {
            pilot.View = view;
            Assert.That(math.distance(pilot.Command(situation).velocity, wanted), Is.LessThan(1e-4f));
        }

        private static float Ask(PilotSeat seat, double time, in FlightCommand without)
        {
            FlightSituation situation = Situation();
            situation.time = time;
            return seat.Command(situation, without).velocity.x;
        }

        private static FlightCommand Command(float x) => FlightCommand.Fly(new float3(x, 0f, 0f));

        private FlockPilot Made()
        {
            FlockPilot pilot = Keep(new GameObject("pilot")).AddComponent<FlockPilot>();
            pilot.Obstacles.avoid = false;
            return pilot;
        }

        private static FlightSituation Situation() => new FlightSituation
        {
            position = new float3(1f, 2f, 3f),
            rotation = quaternion.identity,
            referenceVelocity = new float3(0.3f, 0f, 0.5f),
            heading = math.atan2(0.3f, 0.5f),
            limits = new FlightLimits(1.3f, -0.3f, 0.3f, 2.5f),
            deltaTime = 0.02f,
            wingLength = k_Length,
            unitsPerMetre = k_Unit,
        };

        private sealed class Script : IFlightPilot
        {
            public FlightCommand command;

            public FlightCommand Command(in FlightSituation situation) => command;
        }

        private sealed class Follower : FlightPilot
        {
            public FlightCommand command;
            public bool throws;

            public override FlightCommand Command(in FlightSituation situation) =>
                throws ? throw new InvalidOperationException("it does not know") : command;
        }
    }
}
