using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using Alate.Showcase;
using Alate.Sound;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Serialised numbers of all components, written while they play: each acts from the next step on, and none lets in what is no number.
    /// Crowds are tested where shaders are: in the headless tests.
    /// </summary>
    public sealed class KeyedFieldsTests : KeyedFixture
    {
        // What a key does not change, and why.
        private static readonly Dictionary<string, string> s_Exceptions = new Dictionary<string, string>
        {
            ["InsectWings.m_StartPhase"] = "where a beat starts, when it starts",
            ["InsectWings.m_Wings[0].m_Submesh"] = "which part of the mesh the wing is",
            ["InsectWings.m_Wings[0].m_Point"] = "a place on the wing, where one part of the mesh holds several",
            ["InsectWings.m_Wings[0].m_Side"] = "checked when the insect starts to live, and on a change of the list",
            ["InsectWings.m_Wings[0].m_Pair"] = "which wing leads, where there are four",
            ["InsectWings.m_Wings[0].m_IsFilledIn"] = "of the editor",
            ["InsectWings.m_Preview.shows"] = "of the editor, while the game does not play",
            ["InsectWings.m_Preview.beat"] = "of the editor, while the game does not play",
            ["InsectFlight.m_Parts[0].share"] = "taken over when the flight starts",
            ["InsectFlight.m_Parts[0].centre"] = "taken over when the flight starts",
            ["InsectFlight.m_Parts[0].halfAxes"] = "taken over when the flight starts",
            ["InsectFlight.m_Parts[0].swing"] = "taken over when the flight starts",
            ["InsectFlight.m_Parts[0].lowestPhase"] = "taken over when the flight starts",
            ["PerchPilot.m_Settings.leavesWhenTouched"] = "where something touches it",
            ["SplinePath.m_Points"] = "taken when the spline is read",
        };

        private static readonly float[] s_None = new float[0];

        private Camera m_Camera;
        private WindZone m_Zone;

        private static IEnumerable<Type> Components => SerialisedNumbers.Components(name => name != "Alate.Crowds")
            .Where(type => SerialisedNumbers.Of(type).Any());

        [TearDown]
        public void TakeTheCameraAway() => WingSystem.DetailCameras.Clear();

        [UnityTest]
        public IEnumerator EveryNumber_ActsFromTheNextStep([ValueSource(nameof(Components))] Type type) =>
            CheckActs(type, Scenes(type), s_Exceptions);

        [UnityTest]
        public IEnumerator WhatIsNoNumber_IsRefused([ValueSource(nameof(Components))] Type type) =>
            CheckHolds(type, Scenes(type)[0], s_Exceptions, s_FewBad);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator WhateverIsNoNumber_IsRefused([ValueSource(nameof(Components))] Type type) =>
            CheckHolds(type, Scenes(type)[0], s_Exceptions, s_Bad);

        private List<KeyedScene> Scenes(Type type)
        {
            var pilots = new KeyedPilots(made => Keep(made));
            switch (type.Name)
            {
                case nameof(InsectWings): return InsectScenes().ToList();
                case nameof(InsectFlight): return FlightScenes().ToList();
                case nameof(InsectHum): return new List<KeyedScene> { HumScene() };
                case nameof(AbdomenSwing): return new List<KeyedScene> { SwingScene() };
                case nameof(OrbitCamera): return new List<KeyedScene> { OrbitScene() };
                case nameof(FollowPilot): return pilots.Follow().ToList();
                case nameof(WanderPilot): return pilots.Wander().ToList();
                case nameof(PerchPilot): return pilots.Perch().ToList();
                case nameof(FlockPilot): return pilots.Flock().ToList();
                case "SplinePath": return new List<KeyedScene> { new KeyedScene(() => Keep(new GameObject()).transform, _ => s_None) };
                default: throw new NotSupportedException($"{type.Name} has no scene in which its numbers act.");
            }
        }

        private IEnumerable<KeyedScene> InsectScenes()
        {
            yield return new KeyedScene(() => Moving(VelocitySource.Script), StateOf) { Begin = Blow };

            // Sizes on the screen at which each threshold of the detail, if it moves, is passed.
            foreach (float height in new[] { 0.25f, 0.15f, 0.02f })
            {
                yield return new KeyedScene(() => Hatch(insect => insect.Quality.substepsPerBeat = 96), StateOf)
                {
                    Begin = () => LookFrom(QualitySettings.lodBias / (height * math.tan(math.radians(30f)))),
                    After = 30,
                };
            }

            yield return Jump(insect => insect.transform.position += new Vector3(100f, 0f, 0f));
            yield return Jump(insect => insect.transform.rotation = Quaternion.Euler(0f, 80f, 0f));
        }

        private KeyedScene Jump(Action<Component> jump) =>
            new KeyedScene(() => Moving(VelocitySource.Transform), StateOf) { Begin = Calm, Then = jump };

        private IEnumerable<KeyedScene> FlightScenes()
        {
            // A heading acts from the next beat on.
            yield return new KeyedScene(Flying, StateOf) { Begin = Calm, After = 10 };

            // A gust that it cannot hold against.
            yield return new KeyedScene(Flying, StateOf)
            {
                Then = flight => flight.GetComponent<InsectWings>().Air.wind = new Vector3(60f, 0f, 0f),
                After = 60,
            };
        }

        private KeyedScene SwingScene()
        {
            return new KeyedScene(Swinging, swing =>
            {
                Quaternion turn = swing.transform.localRotation;
                return new[] { turn.x, turn.y, turn.z, turn.w };
            });
        }

        private Component Swinging()
        {
            var abdomen = new GameObject("abdomen");
            abdomen.transform.SetParent(Hatch().transform, false);
            return abdomen.AddComponent<AbdomenSwing>();
        }

        private KeyedScene HumScene()
        {
            return new KeyedScene(Humming, Heard) { Begin = Calm };
        }

        private Component Humming()
        {
            InsectHum hum = Hatch().gameObject.AddComponent<InsectHum>();
            (hum.Volume, hum.FullPower) = (0.3f, 200f);
            return hum;
        }

        private static IEnumerable<float> Heard(Component component)
        {
            var hum = (InsectHum)component;
            float[] samples = new float[64];
            Array.Fill(samples, 1f);
            hum.OnAudioFilterRead(samples, 1);
            return samples.Append(hum.Level).Append(hum.Frequency);
        }

        private KeyedScene OrbitScene()
        {
            return new KeyedScene(() => Keep(new GameObject("eye", typeof(Camera))).AddComponent<OrbitCamera>(), orbit =>
            {
                Quaternion turned = orbit.transform.rotation;
                return Numbers(orbit.transform.position).Concat(new[] { turned.x, turned.y, turned.z, turned.w });
            });
        }

        private InsectWings Moving(VelocitySource source) => Hatch(insect =>
        {
            insect.Motion.source = source;
            insect.Velocity = new Vector3(1f, 2f, 9f);
        });

        private Component Flying()
        {
            InsectDefinition species = InsectCatalogue.Find("monarch");
            InsectWings wings = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            InsectFlight flight = CatalogueFlight.AddTo(wings, species);
            flight.Heading = 0.4f;
            return flight;
        }

        private void Blow()
        {
            Calm();
            m_Zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            m_Zone.mode = WindZoneMode.Directional;
            m_Zone.windMain = 7f;
            WingSystem.FindWindZones();
        }

        private void Calm()
        {
            WingSystem.DetailCameras.Clear();
            if (m_Zone != null)
                m_Zone.gameObject.SetActive(false);
            WingSystem.FindWindZones();
        }

        private void LookFrom(float distance)
        {
            Calm();
            if (m_Camera == null)
                m_Camera = Keep(new GameObject("camera")).AddComponent<Camera>();
            m_Camera.fieldOfView = 60f;
            m_Camera.farClipPlane = 1e5f;
            m_Camera.transform.position = -distance * Vector3.forward;
            WingSystem.DetailCameras.Add(m_Camera);
        }

        private static IEnumerable<float> StateOf(Component component)
        {
            InsectWings insect = component.GetComponent<InsectWings>();
            IEnumerable<float> state = Numbers(insect.transform.position).Concat(Numbers(insect.AirForce)).Append(insect.Phase);
            state = state.Append(Filter(insect, 0).sharedMesh.vertexAttributeCount);
            for (int wing = 0; insect.State == InsectState.Ready && wing < insect.Wings.Count; wing++)
            {
                WingReading reading = insect.Read(wing);
                for (int chain = 0; chain < reading.ChainCount; chain++)
                    state = state.Concat(Numbers(reading.JointPosition(chain, reading.JointsPerChain - 1)));
            }

            return state;
        }

        private static float[] Numbers(float3 vector) => new[] { vector.x, vector.y, vector.z };
    }
}
