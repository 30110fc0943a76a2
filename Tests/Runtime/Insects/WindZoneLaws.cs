using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests
{
    /// <summary>Laws of the wind that zones make at places and times.</summary>
    public sealed class WindZoneLaws
    {
        private readonly List<GameObject> m_Objects = new List<GameObject>();

        [TearDown]
        public void DestroyZones()
        {
            m_Objects.ForEach(Object.DestroyImmediate);
            m_Objects.Clear();
        }

        [Test]
        public void ThePulse_IsASineOfItsFrequencyAboutTheMainWind()
        {
            WindZone zone = Zone(WindZoneMode.Directional, 6f);
            zone.windPulseMagnitude = 0.25f;
            zone.windPulseFrequency = 0.5f;
            for (float time = 0f; time < 4f; time += 0.125f)
            {
                float expected = 6f * (1f + 0.25f * math.sin(math.PI * time));
                Assert.That(math.distance(At(default, time), new float3(0f, 0f, expected)), Is.LessThan(1e-4f), $"at {time} s");
            }
        }

        [Test]
        public void Turbulence_StaysWithinAThirdOfTheWind_AndHasNoMean()
        {
            Zone(WindZoneMode.Directional, 9f).windTurbulence = 0.5f;
            const int count = 4000;
            float least = float.PositiveInfinity, most = float.NegativeInfinity, sum = 0f;
            var zones = new WindZones();
            for (int k = 0; k < count; k++)
            {
                zones.Read(0.05f * k);
                float wind = zones.At(default).z;
                least = math.min(least, wind);
                most = math.max(most, wind);
                sum += wind / count;
            }

            Assert.That(least, Is.InRange(7.5f, 7.7f), "9 · (1 − 0.5/3), met now and then");
            Assert.That(most, Is.InRange(10.3f, 10.5f));
            Assert.That(sum, Is.EqualTo(9f).Within(0.05f));
        }

        // Gusts are a wave: 0.2 of its phase a unit along each axis, 3 a second.
        [Test]
        public void Gusts_ComeAlong([Values(0, 1, 2)] int axis)
        {
            Zone(WindZoneMode.Directional, 9f).windTurbulence = 1f;
            for (float time = 0f; time < 3f; time += 0.3f)
            {
                float3 place = default;
                place[axis] = 1.5f;
                Assert.That(At(place, time).z, Is.EqualTo(At(default, time + 0.1f).z).Within(1e-3f));
            }

            Assert.That(math.abs(At(default, 1f).z - At(default, 1.4f).z), Is.GreaterThan(0.1f));
        }

        [Test]
        public void ASphere_BlowsOutwards_AndFadesEvenlyToItsRadius()
        {
            WindZone zone = Zone(WindZoneMode.Spherical, 8f);
            zone.transform.SetPositionAndRotation(new Vector3(3f, -2f, 1f), Quaternion.Euler(20f, 70f, 0f));
            zone.radius = 10f;
            float3 centre = zone.transform.position, way = math.normalize(new float3(1f, 2f, -2f));

            foreach ((float distance, float share) in new[] { (1e-3f, 1f), (2.5f, 0.75f), (5f, 0.5f), (9f, 0.1f), (10f, 0f), (12f, 0f) })
                Assert.That(math.distance(At(centre + distance * way, 0f), 8f * share * way), Is.LessThan(2e-3f), $"{distance} away");
            Assert.That(math.length(At(centre, 0f)), Is.Zero);
        }

        [Test]
        public void Zones_AddUp_EachAlongItsOwnForwardAxis()
        {
            Zone(WindZoneMode.Directional, 2f).transform.rotation = Quaternion.Euler(0f, 90f, 0f);
            Zone(WindZoneMode.Directional, 3f).transform.rotation = Quaternion.Euler(-90f, 0f, 0f);

            Assert.That(math.distance(At(new float3(7f, 8f, 9f), 0f), new float3(2f, 3f, 0f)), Is.LessThan(1e-4f));
        }

        // Made anew at once where it is asked for, or within a second where something may have come.
        [Test]
        public void AZoneThatCame_IsFound_WhenZonesAreForgotten()
        {
            var zones = new WindZones();
            zones.Read(0f);
            Zone(WindZoneMode.Directional, 3f);
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.Zero, "not looked for in each step");
            zones.Invalidate();
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.Zero, "not before a second has passed");
            zones.Forget();
            zones.Read(0f);
            Assert.That(math.length(zones.At(default)), Is.EqualTo(3f).Within(1e-5f));
        }

        [Test]
        public void AZoneThatIsOff_OrASphereOfNoSize_BlowsNowhere()
        {
            WindZone off = Zone(WindZoneMode.Directional, 3f), point = Zone(WindZoneMode.Spherical, 3f);
            off.gameObject.SetActive(false);
            point.radius = 0f;
            Assert.That(math.length(At(new float3(0.1f, 0f, 0f), 0f)), Is.Zero);
            point.radius = -2f;
            Assert.That(math.length(At(new float3(0.1f, 0f, 0f), 0f)), Is.Zero);
        }

        // Two waves of which one is 2.414 times as fast, at 3 radians a second and 0.2 a unit: a third of the wind at turbulence 1.
        [Test]
        public void Gusts_AreTheSumOfTwoWaves([Values(0.5f, 1f)] float turbulence)
        {
            Zone(WindZoneMode.Directional, 6f).windTurbulence = turbulence;
            for (int k = 0; k < 20; k++)
            {
                float time = 0.37f * k, phase = 3f * time + 0.2f * (k - 2f * k + 5f);
                float gust = 0.5f * (math.sin(phase) + math.sin(2.414f * phase + 1.3f));
                var place = new float3(k, -2f * k, 5f);
                Assert.That(At(place, time).z, Is.EqualTo(6f * (1f + turbulence / 3f * gust)).Within(1e-3f), $"at {time} s");
            }
        }

        [Test]
        public void ANumberBeyondAMillion_IsRefused([Values(0, 1, 2, 3)] int field, [Values(1e6f, -1e6f)] float most)
        {
            WindZone zone = Zone(WindZoneMode.Directional, 2f);
            var zones = new WindZones();
            Set(0.99f);
            zones.Read(0f);
            LogAssert.NoUnexpectedReceived();
            LogAssert.Expect(LogType.Warning, new Regex("'wind': a wind zone of main wind .* is refused"));
            Set(1.01f);
            zones.Read(0f);
            zones.Read(0f);
            LogAssert.NoUnexpectedReceived();
            float3 wind = zones.At(default);
            Set(0.99f);
            zones.Read(0f);
            Assert.That(wind, Is.EqualTo(zones.At(default)), "the last good one counts");

            void Set(float share)
            {
                float value = share * most;
                (zone.windMain, zone.windPulseMagnitude) = (field == 0 ? value : 2f, field == 1 ? value : 0f);
                (zone.windPulseFrequency, zone.windTurbulence) = (field == 2 ? value : 0f, field == 3 ? value : 0f);
            }
        }

        [Test]
        public void AZoneThatNeverHadGoodNumbers_DoesNotBlow([Values] bool byRadius)
        {
            WindZone zone = Zone(WindZoneMode.Spherical, byRadius ? 2f : float.NaN);
            zone.radius = byRadius ? float.PositiveInfinity : 10f;
            var zones = new WindZones();
            LogAssert.Expect(LogType.Warning, new Regex("'wind': a wind zone of .* is refused"));
            zones.Read(0f);
            Assert.That(zones.At(new float3(0f, 0f, 1f)), Is.EqualTo(default(float3)));
            (zone.windMain, zone.radius) = (2f, 10f);
            zones.Read(0f);
            Assert.That(zones.At(new float3(0f, 0f, 1f)).z, Is.EqualTo(1.8f).Within(1e-5f));
        }

        private static float3 At(float3 place, float time)
        {
            var zones = new WindZones();
            zones.Read(time);
            return zones.At(place);
        }

        private WindZone Zone(WindZoneMode mode, float main)
        {
            var made = new GameObject("wind");
            m_Objects.Add(made);
            WindZone zone = made.AddComponent<WindZone>();
            zone.mode = mode;
            zone.windMain = main;
            zone.windTurbulence = zone.windPulseMagnitude = 0f;
            return zone;
        }
    }
}
