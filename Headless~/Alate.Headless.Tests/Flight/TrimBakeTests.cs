using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Small tables, baked in a second or two.</summary>
    public sealed class TrimBakeTests
    {
        [TestCase(0f)]
        [TestCase(0f, 0.15f, Explicit = true, Category = "Long")]
        public void AMonarchsTable_HoldsTrimsThatBalance_AndThatItFliesBy(params float[] climbs)
        {
            using var insect = new FlyingInsect("monarch");
            var lines = new List<string>();
            var bake = new TrimBake(insect.Model) { Log = lines.Add };
            using TrimTable table = bake.Bake([1f, 0.65f], [.. climbs.Reverse()]);

            Assert.That(bake.Problem, Is.Null);
            Assert.That((table.Speeds[0], table.Speeds[^1]), Is.EqualTo((0.65f, 1f)));
            Assert.That(table.ClimbRates, Is.EqualTo(climbs));
            Check(insect, table, lines, TrimSolver.Closed);
        }

        [Test, Explicit, Category("Long")]
        public void ASnailfishsTable_GetsASpeed_WhereItsTwoDoNotMix()
        {
            using var insect = new FlyingInsect("snailfish");
            var lines = new List<string>();
            using TrimTable table = new TrimBake(insect.Model) { Log = lines.Add }.Bake([0.35f, 0.15f], [0f]);

            Assert.That(table.Speeds, Is.Ordered.And.Length.GreaterThan(2));
            Assert.That((table.Speeds[0], table.Speeds[^1]), Is.EqualTo((0.15f, 0.35f)));
            // What a slow swimmer settles on is off the balance of forces by up to a tenth of its drag.
            Check(insect, table, lines, 0.2);
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void SpeedsThatNoTrimCloses_GiveNoTable_AndSayWhatIsMissing()
        {
            using var insect = new FlyingInsect("monarch");
            var bake = new TrimBake(insect.Model);

            Assert.That(bake.Bake([9f], [0f]), Is.Null);
            Assert.That(bake.Problem, Does.Contain("9 m/s"));
        }

        private static void Check(FlyingInsect insect, TrimTable table, List<string> lines, double closed)
        {
            using var solver = new TrimSolver(insect.Model);
            for (int s = 0; s < table.Speeds.Length; s++)
            {
                for (int c = 0; c < table.ClimbRates.Length; c++)
                {
                    var condition = new FlightCondition(table.Speeds[s], table.ClimbRates[c]);
                    Assert.That(table.IsClosed(s, c), $"{condition}");
                    float[] point = table.Point(s, c);
                    var trim = TrimState.Read(point, insect.Model.Frequency);
                    Assert.That(TrimSolver.Norm(solver.Residual(trim, condition, out _)), Is.LessThan(closed), $"{condition}");
                    Assert.That(point.Skip(TrimPoint.LongGains).Any(gain => gain != 0f), "gains");

                    // One line a point, which says the trim in degrees and hertz.
                    string line = lines.Single(told => told.StartsWith($"{condition}: pitch", StringComparison.Ordinal));
                    double[] told = Regex.Matches(line.Split(": ", 2)[1], @"-?\d+\.\d+")
                        .Select(number => double.Parse(number.Value, CultureInfo.InvariantCulture)).ToArray();
                    double[] degrees = new[] { trim.Pitch, trim.PitchBob, trim.Tilt, trim.MeanSweep }.Select(math.degrees).ToArray();
                    Assert.That(told, Is.EqualTo(new[]
                    {
                        degrees[0], degrees[1], trim.FrequencyScale * insect.Model.Frequency, trim.AmplitudeScale, degrees[2], degrees[3],
                    }).Within(0.06));
                    Assert.That(told[3], Is.EqualTo(trim.AmplitudeScale).Within(6e-4));
                }
            }

            Fly(insect, table, new FlightCondition(math.lerp(table.Speeds[0], table.Speeds[^1], 0.5f), 0f));
        }

        // From the trim on: three seconds without aid, the mean of the last one is what was asked for.
        private static void Fly(FlyingInsect insect, TrimTable table, FlightCondition condition)
        {
            using var flight = new FreeFlight(insect.Model, table, condition);
            var command = FlightCommand.Fly(new float3(0f, condition.Climb, condition.Speed), 0f);
            while (flight.Time < 2)
                flight.Step(command, 0.0125f);
            float3 from = flight.Position;
            double start = flight.Time;
            while (flight.Time < 3)
                flight.Step(command, 0.0125f);
            float3 mean = (flight.Position - from) / (float)(flight.Time - start);
            Assert.That(math.distance(mean, command.velocity), Is.LessThan(0.1f), $"{condition} flies by {mean}");
        }
    }
}
