using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Air beyond the strongest wind: what is said to be felt is what the model feels, and it is said where it is less.</summary>
    public sealed class FeltAirLaws
    {
        [Test]
        public void TheFeltAir_GivesTheForcesOfTheAirBeyondTheStrongestWind(
            [Values("monarch", "painted-lichen-moth", "firefly")] string species, [Values(4f, 10f, 40f)] float wind)
        {
            FlightRecord bound = Fly(wind, null, species);
            float felt = (float)FeltAir.Felt(bound.Wings[0], wind);
            float3 force = FlightSummary.Of(bound).MeanForce, same = FlightSummary.Of(Fly(felt, 1000f, species)).MeanForce,
                whole = FlightSummary.Of(Fly(wind, 1000f, species)).MeanForce;
            Assert.That(felt, Is.LessThan(0.98f * wind));
            Assert.That(math.length(same - force), Is.LessThan(0.005f * math.length(force)));
            Assert.That(math.length(whole - force), Is.GreaterThan(0.1f * math.length(force)));
        }

        [Test]
        public void AWingThatFeelsLess_IsNamed_WithBothSpeeds()
        {
            string[] lines = FlightSummary.Of(Fly(10f, null)).Plausibility.Doubts.ToArray();
            Assert.That(lines, Is.EqualTo(new[]
            {
                "The wing meets air at 10 m/s and feels 4.2 m/s of it, as its strongest wind is 3.2 m/s: are its forces wanted? "
                + "strongestWind 1000 takes the air as it is.",
            }));
            Assert.That(FlightSummary.Of(Fly(1f, null)).Plausibility.Doubts, Is.Empty);
            Assert.That(FlightSummary.Of(Fly(10f, 1000f)).Plausibility.Doubts, Is.Empty);
            Assert.That(FlightSummary.Of(PlannedFlight.Fly("monarch", "--wind", "0,0,-10", "--seconds", "0.2", "--preset", "paper"))
                .Plausibility.Doubts, Is.Empty, "the paper knows no strongest wind");
        }

        private static FlightRecord Fly(float wind, float? strongest, string species = "monarch") => TetheredFlight.Fly(new FlightPlan
        {
            Species = species,
            Speed = 0,
            Wind = [0, 0, -wind],
            Change = strongest is float most ? new ParameterChange(FlownParameters.Find("strongest-wind"), most) : null,
        });
    }
}
