using System.Collections;
using Alate.Editor;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects of the menu GameObject > Alate > Flying, in play.</summary>
    public sealed class FlyingMenuTests : PlayFixture
    {
        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AMonarch_WandersWhereItWasPut_WithoutAid() => Wander("monarch", 3);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AMonarch_WandersWhereItWasPut_WithoutAid_WhateverItsTrack([NUnit.Framework.Range(4, 27)] int seed) =>
            Wander("monarch", seed);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator AnyOtherInsect_WandersWhereItWasPut_WithoutAid(
            [Values("swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string name) => Wander(name, 3);

        private IEnumerator Wander(string name, int seed)
        {
            // A fixed step begins with the frame, as in a game that has just started: a flight depends on it.
            do
                yield return null;
            while (Time.time - Time.fixedTime > 1e-3f);
            InsectFlight flight = Keep(new InsectPlacing().Place(name, null, true)).GetComponent<InsectFlight>();
            flight.GetComponent<InsectWings>().Quality.culling = WingCulling.AlwaysSimulate;
            flight.GetComponent<WanderPilot>().Seed = seed;
            var place = new Vector3(100f, 2f, -40f);
            flight.transform.position = place;
            float farthest = 0f;
            for (int frame = 0; frame < 40 * 60; frame++)
            {
                yield return null;
                Vector3 way = flight.transform.position - place;
                farthest = Mathf.Max(farthest, way.magnitude);
                Assert.That(flight.State, Is.EqualTo(FlightState.Flying).Or.EqualTo(FlightState.Landing), $"frame {frame}");
                // A rim is kept to within 0.3 m of the real insect, which is drawn larger than it is.
                float rim = 0.5f * 40f + Mathf.Max(1f, 0.3f * flight.UnitsPerMetre);
                Assert.That(Mathf.Max(Mathf.Abs(way.x), Mathf.Abs(way.z)), Is.LessThan(rim), $"frame {frame}");
                Assert.That(way.y, Is.InRange(-2f, 17f), $"frame {frame}");
            }

            Assert.That(flight.Problem, Is.EqualTo(FlightProblem.None));
            Assert.That(flight.AidPower, Is.Zero);
            Assert.That(farthest, Is.GreaterThan(5f));
        }
    }
}
