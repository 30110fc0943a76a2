using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Editor;
using Alate.Flight;
using Alate.Tests.Cli;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Flights of a scene, recorded, written, read, and flown again without the scene.</summary>
    public sealed class FlightRecordingTests : FlightFixture
    {
        private const int k_Frames = 150;

        [UnityTest]
        public IEnumerator ATumble_ReplaysToTheBit()
        {
            InsectFlight flight = Hatch();
            var pilot = new Backwards();
            flight.Pilot = pilot;
            flight.StartRecording();
            yield return Frames(k_Frames / 3);
            WindZone gust = Gust(2f, Quaternion.Euler(90f, 0f, 0f));
            yield return Frames(k_Frames / 3);
            Object.Destroy(gust.gameObject);
            yield return Frames(k_Frames / 3);

            Assert.That(pilot.HasTumbled, "nobody tumbles");
            Assert.That(flight.Recorder.Recording.Steps.Max(step => math.length(step.wind)), Is.EqualTo(2f).Within(0.3f), "m/s");
            AssertReplays("monarch", flight, pilot);
        }

        [UnityTest]
        public IEnumerator AFlightThatOthersDisturb_ReplaysToTheBit() => ReplaysWhatOthersDisturb("firefly");

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AnotherFlightThatOthersDisturb_ReplaysToTheBit() => ReplaysWhatOthersDisturb("dragonfly");

        private IEnumerator ReplaysWhatOthersDisturb(string name)
        {
            InsectFlight flight = Hatch(name);
            flight.transform.SetPositionAndRotation(new Vector3(3.7f, -2.1f, 11.3f), Quaternion.Euler(0f, 131f, 0f));
            flight.transform.localScale = new Vector3(1.7f, 1.7f, 1.7f);
            var pilot = new Backwards();
            flight.Pilot = pilot;
            yield return Frames(17);
            flight.StartRecording();
            pilot.Moments.Clear();
            Gust(0.3f, Quaternion.identity);
            yield return Frames(k_Frames / 2);
            flight.Aid = 0.5f;
            Physics.gravity = new Vector3(0f, -9f, 0.4f);
            flight.transform.SetPositionAndRotation(new Vector3(0f, 5f, 0f), Quaternion.Euler(0f, -40f, 0f));
            yield return Frames(k_Frames / 2);

            Assert.That(flight.Recorder.Recording.Pushes, Has.Count.EqualTo(1), "the object was moved once");
            AssertReplays(name, flight, pilot);
        }

        [UnityTest]
        public IEnumerator AFlightWithARigidbody_ReplaysToTheBit()
        {
            Time.captureDeltaTime = Time.fixedDeltaTime;
            InsectFlight flight = Hatch();
            flight.GetComponent<InsectWings>().UpdateMode = WingUpdateMode.FixedUpdate;
            Rigidbody body = flight.gameObject.AddComponent<Rigidbody>();
            var pilot = new Backwards();
            flight.Pilot = pilot;
            flight.StartRecording();
            yield return Frames(k_Frames / 2);
            body.AddForce(0.5f * InsectDefinition.UnitsPerMetre * Vector3.right, ForceMode.VelocityChange);
            yield return Frames(k_Frames / 2);

            AssertReplays("monarch", flight, pilot);
        }

        [UnityTest]
        public IEnumerator ARecording_EndsWhereTheInsectSits_AndStaysUntilTheNextOne()
        {
            InsectFlight flight = Hatch();
            flight.StartRecording();
            yield return Frames(30);
            flight.Pilot = new Sitter();
            yield return Frames(30);
            int steps = flight.Recorder.Recording.Steps.Count;
            Assert.That((flight.IsRecording, flight.Recorder.Ended), Is.EqualTo((false, "the insect sits")));
            yield return Frames(10);
            Assert.That(flight.Recorder.Recording.Steps, Has.Count.EqualTo(steps).And.Count.GreaterThan(10));

            flight.Pilot = null;
            flight.StartRecording();
            yield return Frames(10);
            Assert.That((flight.IsRecording, flight.State), Is.EqualTo((true, FlightState.Flying)));
            flight.enabled = false;
            Assert.That(flight.IsRecording, Is.False);
        }

        [UnityTest]
        public IEnumerator TheInspector_RecordsStopsAndSaves_AndTheCommandFliesTheFile()
        {
            InsectFlight flight = Hatch("firefly");
            using var run = new CommandRun();
            string file = Path.Combine(run.Folder, "scene.txt");
            var panel = new RecordingPanel(_ => file);
            Assert.That(DrawnInspector.Of(() => panel.Draw(flight)).Buttons, Is.EqualTo(new[] { "Record" }));

            DrawnInspector.Press(() => panel.Draw(flight), "Record");
            Assert.That(DrawnInspector.Of(() => panel.Draw(flight)).Buttons, Is.EqualTo(new[] { "Stop" }));
            flight.Velocity = new Vector3(0f, 0f, 0.5f);
            yield return Frames(60);
            DrawnInspector.Press(() => panel.Draw(flight), "Stop");
            DrawnInspector.Press(() => panel.Draw(flight), "Save Recording…");

            FlightRecording recording = flight.Recorder.Recording;
            Assert.That(File.ReadAllText(file), Is.EqualTo(RecordingText.Write(recording)));
            Assert.That(run.Run("fly", "--free", "--replay", file, "--no-pictures", "--out", run.Out), Is.Zero, run.Errors);
            string[] rows = File.ReadAllLines(Path.Combine(run.Out, "trajectory.csv"));
            Assert.That(rows, Has.Length.EqualTo(1 + recording.Steps.Count));
            Assert.That(run.Output, Does.Contain("Flown again"));
        }

        private WindZone Gust(float speed, Quaternion direction)
        {
            WindZone zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            zone.transform.rotation = direction;
            zone.windMain = speed * InsectDefinition.UnitsPerMetre;
            zone.windTurbulence = zone.windPulseMagnitude = 0f;
            WingSystem.FindWindZones();
            return zone;
        }

        private static void AssertReplays(string name, InsectFlight flight, Backwards pilot)
        {
            Assert.That(flight.Recorder.Ended, Is.Null);
            flight.StopRecording();
            string text = RecordingText.Write(flight.Recorder.Recording);
            FlightRecording recording = RecordingReader.Read(new StringReader(text));
            Assert.That(RecordingText.Write(recording), Is.EqualTo(text));

            InsectDefinition insect = InsectCatalogue.Find(name);
            using FlightModel authored = CatalogueFlight.CreateModel(insect);
            Assert.That(recording.Key, Is.EqualTo(authored.Key));
            using var model = new FlightModel(
                recording.PlacedWings(authored.Wings), insect.FlightParts, authored.Mass, authored.FluidDensity, authored.GravityShare);
            using TrimTable table = CatalogueFlight.CreateTable(insect, model);
            using FreeFlight again = recording.StartFlight(model, table);
            int push = 0;
            var moments = new List<Moment>();
            for (int step = 0; step < recording.Steps.Count; step++)
            {
                moments.Add(new Moment(again.Situation(0f)));
                recording.Fly(again, step, ref push);
            }

            // A push comes between the end of a step and the pilot's question.
            int[] pushed = recording.Pushes.Select(at => at.step).ToArray();
            Assert.That(moments, Has.Count.EqualTo(pilot.Moments.Count).And.Count.GreaterThan(k_Frames / 2));
            for (int step = 0; step < moments.Count; step++)
            {
                if (!pushed.Contains(step))
                    Assert.That(moments[step], Is.EqualTo(pilot.Moments[step]), $"step {step} of {moments.Count}");
            }
        }

        private readonly record struct Moment(float3 Velocity, quaternion Rotation, float3 Turning, float3 Reference)
        {
            public Moment(FlightSituation at) : this(at.velocity, at.rotation, at.angularVelocity, at.referenceVelocity)
            {
            }
        }

        /// <summary>Asks for what a butterfly cannot fly, as a script may: straight back at once, and ahead again.</summary>
        private sealed class Backwards : IFlightPilot
        {
            public List<Moment> Moments { get; } = [];

            public bool HasTumbled { get; private set; }

            public FlightCommand Command(in FlightSituation situation)
            {
                Moments.Add(new Moment(situation));
                HasTumbled |= situation.state == FlightState.Tumbling;
                return FlightCommand.Fly(
                    new float3(0.2f, -1f, Moments.Count / 40 % 2 == 0 ? 1.3f : -1.3f), Moments.Count > 60 ? 3f : float.NaN);
            }
        }

        private sealed class Sitter : IFlightPilot
        {
            public FlightCommand Command(in FlightSituation situation)
            {
                var command = FlightCommand.Fly(default);
                command.wish = FlightWish.Perch;
                command.spot = new PerchSpot { position = situation.position - new float3(0f, 0.4f, 0f), normal = new float3(0f, 1f, 0f) };
                return command;
            }
        }
    }
}
