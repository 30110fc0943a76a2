using System.Collections;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Insects that fly, far from the camera, out of its sight, and back.</summary>
    public sealed class FlightDetailTests : FlightFixture
    {
        private Camera m_Camera;

        [SetUp]
        public void MakeACamera()
        {
            m_Camera = Keep(new GameObject("camera")).AddComponent<Camera>();
            m_Camera.transform.position = new Vector3(0f, 0f, -12f);
            WingSystem.DetailCameras.Add(m_Camera);
        }

        [UnityTest]
        public IEnumerator OutOfSight_ItFliesOn_AndComesBackInFlight(
            [Values] bool hovers, [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update)] WingUpdateMode mode) =>
            GoAndComeBack("monarch", hovers, mode);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator OutOfSight_AFireflyFliesOn_AndComesBackInFlight(
            [Values] bool hovers, [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update)] WingUpdateMode mode) =>
            GoAndComeBack("firefly", hovers, mode);

        private IEnumerator GoAndComeBack(string name, bool hovers, WingUpdateMode mode)
        {
            InsectFlight flight = Hatch(name);
            InsectWings wings = flight.GetComponent<InsectWings>();
            wings.UpdateMode = mode;
            wings.Quality.culling = WingCulling.CullCompletely;
            flight.Velocity = hovers ? Vector3.zero : new Vector3(0.6f, 0f, 0f);
            yield return GoesOutOfSight(flight);
            Assert.That(wings.Detail, Is.EqualTo(WingDetail.Frozen));
            yield return KeepsItsWay(flight);

            yield return ComesBack(flight);
        }

        [UnityTest]
        public IEnumerator WhatItIsToldOutOfSight_AMonarchDoes([Values(0f, 1f)] float speed) => DoesWhatItIsTold("monarch", speed);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator WhatItIsToldOutOfSight_AFireflyDoes([Values(0f, 1f)] float speed) => DoesWhatItIsTold("firefly", speed);

        private IEnumerator DoesWhatItIsTold(string name, float speed)
        {
            InsectFlight flight = Hatch(name);
            InsectWings wings = flight.GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.CullCompletely;
            flight.Velocity = new Vector3(1f - speed, 0f, 0f);
            yield return GoesOutOfSight(flight);
            flight.Velocity = new Vector3(speed, 0f, 0f);
            yield return Frames(120);
            yield return ComesBack(flight);
        }

        [UnityTest]
        public IEnumerator FarAway_ItFliesOn_AndComesBackInFlight([Values("monarch")] string name, [Values] bool hovers)
        {
            InsectFlight flight = Hatch(name);
            InsectWings wings = flight.GetComponent<InsectWings>();
            flight.Velocity = hovers ? Vector3.zero : new Vector3(0.6f, 0f, 0f);
            yield return Frames(120);
            m_Camera.transform.position = new Vector3(0f, 0f, -150f * wings.Live.wings[0].placed.length);
            yield return Frames(30);
            Assert.That(wings.Detail, Is.GreaterThanOrEqualTo(WingDetail.WavesOnly));
            yield return KeepsItsWay(flight);
            yield return ComesBack(flight);
        }

        [UnityTest]
        public IEnumerator AtEveryDistance_AMonarchFlies() => FliesAtEveryDistance("monarch");

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AtEveryDistance_OthersFly([Values("firefly", "fishfly", "dragonfly")] string name) => FliesAtEveryDistance(name);

        private IEnumerator FliesAtEveryDistance(string name)
        {
            InsectFlight flight = Hatch(name);
            flight.Velocity = new Vector3(0.3f, 0f, 0f);
            yield return Frames(60);
            float length = flight.GetComponent<InsectWings>().Live.wings[0].placed.length;
            for (int frame = 0; frame < 900; frame++)
            {
                // From near to far and back.
                float distance = length * math.lerp(6f, 120f, 0.5f - 0.5f * math.cos(2f * math.PI * frame / 300f));
                m_Camera.transform.position = flight.Position + distance * Vector3.back;
                yield return null;
                Assert.That(flight.State, Is.EqualTo(FlightState.Flying), $"frame {frame}, {flight.GetComponent<InsectWings>().Detail}");
                float3 error = flight.BodyVelocity - flight.Velocity;
                Assert.That(math.length(error), Is.LessThan(0.7f), $"frame {frame}, {flight.GetComponent<InsectWings>().Detail}");
            }
        }

        private IEnumerator GoesOutOfSight(InsectFlight flight)
        {
            for (int frame = 0; frame < 120; frame++)
            {
                Follow(flight);
                yield return null;
            }

            m_Camera.transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            yield return Frames(3);
        }

        private static IEnumerator KeepsItsWay(InsectFlight flight)
        {
            Vector3 before = flight.Position;
            yield return Frames(120);
            Vector3 way = (flight.Position - before) / InsectDefinition.UnitsPerMetre;
            Assert.That((way - 120f * Time.deltaTime * flight.Velocity).magnitude, Is.LessThan(0.15f));
        }

        private IEnumerator ComesBack(InsectFlight flight)
        {
            m_Camera.transform.rotation = Quaternion.identity;
            Vector3 before = flight.Position;
            for (int frame = 0; frame < 180; frame++)
            {
                Follow(flight);
                yield return null;
                Assert.That(flight.State, Is.EqualTo(FlightState.Flying), $"frame {frame}");
            }

            Assert.That(flight.GetComponent<InsectWings>().Detail, Is.LessThan(WingDetail.WavesOnly));
            Vector3 way = (flight.Position - before) / InsectDefinition.UnitsPerMetre;
            Assert.That((way - 180f * Time.deltaTime * flight.Velocity).magnitude, Is.LessThan(0.25f));
        }

        private void Follow(InsectFlight flight)
        {
            float length = flight.GetComponent<InsectWings>().Live?.wings[0].placed.length ?? 1f;
            m_Camera.transform.position = flight.transform.position + 6f * length * Vector3.back;
        }
    }
}
