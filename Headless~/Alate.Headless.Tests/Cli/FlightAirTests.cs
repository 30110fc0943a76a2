using System;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Mean force and moment of a flight, and the line about wings that are driven outside what they bear.</summary>
    public sealed class FlightAirTests
    {
        private const string k_Overstretched = "is driven outside what it bears";

        [Test]
        public void InASymmetricFlight_NothingPushesSideways_OrTurnsThatWay()
        {
            var level = FlightSummary.Of(MonarchFlight.Level);

            Assert.That(math.abs(level.MeanForce.x), Is.LessThan(1e-6f * math.length(level.MeanForce)));
            Assert.That(math.abs(level.MeanMoment.y), Is.LessThan(1e-6f * math.abs(level.MeanMoment.x)));
            Assert.That(math.abs(level.MeanMoment.z), Is.LessThan(1e-6f * math.abs(level.MeanMoment.x)));
        }

        [Test]
        public void WindFromTheLeft_PushesToTheRight()
        {
            var blown = FlightSummary.Of(MonarchFlight.Fly(new FlightPlan { Species = "monarch", Wind = [2, 0, 0] }));

            Assert.That(blown.MeanForce.x, Is.GreaterThan(0f));
            Assert.That(math.abs(blown.MeanMoment.z), Is.GreaterThan(1e-3f * math.abs(blown.MeanMoment.x)));
        }

        [Test]
        public void ABodyNoseUp_IsLifted()
        {
            var climbing = FlightSummary.Of(MonarchFlight.Fly(new FlightPlan { Species = "monarch", PitchDegrees = 20 }));

            Assert.That(climbing.MeanForce.y, Is.GreaterThan(0f));
            Assert.That(climbing.LiftOverWeight, Is.GreaterThan(0.5));
        }

        [Test]
        public void WhereWingsHold_NothingIsSaid()
        {
            var level = FlightSummary.Of(MonarchFlight.Level);

            Assert.That(level.IsOverstretched, Is.False);
            Assert.That(Shown(level), Does.Not.Contain(k_Overstretched));
        }

        [Test]
        public void AWingThatTears_IsOneLine_WithItsStretchAndWhatToChange()
        {
            var torn = FlightSummary.Of(MonarchFlight.Fly(new FlightPlan { Species = "firefly", Wind = [0, 0, -10] }.AsVersion01()));
            string line = Shown(torn).Split('\n').Single(text => text.Contains(k_Overstretched));

            Assert.That(torn.IsOverstretched);
            Assert.That(line, Does.StartWith("The hind wing").And.Contain("Lower the wind or the speed"));
            Assert.That(line, Does.Contain(FormattableString.Invariant($"{torn.Overstretched.EdgeStretchMaxPct:0} %")));
        }

        private static string Shown(FlightSummary summary)
        {
            using var output = new StringWriter();
            new Terminal(output).ShowSummary(summary, "out");
            return output.ToString();
        }
    }
}
