using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Files of a free flight of the command line.</summary>
    public sealed class FreeFlyTests
    {
        private CommandRun m_Run;

        [OneTimeSetUp]
        public void Fly()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run(
                "fly", "monarch", "--free", "--to", "0.3,0.2,1", "--gust", "1,0,0", "--seconds", "4", "--unguarded", "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Folder_HoldsPathForcesPictureAndScene() => Assert.That(
            Directory.GetFileSystemEntries(m_Run.Out).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "trajectory.csv", "forces.csv", "path.png", "flight.glb", "summary.json" }));

        [Test]
        public void Trajectory_HasARowAStep_WithAllColumnsFilled()
        {
            string[][] rows = Table("trajectory.csv");

            Assert.That(rows[0].Take(7), Is.EqualTo(new[] { "time_s", "x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s" }));
            Assert.That(rows[0], Is.SupersetOf(new[] { "heading_deg", "pitch_deg", "roll_deg", "wx_rad_s", "phase_deg", "frequency_hz",
                "half_flap_deg", "aid_w", "state" }));
            Assert.That(rows, Has.Length.EqualTo(1 + 200));
            Assert.That(rows.Select(row => row.Length), Is.All.EqualTo(rows[0].Length));
            Assert.That(Column(rows, "time_s"), Is.Ordered.Ascending);
            Assert.That(Column(rows, "time_s").Last(), Is.EqualTo(4.0).Within(1e-4));
            Assert.That(Column(rows, "aid_w"), Is.All.Zero, "the aid is 0 by default");
            Assert.That(Column(rows, "z_m").Last(), Is.GreaterThan(0.5), "it is on its way");
        }

        [Test]
        public void Forces_CarryTheWeight_AndTellTheHalfStroke()
        {
            string[][] rows = Table("forces.csv");
            double[] lift = Column(rows, "lift_n");
            int half = Array.IndexOf(rows[0], "half_stroke");

            Assert.That(rows[0], Is.SupersetOf(new[] { "time_s", "force_x_n", "moment_x_nm", "lift_n", "drag_n", "power_w" }));
            Assert.That(rows, Has.Length.EqualTo(1 + 200));
            Assert.That(rows.Skip(1).Select(row => row[half]).Distinct(), Is.EquivalentTo(new[] { "down", "up" }));
            using FlightModel monarch = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
            double[] rise = Column(Table("trajectory.csv"), "vy_m_s");
            double faster = (rise[^1] - rise[0]) / (4 * EarthGravity.Size);
            Assert.That(lift.Average() / monarch.Weight, Is.EqualTo(1 + faster).Within(0.01), "the weight, and what it speeds up by");
        }

        [Test]
        public void TheReport_SaysHowFarHowOffAndAtWhichPower()
        {
            string[][] way = Table("trajectory.csv"), air = Table("forces.csv");
            double[] lift = Column(air, "lift_n"), power = Column(air, "power_w");
            double off = Math.Sqrt(new[] { "vx", "vy", "vz" }.Sum(axis => Column(way, $"{axis}_m_s").Zip(Column(way, $"wanted_{axis}_m_s"),
                (now, wanted) => (now - wanted) * (now - wanted)).Average()));
            int half = Array.IndexOf(air[0], "half_stroke");
            double up = lift.Where((_, k) => air[k + 1][half] == "up").Sum() / lift.Sum();
            using FlightModel monarch = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
            string number = @"(-?[\d.]+)";
            double[] told =
            [
                .. System.Text.RegularExpressions.Regex.Match(m_Run.Output,
                    $"^Monarch: {number} s by its own wings, from the origin to {number}, {number}, {number} m; "
                    + $"velocity off by {number} m/s \\(bob and all\\)\n"
                    + $"mean lift {number} of the weight, {number} % of it on the upstroke; "
                    + $"power {number} mW; aid {number} mW\n").Groups.Values.Skip(1).Select(group => double.Parse(group.Value,
                        CultureInfo.InvariantCulture)),
            ];
            double[] expected =
            [
                4, Column(way, "x_m").Last(), Column(way, "y_m").Last(), Column(way, "z_m").Last(), off, lift.Average() / monarch.Weight,
                    100 * up,
                1000 * power.Average(), 1000 * Column(way, "aid_w").Average(),
            ];

            Assert.That(told, Has.Length.EqualTo(expected.Length), m_Run.Output);
            double[] rounding = [0.01, 0.006, 0.006, 0.006, 0.0006, 0.0006, 0.6, 0.001, 0.001];
            for (int k = 0; k < told.Length; k++)
                Assert.That(told[k], Is.EqualTo(expected[k]).Within(rounding[k]), $"{k}");
            Assert.That(m_Run.Output.Split('\n'), Is.SupersetOf(new[] { "trajectory.csv", "forces.csv", "path.png", "flight.glb" }
                .Select(file => "  " + Path.Combine(m_Run.Out, file))));
        }

        [Test]
        public void TheSummary_HasTheFlightInNumbers()
        {
            JsonElement summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(m_Run.Out, "summary.json"))).RootElement;
            string[][] way = Table("trajectory.csv");

            Assert.That(summary.GetProperty("species").GetString(), Is.EqualTo("monarch"));
            Assert.That(summary.GetProperty("seconds").GetDouble(), Is.EqualTo(4.0).Within(1e-4));
            Assert.That(summary.GetProperty("end_m").EnumerateArray().Select(at => at.GetDouble()),
                Is.EqualTo(new[] { Column(way, "x_m").Last(), Column(way, "y_m").Last(), Column(way, "z_m").Last() }).Within(1e-5));
            Assert.That(summary.GetProperty("power_w").GetDouble(),
                Is.EqualTo(Column(Table("forces.csv"), "power_w").Average()).Within(1e-5));
            // A monarch that is to climb at once in a gust, and does as told, tumbles; each of its rows is in a tumble.
            int state = Array.IndexOf(way[0], "state");
            double[] times = Column(way, "time_s");
            JsonElement[] tumbles = [.. summary.GetProperty("tumbles").EnumerateArray()];
            int rows = way.Skip(1).Count(row => row[state].Equals("tumbling", StringComparison.OrdinalIgnoreCase));
            Assert.That(rows, Is.GreaterThan(0));
            Assert.That(tumbles.Sum(tumble => tumble.GetProperty("seconds").GetDouble()),
                Is.EqualTo(rows * times[0]).Within(times[0] + 1e-3), "steps");
            Assert.That(m_Run.Output, Does.Contain($"\nit tumbled {(tumbles.Length == 1 ? "once" : $"{tumbles.Length} times")}, "));
        }

        [Test]
        public void ATumble_IsToldInWords() => Assert.That(
            FreeReport.Tumbles(
            [
                new FlightTumble { time = 1.5, seconds = 0.2f, distance = 0.1f },
                new FlightTumble { time = 3, seconds = 0.5f, distance = 0.7f },
            ]),
            Is.EqualTo("it tumbled 2 times, 0.70 s in all; the longest time at 3.00 s, for 0.50 s and 0.70 m"));

        // The reader of the tests is as strict as a validator about chunks, views, accessors and alignment.
        [Test]
        public void Scene_IsSound_MovesTheInsect_AndBeatsItsWings()
        {
            var file = new GlbFile(File.ReadAllBytes(Path.Combine(m_Run.Out, "flight.glb")));
            JsonElement[] channels = file.Root.GetProperty("animations").EnumerateArray()
                .SelectMany(animation => animation.GetProperty("channels").EnumerateArray()).ToArray();
            JsonElement animation = file.Root.GetProperty("animations")[0];

            for (int accessor = 0; accessor < file.AccessorCount; accessor++)
                Assert.That(file.Read(accessor), Is.All.InRange(-1e6, 1e6), $"accessor {accessor} is finite");
            Assert.That(channels.Select(channel => channel.GetProperty("target").GetProperty("path").GetString()).Distinct(),
                Is.EquivalentTo(new[] { "translation", "rotation", "weights" }));
            foreach (JsonElement sampler in animation.GetProperty("samplers").EnumerateArray())
            {
                int times = sampler.GetProperty("input").GetInt32();
                Assert.That(file.Read(times), Is.Ordered.Ascending.And.Unique);
                Assert.That(file.Accessor(times).TryGetProperty("min", out _) && file.Accessor(times).TryGetProperty("max", out _),
                    "times have bounds");
            }

            int root = file.Root.GetProperty("nodes").EnumerateArray().Count() - 1;
            JsonElement turn = channels.Single(channel => channel.GetProperty("target").GetProperty("path").GetString() == "rotation"
                && channel.GetProperty("target").GetProperty("node").GetInt32() == root);
            double[] rotations = file.Read(
                animation.GetProperty("samplers")[turn.GetProperty("sampler").GetInt32()].GetProperty("output").GetInt32());
            for (int k = 0; k < rotations.Length; k += 4)
            {
                Assert.That(
                    rotations.Skip(k).Take(4).Sum(part => part * part), Is.EqualTo(1.0).Within(1e-5), "rotations are unit quaternions");
            }
        }

        [Test]
        public void Picture_IsAPng() =>
            Assert.That(File.ReadAllBytes(Path.Combine(m_Run.Out, "path.png")).Take(4), Is.EqualTo(new byte[] { 0x89, 0x50, 0x4e, 0x47 }));

        [Test]
        public void OneSeed_GivesOneTrack_AndAnotherAnother()
        {
            string[] flown = Track(7);

            Assert.That(Track(7), Is.EqualTo(flown));
            Assert.That(Track(8), Is.Not.EqualTo(flown));
        }

        [Test]
        public void Seed_IsThatOfTheTrack()
        {
            var command = new Command("fly");
            var options = new FreeOptions();
            options.AddTo(command);

            FreePlan plan = options.Plan(command.Parse("--free --pilot wander --seed 7"), "monarch", 1, "out");

            Assert.That((plan.Pilot, plan.Seed), Is.EqualTo((FreePilot.Wander, 7)));
        }

        [Test]
        public void Erratic_IsThatOfTheTrack_AndStandsInTheSummary()
        {
            using var run = new CommandRun();
            string[][] tracks = [.. new[] { "0", "1" }.Select(erratic =>
            {
                string folder = Path.Combine(run.Folder, erratic);
                string[] words = ["fly", "monarch", "--free", "--pilot", "wander", "--erratic", erratic, "--seconds", "0.6"];
                Assert.That(run.Run([.. words, "--no-pictures", "--out", folder]), Is.Zero, run.Errors);
                using var summary = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "summary.json")));
                Assert.That(summary.RootElement.GetProperty("options").GetProperty("erratic").GetRawText(), Is.EqualTo(erratic));
                return File.ReadAllLines(Path.Combine(folder, "trajectory.csv"));
            })];
            Assert.That(tracks[0], Is.EqualTo(Track(1, 0.6)));
            Assert.That(tracks[1], Is.EqualTo(Track(1, 0.6, 1)).And.Not.EqualTo(tracks[0]));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void TheCommand_FliesTheTrackOfItsSeed()
        {
            using var run = new CommandRun();
            Assert.That(run.Run(
                    "fly", "monarch", "--free", "--pilot", "wander", "--seed", "7", "--seconds", "0.3", "--no-pictures", "--out", run.Out),
                Is.Zero, run.Errors);
            Assert.That(File.ReadAllLines(Path.Combine(run.Out, "trajectory.csv")), Is.EqualTo(Track(7)));
        }

        private static string[] Track(int seed, double seconds = 0.3, double erratic = 0)
        {
            var plan = new FreePlan
            {
                Insect = InsectCatalogue.Find("monarch"),
                Pilot = FreePilot.Wander,
                Seed = seed,
                Seconds = seconds,
                Erratic = erratic,
            };
            return [.. TrajectoryTable.Of(FreeRun.Fly(plan, _ => { })).Select(row => string.Join(",", row))];
        }

        private string[][] Table(string name) => File.ReadAllLines(Path.Combine(m_Run.Out, name)).Select(line => line.Split(',')).ToArray();

        private static double[] Column(string[][] rows, string name)
        {
            int column = Array.IndexOf(rows[0], name);
            return rows.Skip(1).Select(row => double.Parse(row[column], CultureInfo.InvariantCulture)).ToArray();
        }
    }
}
