using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flights
{
    /// <summary>
    /// Flights that go wrong or went wrong, as recordings beside this file: each is flown again twice with equal bits, and those that are
    /// mended stay so. A new one: record it with <c>fly --free --record</c> or in the inspector, put it here, add a line.
    /// </summary>
    public sealed class RecordedFlightsTests
    {
        /// <summary>Each file with its fault, and true where that is mended.</summary>
        private static readonly Dictionary<string, (string What, bool IsMended)> s_Flights = new()
        {
            ["swallowtail-slope-124.txt"] =
                ("tumbled where it braked and turned on its way to a slope, before trims met their wakes", true),
            ["monarch-gust-from-above.txt"] = ("tumbles in a gust of 2 m/s from above, without aid", false),
            ["monarch-behind.txt"] = ("tumbled on its way to a place a metre behind it, before trims met their wakes", true),
            ["monarch-below.txt"] = ("tumbled on its way to a place two metres below it, before commands were limited where they arrive",
                true),
        };

        private static string Folder => Path.Combine(PackageRoot.Find(), "Headless~", "Alate.Headless.Tests", "Flights");

        [Test]
        public void EveryRecording_HasALine() =>
            Assert.That(Directory.GetFiles(Folder, "*.txt").Select(Path.GetFileName), Is.EquivalentTo(s_Flights.Keys));

        [Test]
        public void ARecordedFlight_ReplaysToTheBit([ValueSource(nameof(Files))] string file)
        {
            var replay = Replay.Read(Path.Combine(Folder, file));
            List<FreeMoment> first = Fly(replay), second = Fly(replay);
            int tumbling = first.Count(at => at.State == FlightState.Tumbling);
            TestContext.Out.WriteLine($"{file}: {s_Flights[file].What}; now tumbling in {tumbling} of {first.Count} steps");

            Assert.That(second, Is.EqualTo(first));
            Assert.That(first.All(at => math.all(math.isfinite(at.Position)) && math.all(math.isfinite(at.AngularVelocity))));
            if (s_Flights[file].IsMended)
                Assert.That(tumbling, Is.Zero, s_Flights[file].What);
        }

        private static IEnumerable<string> Files() => s_Flights.Keys;

        private static List<FreeMoment> Fly(Replay replay) =>
            FreeRun.Fly(new FreePlan { Insect = replay.Species, Replay = replay }, _ => { }).Moments.ToList();
    }
}
