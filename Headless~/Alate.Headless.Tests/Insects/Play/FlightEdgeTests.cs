using System;
using System.Collections;
using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Fields and places that are none, for some frames, around an insect that flies.</summary>
    public sealed class FlightEdgeTests : FlightFixture
    {
        private const int k_Frames = 8;

        private static readonly float[] s_Nonsense = { float.NaN, float.PositiveInfinity, float.NegativeInfinity, 1e38f };
        private static readonly string[] s_Fields = { "wind", "zone", "gravity", "velocity", "pilot", "heading", "metresPerUnit", "spot" };

        private readonly List<string> m_Warnings = new List<string>();

        [SetUp]
        public void Listen()
        {
            m_Warnings.Clear();
            Application.logMessageReceived += Hear;
        }

        [TearDown]
        public void StopListening() => Application.logMessageReceived -= Hear;

        [UnityTest]
        public IEnumerator AFieldThatIsNone_IsRefused_AndToldOnce(
            [ValueSource(nameof(s_Fields))] string field) => Refuses(field, float.NaN);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AFieldWithoutBounds_IsRefused_AndToldOnce(
            [ValueSource(nameof(s_Fields))] string field, [Values(1e38f, float.PositiveInfinity, float.NegativeInfinity)] float value) =>
            Refuses(field, value);

        private IEnumerator Refuses(string field, float value)
        {
            InsectFlight flight = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            WindZone zone = Keep(new GameObject("zone")).AddComponent<WindZone>();
            zone.windMain = 0f;
            WingSystem.FindWindZones();
            yield return Frames(40);
            Vector3 place = flight.transform.position;
            float metres = wings.Motion.metresPerUnit;
            for (int frame = 0; frame < k_Frames; frame++)
            {
                Set(field, value, flight, wings, zone);
                yield return null;
                Assert.That(math.all(math.isfinite((float3)flight.transform.position)), $"frame {frame}");
            }

            wings.Air.wind = default;
            zone.windMain = 0f;
            Physics.gravity = Gravity;
            flight.Velocity = default;
            flight.Heading = float.NaN;
            flight.Pilot = null;
            wings.Motion.metresPerUnit = metres;
            yield return Frames(120);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(3f));
            bool isTold = field == "wind" || field == "zone" || field == "gravity"
                || (field == "velocity" || field == "pilot") && !math.isfinite(value);
            Assert.That(m_Warnings, Has.Count.EqualTo(isTold ? 1 : 0), string.Join("\n", m_Warnings));
            if (isTold)
                Assert.That(m_Warnings[0], Does.Contain("is refused, the last good one counts"));
        }

        [UnityTest]
        public IEnumerator InAWindThatBreaksOff_TheLastOneBlowsOn()
        {
            InsectFlight flight = Hatch(), twin = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            wings.Air.wind = twin.GetComponent<InsectWings>().Air.wind = new Vector3(3f, 0f, 0f);
            for (int frame = 0; frame < 90; frame++)
            {
                if (frame >= 40)
                    wings.Air.wind = new Vector3(float.NaN, 0f, 1e38f);
                yield return null;
                Assert.That((flight.Position - twin.Position).magnitude, Is.LessThan(1e-3f), $"frame {frame}");
            }
        }

        [UnityTest]
        public IEnumerator AnInsectThatIsLost_StartsAgain(
            [Values("velocity", "spin", "rotation", "position", "fast")] string lost, [Values] bool hasRigidbody)
        {
            InsectFlight flight = Hatch();
            if (hasRigidbody)
                flight.gameObject.AddComponent<Rigidbody>();
            yield return Frames(40);
            Vector3 place = flight.transform.position;
            Lose(lost);
            yield return Frames(120);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(3f));
            Assert.That(m_Warnings, Has.Count.EqualTo(1), string.Join("\n", m_Warnings));
            Assert.That(m_Warnings[0], Does.StartWith($"'{flight.name}' was lost"));
            Assert.That(flight.GetComponent<InsectWings>().Read(0).Frequency, Is.InRange(5f, 20f), "the wings beat on");
        }

        [UnityTest]
        public IEnumerator OneThatIsLost_TakesNobodyWithIt()
        {
            InsectFlight lost = Hatch(), other = Hatch(), twin = Hatch();
            yield return Frames(40);
            Lose("velocity");
            for (int frame = 0; frame < 60; frame++)
            {
                yield return null;
                Assert.That((other.Position - twin.Position).magnitude, Is.LessThan(1e-3f), $"frame {frame}");
            }

            Assert.That(lost.State, Is.EqualTo(FlightState.Flying));
        }

        [UnityTest]
        public IEnumerator PutBeyondAllPlaces_ItStartsAgainWhereItBegan([Values] bool hasRigidbody)
        {
            InsectFlight flight = Hatch();
            Rigidbody body = hasRigidbody ? flight.gameObject.AddComponent<Rigidbody>() : null;
            yield return Frames(40);
            if (body != null)
                body.position = new Vector3(1e38f, 0f, 0f);
            else
                flight.transform.position = new Vector3(1e38f, 0f, 0f);
            yield return Frames(120);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.transform.position.magnitude, Is.LessThan(6f));
        }

        [UnityTest]
        public IEnumerator APushThatIsNone_IsNotTaken([Values(1e10f, 1e30f)] float push, [Values] bool turns)
        {
            InsectFlight flight = Hatch();
            Rigidbody body = flight.gameObject.AddComponent<Rigidbody>();
            yield return Frames(40);
            Vector3 place = flight.transform.position;
            for (int frame = 0; frame < k_Frames; frame++)
            {
                if (turns)
                    body.AddTorque(push * Vector3.right, ForceMode.VelocityChange);
                else
                    body.AddForce(push * Vector3.up, ForceMode.VelocityChange);
                yield return null;
            }

            yield return Frames(120);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(3f));
        }

        [UnityTest]
        public IEnumerator AScaleThatIsNone_StopsIt_WhereItIs([Values(0f, 1e30f, 1e38f)] float scale)
        {
            InsectFlight flight = Hatch();
            yield return Frames(40);
            Vector3 place = flight.transform.position;
            flight.transform.localScale = scale * Vector3.one;
            yield return Frames(k_Frames);
            flight.transform.localScale = Vector3.one;
            yield return Frames(120);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(3f));
        }

        [UnityTest]
        public IEnumerator AGoalThatIsNone_LeavesAFollowerWhereItIs([ValueSource(nameof(s_Nonsense))] float value)
        {
            InsectFlight flight = Hatch();
            FollowPilot pilot = flight.gameObject.AddComponent<FollowPilot>();
            Transform target = Keep(new GameObject("target")).transform;
            pilot.Target = target;
            yield return Frames(40);
            pilot.Offset = new Vector3(value, 0f, 0f);
            yield return Frames(k_Frames);
            pilot.Offset = default;
            yield return Frames(180);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - target.position).magnitude, Is.LessThan(5f));
            Assert.That(m_Warnings, Has.Count.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator AVolumeThatIsNowhere_DoesNotEndAWander([ValueSource(nameof(s_Nonsense))] float value)
        {
            InsectFlight flight = Hatch();
            WanderPilot pilot = flight.gameObject.AddComponent<WanderPilot>();
            pilot.Seed = 5;
            FlightVolume volume = pilot.Volume;
            yield return Frames(40);
            pilot.Volume = new FlightVolume(VolumeShape.Box, new Vector3(value, 0f, 0f), volume.size);
            yield return Frames(k_Frames);
            pilot.Volume = volume;
            float speed = 0f;
            for (int frame = 0; frame < 180; frame++)
            {
                yield return null;
                Assert.That(flight.TryReadTrim(out _, out Vector3 wanted));
                speed = math.max(speed, math.length(((float3)wanted).xz));
            }

            Assert.That(speed, Is.GreaterThan(0.3f), "it flies on");
            Assert.That(flight.transform.position.magnitude, Is.LessThan(60f));
        }

        private void Set(string field, float value, InsectFlight flight, InsectWings wings, WindZone zone)
        {
            switch (field)
            {
                case "wind": wings.Air.wind = new Vector3(0f, value, 0f); break;
                case "zone": zone.windMain = value; break;
                case "gravity": Physics.gravity = new Vector3(0f, -value, 0f); break;
                case "velocity": flight.Velocity = new Vector3(0f, math.isfinite(value) ? 0f : value, value == 1e38f ? 1e38f : 0f); break;
                case "pilot":
                    flight.Pilot = new Steerer { command = FlightCommand.Fly(math.isfinite(value) ? default : new float3(value)) }; break;
                case "heading": flight.Heading = value; break;
                case "metresPerUnit": wings.Motion.metresPerUnit = math.isfinite(value) ? 1e-38f : value; break;
                case "spot": flight.Pilot = new Steerer { command = Perching(value) }; break;
                default: throw new ArgumentException(field);
            }
        }

        private static FlightCommand Perching(float value)
        {
            var command = FlightCommand.Fly(default);
            command.wish = FlightWish.Perch;
            command.spot = new PerchSpot { position = value, normal = Vector3.up };
            return command;
        }

        // The first insect of a play has the first body of its world.
        private static void Lose(string what)
        {
            WingWorld world = WingSystem.Loop.World;
            world.Complete();
            ref FlyingBody body = ref world.Body(new BodyHandle(0, 1));
            switch (what)
            {
                case "velocity": body.velocity = float.NaN; break;
                case "spin": body.spin = float.PositiveInfinity; break;
                case "rotation": body.rotation = default; break;
                case "position": body.position = 1e38f; break;
                default: body.velocity = new float3(0f, 1e6f, 0f); break;
            }
        }

        private void Hear(string text, string trace, LogType type)
        {
            if (type != LogType.Log)
                m_Warnings.Add(text);
        }

        private sealed class Steerer : IFlightPilot
        {
            public FlightCommand command;

            public FlightCommand Command(in FlightSituation situation) => command;
        }
    }
}
