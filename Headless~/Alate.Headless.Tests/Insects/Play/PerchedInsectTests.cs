using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Insects of the catalogue fly to slopes, walls and ceilings, sit on them with their feet on the spot, and fly off; no wing passes
    /// through the surface.
    /// </summary>
    public sealed class PerchedInsectTests : PlayFixture
    {
        /// <summary>Insects that fly at one time.</summary>
        private const int k_AtOnce = 40;

        /// <summary>Spots on the way to which a swallowtail brakes and turns so that it tumbles, as two of 4,000 do.</summary>
        private static readonly int[] s_KnownTumbles = { 124 };

        /// <inheritdoc/>
        protected override bool KeepsParts => true;

        [UnityTest]
        public IEnumerator OnASlope_AMonarchSits_AndNoWingIsBelowIt() => Perch("monarch", 0.02f, 1);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator OnTwoHundredSlopes_InsectsSit_AndNoWingIsBelowThem(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string name,
            [Values(0.01f, 0.02f)] float step, [Values(1, 101)] int first) => Perch(name, step, 100, first);

        [UnityTest]
        public IEnumerator BelowACeiling_AMonarchHangs_AndNoWingPassesThroughIt() => Perch("monarch", 0.02f, 1, 1, 175f, 180f);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator OnWallsAndCeilings_InsectsSit_AndNoWingPassesThroughThem(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string name,
            [Values(0.01f, 0.02f)] float step) => Perch(name, step, 40, 1, 45f, 180f);

        [UnityTest]
        public IEnumerator OnAFlowerThatSways_AMonarchSits_AndGoesAlong() => Sway("monarch", 0.02f, 1);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator OnFortyFlowersThatSway_InsectsSit_AndGoAlong(
            [Values("monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly")] string name,
            [Values(0.01f, 0.02f)] float step) => Sway(name, step, 40);

        // Makes the recordings of the folder Flights.
        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator TheWayToASlope_IsRecorded(
            [Values("swallowtail")] string name, [Values(124)] int seed, [Values(0.01f, 0.02f)] float step)
        {
            Time.captureDeltaTime = step;
            InsectDefinition species = InsectCatalogue.Find(name);
            var visit = new PerchVisit(seed, Hatch(species), species, species.Wings[0].CreatePreset());
            visit.Flight.StartRecording();
            yield return Frames(20);
            visit.Begin(Slope(visit.Flight, Random.CreateFromIndex((uint)seed), 0f, 45f));
            while (visit.Flight.IsRecording && !visit.IsOver)
            {
                yield return null;
                visit.Add(step);
            }

            yield return Frames(50);
            visit.Flight.StopRecording();
            string file = Path.Combine(Path.GetTempPath(), $"{name}-slope-{seed}-{step}.txt");
            File.WriteAllText(file, RecordingText.Write(visit.Flight.Recorder.Recording));
            TestContext.Out.WriteLine($"{file}: {(visit.HasTumbled ? "tumbles" : "does not tumble")}, {visit.Flight.Recorder.Ended}");
        }

        private IEnumerator Perch(string name, float step, int count, int from = 1, float leastSlope = 0f, float mostSlope = 45f)
        {
            Time.captureDeltaTime = step;
            InsectDefinition species = InsectCatalogue.Find(name);
            WingPreset preset = species.Wings[0].CreatePreset();
            var visits = new List<PerchVisit>();
            for (int first = from; first < from + count; first += k_AtOnce)
            {
                var group = Enumerable.Range(first, Math.Min(k_AtOnce, from + count - first))
                    .Select(seed => new PerchVisit(seed, Hatch(species), species, preset)).ToList();
                KeepParts();
                yield return Frames(20);
                group.ForEach(visit =>
                    visit.Begin(Slope(visit.Flight, Random.CreateFromIndex((uint)visit.Seed), leastSlope, mostSlope)));
                while (group.Exists(visit => !visit.IsOver))
                {
                    yield return null;
                    group.ForEach(visit => visit.Add(step));
                }

                group.ForEach(visit => UnityEngine.Object.Destroy(visit.Flight.gameObject));
                visits.AddRange(group);
                yield return null;
            }

            int[] tumbled = visits.Where(visit => visit.HasTumbled).Select(visit => visit.Seed).ToArray();
            float lowest = visits.Min(visit => visit.LowestOfWings), offSpot = visits.Max(visit => visit.FeetOffSpot),
                fastest = visits.Max(visit => visit.LastSpeed);
            TestContext.Out.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{name}, {step} s: lowest wing {100f * lowest:0.0} mm over {count} slopes, feet {100f * offSpot:0.000} mm off, "
                + $"{fastest:0.00} m/s in the last step before the spot, {tumbled.Length} tumbled on the way"));
            Assert.That(tumbled, Is.SubsetOf(name == "swallowtail" ? s_KnownTumbles : Array.Empty<int>()),
                "spots on the way to which an insect tumbled");
        }

        // To and fro by a tenth of a metre once a second, each its own way.
        private IEnumerator Sway(string name, float step, int count)
        {
            Time.captureDeltaTime = step;
            InsectDefinition species = InsectCatalogue.Find(name);
            WingPreset preset = species.Wings[0].CreatePreset();
            var visits = Enumerable.Range(1, count).Select(seed => new PerchVisit(seed, Hatch(species), species, preset)).ToList();
            yield return Frames(20);
            foreach (PerchVisit visit in visits)
            {
                var random = Random.CreateFromIndex((uint)visit.Seed);
                PerchSpot spot = Slope(visit.Flight, random, 0f, 45f);
                SwayingMark mark = Keep(new GameObject("flower")).AddComponent<SwayingMark>();
                mark.Place(spot, 0.05f * InsectDefinition.UnitsPerMetre * random.NextFloat3Direction(), random.NextFloat(0f, 1f));
                visit.Begin(mark.GetComponent<PerchMark>());
            }

            while (visits.Exists(visit => !visit.IsOver))
            {
                // As the frame is drawn.
                yield return new WaitForEndOfFrame();
                visits.ForEach(visit => visit.Add(step));
            }

            float lowest = visits.Min(visit => visit.LowestOfWings), offSpot = visits.Max(visit => visit.FeetOffSpot),
                fastest = visits.Max(visit => visit.LastSpeed);
            TestContext.Out.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{name}, {step} s: lowest wing {100f * lowest:0.0} mm over {count} flowers, feet {100f * offSpot:0.000} mm off, "
                + $"{fastest:0.00} m/s in the last step before the spot"));
            Assert.That(visits.Where(visit => visit.HasTumbled).Select(visit => visit.Seed), Is.Empty);
        }

        // Within a metre of the insect, as a slope that it is above, or an overhang that it is below.
        private static PerchSpot Slope(InsectFlight flight, Random random, float least, float most)
        {
            float slope = math.radians(random.NextFloat(least, most)), way = random.NextFloat(0f, 2f * math.PI),
                from = random.NextFloat(0f, 2f * math.PI);
            var normal = new float3(math.sin(slope) * math.sin(way), math.cos(slope), math.sin(slope) * math.cos(way));
            float3 off = new float3(math.sin(from), 0f, math.cos(from)) * random.NextFloat(0f, 1.2f)
                + new float3(0f, random.NextFloat(0.35f, 0.8f), 0f);
            off.y *= normal.y < 0f ? -1f : 1f;
            off -= math.min(math.dot(off, normal) - 0.3f, 0f) * normal;
            return new PerchSpot
            {
                position = (float3)flight.Position - InsectDefinition.UnitsPerMetre * off,
                normal = normal,
                heading = random.NextFloat(-math.PI, math.PI),
            };
        }

        private InsectFlight Hatch(InsectDefinition species)
        {
            InsectWings wings = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            PerchPilot pilot = wings.gameObject.AddComponent<PerchPilot>();
            pilot.Seed = 1;
            pilot.Settings.flightTime = pilot.Settings.stayTime = 600f;
            return CatalogueFlight.AddTo(wings, species);
        }
    }
}
