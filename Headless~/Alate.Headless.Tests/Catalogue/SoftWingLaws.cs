using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Insects
{
    /// <summary>
    /// Softer wings twist more where the air meets them by their beat, and less where it meets them by the flight: on any insect.
    /// </summary>
    public sealed class SoftWingLaws
    {
        [TestCase("painted-lichen-moth", 0.0, true)]
        [TestCase("painted-lichen-moth", 1.3, false)]
        [TestCase("monarch", 1.3, true)]
        [TestCase("monarch", 5.0, false)]
        public void Twist_GrowsWithSoftness_WhereTheTipIsFasterThanTheFlight(string species, double speed, bool grows)
        {
            WingSummary soft = Fly(species, speed, 0.1), stiff = Fly(species, speed, 4);
            Assert.That(soft.TwistPpDeg / stiff.TwistPpDeg, grows ? Is.GreaterThan(1.1) : Is.LessThan(0.9));
            Assert.That(soft.TipBendMaxDeg, Is.GreaterThan(1.2 * stiff.TipBendMaxDeg), "tips bend more in any case");
        }

        // Its bend is of the beat, not of the air.
        [Test]
        public void TheMothsTips_BendAsFarInThinAir()
        {
            double inAir = Fly("painted-lichen-moth", 1.3, 1).TipBendMaxDeg;
            FlownParameter density = FlownParameters.Find("fluid-density");
            Assert.That(Fly(new FlightPlan { Species = "painted-lichen-moth", Change = new ParameterChange(density, 0.01f) }).TipBendMaxDeg,
                Is.EqualTo(inAir).Within(3).Percent);
        }

        [Test]
        public void AHeadWind_BendsAMonarchsTipMore_WithoutTheWave_AndLessWithIt()
        {
            double[] with = TipBends(ComparisonColumn.FullModel), without = TipBends(ComparisonColumn.NoWave);
            Assert.That(without[1], Is.GreaterThan(1.2 * without[0]));
            Assert.That(with[1], Is.LessThan(0.95 * with[0]));
        }

        // In still air and in 10 m/s.
        private static double[] TipBends(ComparisonColumn column) => new[] { 0.0, -10.0 }
            .Select(wind => Fly(new FlightPlan { Species = "monarch", Speed = 0, Wind = [0, 0, wind], Column = column }).TipBendMaxDeg)
            .ToArray();

        private static WingSummary Fly(string species, double speed, double elasticity) =>
            Fly(new FlightPlan { Species = species, Speed = speed, Elasticity = elasticity });

        private static WingSummary Fly(FlightPlan plan) => FlightSummary.Of(TetheredFlight.Fly(plan)).Main;
    }
}
