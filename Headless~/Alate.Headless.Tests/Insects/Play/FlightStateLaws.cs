using System.Collections;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Readings of an insect that flies, and its motion when it is moved or built again.</summary>
    public sealed class FlightStateLaws : FlightFixture
    {
        private const float k_Unit = InsectDefinition.UnitsPerMetre;

        [SetUp]
        public void StepOnceAFrame() => Time.captureDeltaTime = Time.fixedDeltaTime;

        // Its wings are built again, in the middle of the flight: it goes on as its twin, with the same motion.
        [UnityTest]
        public IEnumerator BuiltAgain_ItFliesOn()
        {
            InsectFlight flight = Hatch(), twin = Hatch();
            twin.Velocity = flight.Velocity = new Vector3(0f, 0f, 0.8f);
            yield return Frames(90);
            Vector3 place = flight.Position;
            flight.GetComponent<InsectWings>().Quality.patches = 40;
            yield return Frames(2);
            Assert.That((flight.Position - place).magnitude, Is.LessThan(0.1f * k_Unit));
            for (int frame = 0; frame < 60; frame++)
            {
                yield return null;
                Assert.That((flight.Position - twin.Position).magnitude, Is.LessThan(0.2f * k_Unit), $"frame {frame}");
            }
        }

        // Moved and turned about the vertical it goes on as its twin, moved and turned; what it wants is turned by who moves it.
        [UnityTest]
        public IEnumerator MovedAndTurned_ItFliesOn_LikeItsTwin([Values(90f, -40f)] float degrees)
        {
            InsectFlight flight = Hatch(), twin = Hatch();
            twin.Velocity = flight.Velocity = new Vector3(0f, 0f, 0.8f);
            yield return Frames(80);
            var turn = Quaternion.Euler(0f, degrees, 0f);
            Transform moved = flight.transform;
            Vector3 by = new Vector3(30f, -4f, 7f), from = moved.position;
            moved.SetPositionAndRotation(from + by, turn * moved.rotation);
            flight.Velocity = turn * twin.Velocity;
            yield return Frames(2);
            Assert.That((moved.position - from - by).magnitude, Is.LessThan(0.06f * k_Unit));
            from = moved.position;
            Vector3 twinFrom = twin.transform.position;
            for (int frame = 0; frame < 25; frame++)
            {
                yield return null;
                Vector3 way = moved.position - from, twinWay = twin.transform.position - twinFrom;
                Assert.That((way - turn * twinWay).magnitude, Is.LessThan(0.02f * k_Unit + 0.25f * twinWay.magnitude), $"frame {frame}");
                Assert.That((flight.BodyVelocity - turn * twin.BodyVelocity).magnitude, Is.LessThan(0.4f), $"frame {frame}");
            }
        }

        // Hovering, air carries the weight; its velocity is that of its place, in metres of the real insect.
        [UnityTest]
        public IEnumerator ForceAndVelocity_AreThoseOfItsWay([Values(1f, 0.5f)] float scale)
        {
            InsectFlight flight = Hatch();
            flight.transform.localScale = scale * Vector3.one;
            flight.Velocity = new Vector3(0.1f, 0f, 0.5f);
            yield return Frames(150);
            Vector3 from = flight.Position, force = default, velocity = default;
            const int frames = 120;
            for (int frame = 0; frame < frames; frame++)
            {
                yield return null;
                force += flight.Force / frames;
                velocity += flight.BodyVelocity / frames;
            }

            Vector3 way = (flight.Position - from) / (scale * k_Unit * frames * Time.deltaTime);
            Assert.That((way - velocity).magnitude, Is.LessThan(0.03f), "m/s");
            Assert.That((force - Vector3.up).magnitude, Is.LessThan(0.1f), "weights");
            Assert.That(flight.AidPower, Is.Zero);
        }

        // What a pilot is told agrees with what the flight says, step by step.
        [UnityTest]
        public IEnumerator APilot_IsToldTheSituation_AsItIs()
        {
            InsectFlight flight = Hatch();
            flight.transform.localScale = 2f * Vector3.one;
            var pilot = new Listener();
            flight.Pilot = pilot;
            yield return Frames(60);
            for (int k = 1; k < pilot.told.Count; k++)
            {
                FlightSituation before = pilot.told[k - 1], now = pilot.told[k];
                Assert.That(now.time - before.time, Is.EqualTo(before.deltaTime).Within(1e-6));
                Assert.That(now.unitsPerMetre, Is.EqualTo(2f * k_Unit).Within(1e-2f));
                Assert.That(math.distance(now.position, before.position),
                    Is.EqualTo(now.unitsPerMetre * before.deltaTime * math.length(0.5f * (now.velocity + before.velocity))).Within(0.1f));
                Assert.That(Headings.Wrap(now.heading - Headings.Of(now.rotation)), Is.Zero.Within(0.2f));
            }

            FlightSituation last = pilot.told[pilot.told.Count - 1];
            using FlightModel model = flight.CreateModel();
            Assert.That(last.wingLength, Is.EqualTo(model.Length));
            Assert.That((last.limits.TopSpeed, last.limits.MostClimb), Is.EqualTo((flight.Limits.TopSpeed, flight.Limits.MostClimb)));
            Assert.That(last.deltaTime, Is.EqualTo(Time.fixedDeltaTime).Within(1e-5f));
            Assert.That(last.state, Is.EqualTo(flight.State));
        }

        // On its way down its velocity is that of the way; perched it stands, and neither has a trim.
        [UnityTest]
        public IEnumerator OnItsWayDown_ItsVelocityIsThatOfTheWay()
        {
            InsectFlight flight = Hatch();
            var pilot = new Listener();
            flight.Pilot = pilot;
            // Asked while its bob leads down: from a bob that leads up the way down is the steeper.
            yield return Frames(32);
            Assert.That(flight.TryReadTrim(out WingDrive drive, out Vector3 wanted), Is.True);
            Assert.That((drive.frequency, wanted.magnitude), Is.EqualTo((drive.frequency, 0f)));
            pilot.command.wish = FlightWish.Perch;
            pilot.command.spot =
                new PerchSpot { position = flight.Position - new Vector3(0f, 0.3f * k_Unit, 0f), normal = Vector3.up, heading = 1f };
            yield return Frames(3);
            Vector3 before = flight.Position;
            float fastest = 0f;
            for (int frame = 0; frame < 200 && flight.State != FlightState.Perched; frame++)
            {
                yield return null;
                Vector3 way = (flight.Position - before) / (k_Unit * Time.deltaTime);
                Assert.That((way - flight.BodyVelocity).magnitude, Is.LessThan(0.02f), $"frame {frame}");
                Assert.That(flight.TryReadTrim(out _, out _), Is.False);
                fastest = Mathf.Max(fastest, way.magnitude);
                before = flight.Position;
            }

            Assert.That(fastest, Is.InRange(0.15f, 0.3f));
            yield return Frames(2);
            Assert.That((flight.State, flight.BodyVelocity.magnitude), Is.EqualTo((FlightState.Perched, 0f)));
            Assert.That(pilot.told[pilot.told.Count - 1].state, Is.EqualTo(FlightState.Perched));
            Assert.That(Headings.Wrap(pilot.told[pilot.told.Count - 1].heading - 1f), Is.Zero.Within(1e-3f));
        }

        // Turned over in flight it says that it tumbles, and, helped up again, how long and how far it did.
        [UnityTest]
        public IEnumerator AnInsectThatIsTurnedOver_SaysWhenHowLongAndHowFarItTumbled()
        {
            InsectFlight flight = Hatch();
            var told = new List<(string, int)>();
            int frame = 0;
            flight.TumbleBegan += _ => told.Add(("began", frame));
            flight.TumbleBegan += tumbling => tumbling.Aid = 1f;
            flight.TumbleEnded += _ => told.Add(("ended", frame));
            yield return Frames(30);
            Assert.That((flight.TumbleCount, flight.Tumble.seconds), Is.EqualTo((0, 0f)));
            WingWorld world = WingSystem.Loop.World;
            world.Complete();
            ref FlyingBody body = ref world.Body(new BodyHandle(0, 1));
            body.rotation = math.mul(body.rotation, quaternion.AxisAngle(new float3(1f, 0f, 0f), 2.5f));
            for (; frame < 200 && told.Count < 2; frame++)
                yield return null;
            Assert.That((told[0].Item1, told[1].Item1, flight.TumbleCount), Is.EqualTo(("began", "ended", 1)));
            Assert.That(flight.Tumble.seconds, Is.EqualTo((told[1].Item2 - told[0].Item2) * Time.fixedDeltaTime).Within(1e-3f));
            Assert.That(flight.Tumble.distance, Is.InRange(0.001f, 2f));
        }

        // Four frames a step: the insect is drawn on an even way.
        [UnityTest]
        public IEnumerator BetweenSteps_ItIsDrawnOnItsWay()
        {
            InsectFlight flight = Hatch();
            flight.Velocity = new Vector3(0f, 0f, 1f);
            yield return Frames(150);
            Time.captureDeltaTime = 1f / 240f;
            yield return Frames(8);
            Vector3 before = flight.transform.position;
            for (int frame = 0; frame < 80; frame++)
            {
                yield return null;
                Vector3 way = flight.transform.position - before;
                Assert.That(way.z, Is.EqualTo(k_Unit / 240f).Within(0.5f * k_Unit / 240f), $"frame {frame}");
                before = flight.transform.position;
            }
        }

        private sealed class Listener : IFlightPilot
        {
            public readonly List<FlightSituation> told = new List<FlightSituation>();
            public FlightCommand command = FlightCommand.Fly(default, 0f);

            public FlightCommand Command(in FlightSituation situation)
            {
                told.Add(situation);
                return command;
            }
        }
    }
}
