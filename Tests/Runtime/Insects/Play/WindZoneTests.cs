using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Unity's wind zones blow on the wings.</summary>
    public sealed class WindZoneTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator ADirectionalWindZone_IsFelt_UnlessItIsNotWanted()
        {
            InsectWings insect = Insect(), sheltered = Insect();
            sheltered.Air.windZones = false;
            WindZone zone = Zone(WindZoneMode.Directional, 7f);
            zone.transform.rotation = Quaternion.Euler(0f, 90f, 0f);
            WingSystem.FindWindZones();
            yield return Frames(5);

            Assert.That(math.distance(insect.Live.flight.wind, new float3(7f, 0f, 0f)), Is.LessThan(1e-3f));
            Assert.That(math.length(sheltered.Live.flight.wind), Is.Zero);
            insect.Air.wind = new Vector3(0f, 0f, 2f);
            yield return Frames(3);
            Assert.That(math.distance(insect.Live.flight.wind, new float3(7f, 0f, 2f)), Is.LessThan(1e-3f));

            zone.gameObject.SetActive(false);
            yield return Frames(3);
            Assert.That(math.distance(insect.Live.flight.wind, new float3(0f, 0f, 2f)), Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator ASphericalWindZone_BlowsOutwards_AndEndsAtItsRadius()
        {
            InsectWings near = Insect(), far = Insect();
            near.transform.position = new Vector3(5f, 0f, 0f);
            far.transform.position = new Vector3(0f, 0f, 30f);
            Zone(WindZoneMode.Spherical, 8f).radius = 20f;
            WingSystem.FindWindZones();
            yield return Frames(5);

            Assert.That(near.Live.flight.wind.x, Is.EqualTo(8f * 0.75f).Within(1e-3f));
            Assert.That(math.length(far.Live.flight.wind), Is.Zero);
        }

        [UnityTest]
        public IEnumerator ATurbulentZone_GustsButDoesNotBlowBackwards()
        {
            InsectWings insect = Insect();
            WindZone zone = Zone(WindZoneMode.Directional, 10f);
            zone.windTurbulence = 1f;
            WingSystem.FindWindZones();
            float least = float.PositiveInfinity, most = 0f;
            for (int frame = 0; frame < 300; frame++)
            {
                yield return null;
                if (frame < 3)
                    continue;
                least = math.min(least, insect.Live.flight.wind.z);
                most = math.max(most, insect.Live.flight.wind.z);
            }

            Assert.That(most - least, Is.GreaterThan(2f));
            Assert.That(least, Is.GreaterThan(5f));
            Assert.That(most, Is.LessThan(15f));
        }

        [UnityTest]
        public IEnumerator AfterSomethingCame_ZonesAreLookedFor_OnceASecondHasPassed()
        {
            var zones = new WindZones();
            zones.Read(0f);
            Zone(WindZoneMode.Directional, 3f);
            zones.Invalidate();
            yield return Frames(57);
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.Zero);
            yield return Frames(5);
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.EqualTo(3f).Within(1e-5f));
            Zone(WindZoneMode.Directional, 4f);
            yield return Frames(70);
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.EqualTo(3f).Within(1e-5f), "nobody has told that one came");
            zones.Invalidate();
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.EqualTo(7f).Within(1e-5f));
        }

        private WindZone Zone(WindZoneMode mode, float main)
        {
            WindZone zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            zone.mode = mode;
            zone.windMain = main;
            zone.windTurbulence = zone.windPulseMagnitude = 0f;
            return zone;
        }
    }
}
