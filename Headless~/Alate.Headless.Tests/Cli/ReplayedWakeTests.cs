using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Air of a wake that is replayed at the wings as mean and two harmonics, against the wake itself.</summary>
    public sealed class ReplayedWakeTests
    {
        [TestCase("monarch", 1.3)]
        [TestCase("firefly", 0.0)]
        [TestCase("swallowtail", 1.3, Explicit = true, Category = "Long,Faults")]
        [TestCase("firefly", 1.3, Explicit = true, Category = "Long,Faults")]
        [TestCase("fishfly", 1.3, Explicit = true, Category = "Long,Faults")]
        [TestCase("painted-lichen-moth", 1.3, Explicit = true, Category = "Long,Faults")]
        [TestCase("dragonfly", 1.3, Explicit = true, Category = "Long,Faults")]
        [TestCase("fishfly", 0.0, Explicit = true, Category = "Long,Faults")]
        [TestCase("dragonfly", 0.0, Explicit = true, Category = "Long,Faults")]
        public void TheLiftOfAWake_IsThatOfItsAirReplayed(string name, double speed)
        {
            FlightPlan plan = TrimmedFlight.Of(new FlightPlan
            {
                Species = name,
                Variant = InsectVariant.Flight,
                Speed = speed,
                RecordsAir = true,
                Substeps = 192,
            });
            using var rounds = new WakeRounds(plan, Insect.Of(plan), new WakePlan());
            for (int round = 0; round < 3; round++)
                rounds.Run(_ => { });

            WakeRound last = rounds.All[^1];
            TestContext.Out.WriteLine(System.FormattableString.Invariant(
                $"{name} at {speed} m/s: {rounds.All[0].Replayed.y:0.000} without, {last.Wake.y:0.000} with the wake, ")
                + System.FormattableString.Invariant($"{last.Replayed.y:0.000} replayed; {100.0 * last.Change:0.0} %"));
            Assert.That(last.Replayed.y, Is.EqualTo(last.Wake.y).Within(0.03), "of the weight");
            Assert.That(last.Change, Is.LessThan(0.03), "the third round is all but the last one");
        }

        // With slender cores the monarch's is another one in each beat.
        [TestCase("monarch")]
        [TestCase("painted-lichen-moth")]
        public void OfWideCores_TheWakeOfAHover_SettlesInThreeRounds(string name)
        {
            FlightPlan plan = TrimmedFlight.Of(
                new FlightPlan { Species = name, Variant = InsectVariant.Flight, RecordsAir = true, Substeps = 192 });
            using var rounds = new WakeRounds(plan, Insect.Of(plan), new WakePlan { HasWideCores = true, Beats = 10 });
            for (int round = 0; round < 3; round++)
                rounds.Run(_ => { });

            Assert.That(rounds.All[^1].Change, Is.LessThan(0.01));
            Assert.That(rounds.All[^1].Wake.y, Is.EqualTo(rounds.All[^2].Wake.y).Within(0.003), "of the weight");
            Assert.That(rounds.All[^1].Replayed.y, Is.EqualTo(rounds.All[^1].Wake.y).Within(0.05), "as the page says");
        }
    }
}
