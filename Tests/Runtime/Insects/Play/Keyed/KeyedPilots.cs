using System;
using System.Collections.Generic;
using Alate.Flight;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play
{
    /// <summary>Scenes of pilots, each of which flies a point with an insect's limits.</summary>
    internal sealed class KeyedPilots
    {
        private readonly Func<Object, Object> m_Keep;
        private readonly Dictionary<Component, List<(FlightPilot pilot, PointFlyer flyer)>> m_Flown =
            new Dictionary<Component, List<(FlightPilot, PointFlyer)>>();

        /// <param name="keep">Called with what is to be destroyed after the test.</param>
        public KeyedPilots(Func<Object, Object> keep) => m_Keep = keep;

        public IEnumerable<KeyedScene> Follow()
        {
            Transform target = Made("target").transform;
            target.position = new Vector3(3f, 4f, 20f);
            yield return Scene(Vector3.up, () =>
            {
                FollowPilot pilot = Pilot<FollowPilot>(Vector3.up);
                pilot.Target = target;
                pilot.Points.Add(Vector3.zero);
                return pilot;
            }, 60);
            yield return Scene(Vector3.up, () =>
            {
                FollowPilot pilot = Pilot<FollowPilot>(Vector3.up);
                pilot.Points.AddRange(new[] { new Vector3(0f, 4f, 6f), new Vector3(3f, 4f, 6f) });
                return pilot;
            }, 300);
        }

        public IEnumerable<KeyedScene> Wander()
        {
            yield return Scene(new Vector3(4f, 3f, -3f), () =>
            {
                WanderPilot pilot = Pilot<WanderPilot>(new Vector3(4f, 3f, -3f));
                pilot.Seed = 7;
                pilot.Volume = new FlightVolume(VolumeShape.Box, new Vector3(0f, 4f, 0f), new Vector3(24f, 6f, 24f));
                return pilot;
            }, 300);
        }

        public IEnumerable<KeyedScene> Perch()
        {
            yield return Ground(0f, pilot => pilot.Settings.stayTime = 1f);
            yield return Ground(0f, pilot => pilot.Settings.stayTime = 60f);
            yield return Ground(50f, _ => { });
            yield return Scene(new Vector3(0f, 6f, 0f), () =>
            {
                PerchPilot pilot = Percher();
                GameObject mark = Made("mark");
                mark.transform.SetParent(pilot.transform, false);
                mark.transform.position = new Vector3(0f, 0f, 40f);
                mark.AddComponent<PerchMark>();
                return pilot;
            }, 300);
            Transform watched = Made("watched").transform;
            watched.position = new Vector3(0f, 1f, -15f);
            yield return Ground(0f, pilot => pilot.Watched.Add(watched));
        }

        public IEnumerable<KeyedScene> Flock()
        {
            yield return Scene(Vector3.up, () =>
            {
                FlockPilot pilot = Pilot<FlockPilot>(Vector3.up);
                foreach (Vector3 place in new[] { new Vector3(2f, 1f, 0f), new Vector3(-5f, 3f, 1f), new Vector3(3f, 1f, 15f) })
                    Beside(pilot, place);
                return pilot;
            }, 60);
        }

        private void Beside(FlockPilot pilot, Vector3 place)
        {
            FlockPilot other = Pilot<FlockPilot>(place);
            other.transform.SetParent(pilot.transform, false);
            PointFlyer flyer = m_Flown[other][0].flyer;
            flyer.situation.referenceVelocity = flyer.situation.velocity = new float3(0.2f, 0.1f, 0.4f);
            m_Flown[pilot].AddRange(m_Flown[other]);
        }

        private KeyedScene Ground(float slope, Action<PerchPilot> prepare)
        {
            KeyedScene scene = Scene(new Vector3(0f, 6f, 0f), () =>
            {
                PerchPilot pilot = Percher();
                BoxCollider ground = Wall(Vector3.zero, new Vector3(60f, 1f, 60f));
                ground.transform.rotation = Quaternion.Euler(0f, 0f, slope);
                ground.transform.SetParent(pilot.transform, true);
                pilot.Settings.landsOnSurfaces = true;
                prepare(pilot);
                return pilot;
            }, 900);
            return scene;
        }

        private PerchPilot Percher()
        {
            PerchPilot pilot = Pilot<PerchPilot>(new Vector3(0f, 6f, 0f));
            pilot.Seed = 7;
            pilot.Settings.flightTime = 0.2f;
            return pilot;
        }

        // A wall is in the way of those that avoid obstacles.
        private KeyedScene Scene(Vector3 from, Func<FlightPilot> make, int frames)
        {
            return new KeyedScene(WithWall, StateOf) { IsAlone = true, Before = 5, After = frames, Step = Fly };

            Component WithWall()
            {
                FlightPilot pilot = make();
                if (!(pilot is PerchPilot))
                    Wall(from + new Vector3(0f, 0f, 8f), new Vector3(6f, 6f, 1f)).transform.SetParent(pilot.transform, true);
                return pilot;
            }
        }

        private void Fly(Component component)
        {
            foreach ((FlightPilot pilot, PointFlyer flyer) in m_Flown[component])
                flyer.Fly(pilot);
        }

        private IEnumerable<float> StateOf(Component component)
        {
            FlightSituation state = m_Flown[component][0].flyer.situation;
            float fold = component is PerchPilot perch ? perch.Fold : 0f;
            return new[]
            {
                state.position.x, state.position.y, state.position.z, state.velocity.x, state.velocity.y, state.velocity.z, state.heading,
                fold,
            };
        }

        private T Pilot<T>(Vector3 from) where T : FlightPilot
        {
            T pilot = Made(typeof(T).Name).AddComponent<T>();
            var flyer = new PointFlyer();
            flyer.situation.position = from;
            m_Flown.Add(pilot, new List<(FlightPilot, PointFlyer)> { (pilot, flyer) });
            return pilot;
        }

        private BoxCollider Wall(Vector3 place, Vector3 size)
        {
            BoxCollider wall = Made("wall").AddComponent<BoxCollider>();
            wall.transform.position = place;
            wall.size = size;
            return wall;
        }

        private GameObject Made(string name) => (GameObject)m_Keep(new GameObject(name));
    }
}
