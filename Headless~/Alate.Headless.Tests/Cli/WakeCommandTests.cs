using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Files and messages of the command wake, and wakes of published flights.</summary>
    public sealed class WakeCommandTests
    {
        private CommandRun m_Run;

        [OneTimeSetUp]
        public void Shed()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run(
                "wake", "dragonfly", "--variant", "flight", "--substeps", "24", "--span-panels", "5", "--steps", "16", "--no-pictures",
                "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        private string[][] Rows() => File.ReadAllLines(Path.Combine(m_Run.Out, "wake.csv")).Select(line => line.Split(',')).ToArray();

        private static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);

        [Test]
        public void Table_HasARowAWingAndStep_OfTheRightWings()
        {
            string[][] rows = Rows();
            Assert.That(rows.Length, Is.EqualTo(1 + 2 * 16));
            Assert.That(rows.Skip(1).Select(row => row[1]).Distinct(), Is.EqualTo(new[] { "right fore wing", "right hind wing" }));
            for (int k = 0; k < 16; k++)
                Assert.That(Number(rows[1 + 2 * k][0]), Is.EqualTo(k / 16.0).Within(1e-6));
        }

        [Test]
        public void WideCores_LiftAFewPercentMore()
        {
            using var run = new CommandRun();
            run.Run("wake", "dragonfly", "--variant", "flight", "--substeps", "24", "--span-panels", "5", "--steps", "16", "--no-pictures",
                "--wide-cores", "--out", run.Out);
            int up = Array.IndexOf(Rows()[0], "force_y_n");
            double wide = File.ReadAllLines(Path.Combine(run.Out, "wake.csv")).Skip(1).Sum(line => Number(line.Split(',')[up]));
            Assert.That(wide / Rows().Skip(1).Sum(row => Number(row[up])), Is.InRange(1.002, 1.1));
        }

        [Test]
        public void Inflow_IsTheMeanOfTheTable_AndItsWaves()
        {
            string[][] rows = Rows().Skip(1).Where(row => row[1] == "right hind wing").ToArray();
            using var json = JsonDocument.Parse(File.ReadAllText(Path.Combine(m_Run.Out, "inflow.json")));
            JsonElement wing = json.RootElement.GetProperty("wings")[1];
            Assert.That(wing.GetProperty("wing").GetString(), Is.EqualTo("right hind wing"));
            for (int axis = 0; axis < 3; axis++)
            {
                double[] values = rows.Select(row => Number(row[12 + axis])).ToArray();
                Assert.That(wing.GetProperty("mean_m_s")[axis].GetDouble(), Is.EqualTo(values.Average()).Within(2e-5));
                double cosine = 2.0 * values.Select((value, k) => value * Math.Cos(4.0 * Math.PI * k / 16.0)).Average();
                Assert.That(wing.GetProperty("cosine_2_m_s")[axis].GetDouble(), Is.EqualTo(cosine).Within(2e-5));
                double sine = 2.0 * values.Select((value, k) => value * Math.Sin(2.0 * Math.PI * k / 16.0)).Average();
                Assert.That(wing.GetProperty("sine_1_m_s")[axis].GetDouble(), Is.EqualTo(sine).Within(2e-5));
            }
        }

        [Test]
        public void Terminal_SetsTheMeansBesideThoseWithoutAWake()
        {
            Assert.That(m_Run.Output, Does.Contain("Dragonfly with its wake").And.Contain("lift / weight"));
            Assert.That(m_Run.Output, Does.Contain("power to the air, W/kg"));
            Assert.That(m_Run.Output, Does.Contain("wake.csv").And.Contain("inflow.json").And.Not.Contain("wake.png"));
            Assert.That(Directory.GetFiles(m_Run.Out).Select(Path.GetFileName),
                Is.EquivalentTo(new[] { "wake.csv", "span.csv", "inflow.json" }), "--no-pictures");
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void PictureAndAnimation_AreWritten_AndSound()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("wake", "monarch", "--view", "top", "--out", run.Out), Is.Zero, run.Errors);
            foreach (string file in new[] { "span.svg", "plane.csv", "plane.svg", "wake.png", "wake.glb" })
                Assert.That(run.Output, Does.Contain(file));
            Assert.That(PngTexts.Of(Path.Combine(run.Out, "wake.png")), Does.Contain("Monarch"));
            GlbLooksTests.Validate(Path.Combine(run.Out, "wake.glb"));
        }

        // Newton metres about the thorax: a wing's force acts between a third and all of its length out.
        [Test]
        public void Moments_AreThoseOfTheForces_AboutTheThorax()
        {
            double length = InsectCatalogue.Find("dragonfly").Wings[0].Outline.Length;
            foreach (string[] row in Rows().Skip(1).Where(row => row[1] == "right fore wing"))
            {
                double lift = Number(row[3]), roll = Number(row[7]);
                if (Math.Abs(lift) > 1e-3)
                    Assert.That(Math.Abs(roll / lift) / length, Is.InRange(0.3, 1.1), $"roll over the lift of {lift} N");
            }
        }

        // Newtons per metre over the length of a wing are the force of wake.csv, and what lifts turns as it should.
        [Test]
        public void StripsOfTheSpan_AreInMetresAndNewtons_AndLiftInTheDownstroke()
        {
            string[][] rows = [.. File.ReadAllLines(Path.Combine(m_Run.Out, "span.csv")).Skip(1).Select(line => line.Split(','))];
            Assert.That(rows.Length, Is.EqualTo(16 * 2 * 5));
            double length = InsectCatalogue.Find("dragonfly").Wings[0].Outline.Length;
            foreach (string[] wing in Rows().Skip(1).Where(row => row[1] == "right fore wing"))
            {
                string[][] strips = [.. rows.Where(row => row[0] == wing[0] && row[1] == wing[1])];
                for (int axis = 0; axis < 3; axis++)
                {
                    Assert.That(strips.Sum(row => Number(row[4 + axis])) * length / 5, Is.EqualTo(Number(wing[2 + axis])).Within(2e-6));
                    Assert.That(Number(wing[12 + axis]), Is.InRange(
                        strips.Min(row => Number(row[7 + axis])) - 1e-6, strips.Max(row => Number(row[7 + axis])) + 1e-6));
                }

                // Mostly the force follows the circulation of the third strip, Γ times the speed of some metres a second.
                double circulation = Number(strips[3][3]), force = Number(strips[3][5]);
                if (Math.Abs(circulation) > 0.02 && Math.Abs(force) > 0.05)
                    Assert.That(force / circulation, Is.InRange(0.3, 10.0), $"kg/m³ · m/s, at {wing[0]}");
            }
        }

        [Test]
        public void WithItsTrim_AnInsectCarriesItsWeight_WithoutTheWake()
        {
            FlightPlan plan = TrimmedFlight.Of(new FlightPlan { Species = "firefly", Speed = 1.0, Climb = 0.1, RecordsAir = true });
            Assert.That((plan.Variant, plan.Speed, plan.Climb), Is.EqualTo((InsectVariant.Flight, 1.0, 0.1)));
            FlightRecord flown = TetheredFlight.Fly(plan);
            double weight = flown.Wings[0].Wing.Preset.Size.insectMass * EarthGravity.Precise;

            Assert.That(plan.ToWorld(FlownLoads.Mean(flown)).y / weight, Is.EqualTo(1.0).Within(0.04));
        }

        // A stroke of 120 degrees up from 60 passes the middle; wings reach below a low ground.
        [TestCase("Right and left wings pass through each other, by up to", "--kinematics", "FILE")]
        [TestCase("the wings reach", "--ground", "0.001")]
        public void WingsThatAreInTheWay_AreRefused(string message, params string[] options)
        {
            using var run = new CommandRun();
            string file = run.Write("clap.json", """
                {"name": "clap", "source": "drawn", "frequencyHz": 28, "angles": "degrees", "wings": {"fore wing": {"strokePlane": 55,
                "flap": {"mean": 60, "harmonics": [[85, 0]]}, "sweep": 0, "pitch": {"mean": 0, "harmonics": [[30, 90]]}}}}
                """);
            string[] given = [.. options.Select(option => option == "FILE" ? file : option)];

            Assert.That(run.Run(["wake", "dragonfly", "--substeps", "12", "--no-pictures", "--out", run.Out, .. given]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain(message));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [TestCase("does not fly at 9 m/s ahead", "--speed", "9", Explicit = true, Category = "Long")]
        [TestCase("--pitch is for flights on the spot", "--pitch", "20")]
        [TestCase("--kinematics is for flights", "--kinematics", "x.json")]
        [TestCase("does not go with --variant expressive", "--variant", "expressive")]
        public void ATrimThatIsNone_IsNamed(string message, params string[] options)
        {
            using var run = new CommandRun();
            Assert.That(run.Run(["wake", "monarch", "--free", "--out", run.Out, .. options]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain(message));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [TestCase("--chord-panels goes with --method panels", "--chord-panels", "3")]
        [TestCase("--downwash goes with --method strips", "--method", "panels", "--downwash", "none")]
        [TestCase("rings of all wings is", "--method", "panels", "--chord-panels", "64", "--span-panels", "256")]
        [TestCase("--steps", "--steps", "3")]
        public void OptionsThatDoNotGo_AreNamed_AndLeaveNothing(string message, params string[] options)
        {
            using var run = new CommandRun();
            Assert.That(run.Run(["wake", "dragonfly", "--substeps", "12", "--out", run.Out, .. options]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain(message));
            Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        // The published flights by strips with the drag of a dragonfly's wing: a steady flight carries the weight.
        [TestCase(0)]
        [TestCase(1, Explicit = true, Category = "Long")]
        [TestCase(2, Explicit = true, Category = "Long")]
        public void WithItsWake_ADragonflyCarriesItsWeight(int number)
        {
            MeasuredDragonfly flight = MeasuredDragonfly.Flights[number];
            using WakeFlight wake = WakeForces.Shed(flight, 48, 3, 1, out DragonflyRun run);
            List<WakeMoment> beat = wake.Run(_ => { });
            Assert.That(beat.Average(at => at.Force.y) / flight.Weight, Is.EqualTo(1.0).Within(0.12));
            // Near that of the model without a wake, in the same units.
            Assert.That(beat.Average(at => at.Power) / flight.Mass, Is.EqualTo(run.Power.Average()).Within(20).Percent);
            Assert.That(wake.Wake.Failures, Is.Zero);
        }

        // Metres: a ground as far below as a wing is long is felt, one of twenty wing lengths below is not.
        [Test]
        public void AGround_IsFelt_AboutAWingLengthBelow()
        {
            FlightRecord record = TetheredFlight.Fly(new FlightPlan { Species = "dragonfly", Speed = 0, Substeps = 24 });
            double length = record.Wings.Max(wing => wing.Wing.Preset.WingLength);
            float[] lifts = [.. new double?[] { null, 20 * length, length }.Select(ground =>
            {
                using var wake = new WakeFlight(
                    record, new WakePlan { Beats = 2, SpanPanels = 5, StepsPerBeat = 16, Ground = ground });
                return wake.Run(_ => { }).Average(at => at.Force.y);
            })];

            Assert.That(lifts[1], Is.EqualTo(lifts[0]).Within(0.1).Percent);
            Assert.That(Math.Abs(lifts[2] / lifts[0] - 1f), Is.GreaterThan(0.005f));
        }

        // A stiff wing sheds the same wake whatever it meets; replayed, it has most of the wake's effect.
        [Test]
        public void ReplayedAtAStiffWing_TheAirActsAsTheWakeDoes()
        {
            var plan = new FlightPlan
            {
                Species = "dragonfly",
                Column = ComparisonColumn.RigidWing,
                Speed = 1.5,
                RecordsAir = true,
                Substeps = 24,
            };
            using var rounds = new WakeRounds(plan, Insect.Of(plan), new WakePlan { Beats = 2, Downwash = MeasuredDownwash.None });
            rounds.Run(_ => { });
            rounds.Run(_ => { });
            float3 still = rounds.All[0].Replayed, replayed = rounds.All[1].Replayed, wake = rounds.All[1].Wake;

            Assert.That(rounds.All[1].Change, Is.LessThan(1e-3));
            Assert.That(math.distance(wake, rounds.All[0].Wake), Is.LessThan(1e-4f));
            Assert.That(math.distance(replayed, wake), Is.LessThan(0.5f * math.distance(still, wake)));
        }

        // Each round is nearer to the one before.
        [Test]
        public void InRounds_FlightAndWakeSettle()
        {
            var plan = new FlightPlan
            {
                Species = "monarch",
                Variant = InsectVariant.Expressive,
                PitchDegrees = 20,
                RecordsAir = true,
                Substeps = 24,
            };
            using var rounds = new WakeRounds(
                plan, Insect.Of(plan), new WakePlan { Beats = 2, SpanPanels = 6, StepsPerBeat = 12, Downwash = MeasuredDownwash.None });
            int told = 0;
            for (int round = 0; round < 3; round++)
                rounds.Run(steps => told = steps);
            Assert.That(told, Is.EqualTo(rounds.Steps));
            Assert.That(rounds.All.Select(round => round.Change), Is.Ordered.Descending);
            Assert.That(rounds.All[2].Change, Is.LessThan(0.03));
            Assert.That(math.distance(rounds.All[2].Wake, rounds.All[1].Wake), Is.LessThan(0.02f));
            Assert.That(rounds.Still.Wings[0].Parameters.inflow.IsSet, Is.False);
            Assert.That(rounds.Wake.Flight.Wings[0].Parameters.inflow.IsSet, Is.True);
        }

        [Test]
        public void AnInflow_IsMirroredToTheOtherSide_AndInWingLengths()
        {
            var right = new WingInflow { mean = new float3(1f, 2f, 3f), sine2 = new float3(-4f, 5f, 6f) };
            var inflow = new FlightInflow(new Dictionary<(string, WingSide), WingInflow> { [("wing", WingSide.Right)] = right });
            WingInflow own = inflow.Of("wing", WingSide.Right, 0.5f);

            Assert.That(own.mean, Is.EqualTo(new float3(2f, 4f, 6f)));
            Assert.That(inflow.Of("wing", WingSide.Left, 0.5f), Is.EqualTo(own), "a left wing is simulated as a right one");
            Assert.That(inflow.Of("another", WingSide.Left, 0.5f).IsSet, Is.False);
            var left = new FlightInflow(new Dictionary<(string, WingSide), WingInflow> { [("wing", WingSide.Left)] = right });
            Assert.That(left.Of("wing", WingSide.Left, 1f).mean, Is.EqualTo(new float3(-1f, 2f, 3f)));
            Assert.That(left.Of("wing", WingSide.Right, 1f).sine2, Is.EqualTo(new float3(4f, 5f, 6f)));

            // Means count whole in the mean square, waves by half.
            Assert.That(inflow.Size, Is.EqualTo(Math.Sqrt(14 + 0.5 * 77)).Within(1e-5));
            Assert.That(inflow.ChangeFrom(null), Is.EqualTo(1.0));
            Assert.That(inflow.ChangeFrom(inflow), Is.Zero);
            FlightInflow far = inflow.Towards(new FlightInflow(inflow.Wings.ToDictionary(wing => wing.Key, wing => wing.Value * 3f)), 0.5f);
            Assert.That(far.Wings[("wing", WingSide.Right)].mean, Is.EqualTo(new float3(2f, 4f, 6f)));
            Assert.That(far.ChangeFrom(inflow), Is.EqualTo(0.5).Within(1e-6));
        }

        [Test]
        public void WithoutSymmetry_AllWingsShed_AndAgreeWithTheMirroredOnes()
        {
            FlightRecord record = TetheredFlight.Fly(new FlightPlan { Species = "dragonfly", Substeps = 24, Speed = 1.3 });
            var plan = new WakePlan { Beats = 1, SpanPanels = 5, StepsPerBeat = 16, Method = WakeMethod.Panels, ChordPanels = 2 };
            using var half = new WakeFlight(record, plan);
            // A breath from the side that changes nothing but which wings are computed.
            FlightRecord blown = TetheredFlight.Fly(
                new FlightPlan { Species = "dragonfly", Substeps = 24, Speed = 1.3, Wind = [1e-6, 0, 0] });
            using var whole = new WakeFlight(blown, plan);
            List<WakeMoment> mirrored = half.Run(_ => { }), all = whole.Run(_ => { });
            Assert.That(half.Wings, Has.Count.EqualTo(2));
            Assert.That(whole.Wings, Has.Count.EqualTo(4));
            for (int k = 0; k < mirrored.Count; k++)
            {
                float size = math.length(mirrored[k].Force) + 1e-3f;
                Assert.That(math.length(mirrored[k].Force - all[k].Force) / size, Is.LessThan(0.01f));
                Assert.That(all[k].Power, Is.EqualTo(mirrored[k].Power).Within(0.01 * Math.Abs(mirrored[k].Power) + 1e-4));
            }
        }
    }
}
