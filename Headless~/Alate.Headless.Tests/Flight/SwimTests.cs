using System.Globalization;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>The snailfish swims: the water carries it, its fins balance its drag.</summary>
    public sealed class SwimTests
    {
        [TestCase(0.15f)]
        [TestCase(0.2f)]
        [TestCase(0.25f)]
        public void TheSnailfish_KeepsItsSpeed_AndItsFinsLiftNothing(float speed)
        {
            using var fish = new FlyingInsect("snailfish");
            var swim = FlightMeans.Fly(fish.Model, fish.Table, new FlightCondition(speed, 0f));

            TestContext.Out.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{speed} m/s: off by {1e3 * swim.Error:0.00} mm/s, pitch {swim.Pitch:0.0} ± {swim.PitchBob:0.0}°, "
                + $"{swim.Frequency:0.00} Hz, {1e3 * swim.Power:0.00} mW"));
            Assert.That(swim.Error, Is.LessThan(0.01), "m/s");
            Assert.That(swim.Lift, Is.EqualTo(0.0).Within(1e-3), "of the weight");
            Assert.That(swim.Power, Is.GreaterThan(0.0));
        }

        [Test]
        public void TheSnailfish_TurnsAndClimbs_WithoutTumbling()
        {
            using var fish = new FlyingInsect("snailfish");
            using var swim = new FreeFlight(fish.Model, fish.Table, new FlightCondition(0.2f, 0f));
            while (swim.Time < 30)
            {
                // A slow circle, climbing: 0.2 m/s with 0.04 m/s².
                float angle = 0.2f * (float)swim.Time;
                swim.Step(FlightCommand.Fly(0.2f * new float3(math.sin(angle), 0f, math.cos(angle)) + new float3(0f, 0.02f, 0f)), 0.02f);
                Assert.That(swim.State, Is.EqualTo(FlightState.Flying), $"after {swim.Time} s");
                Assert.That(math.length(swim.VelocityError), Is.LessThan(0.15f), $"after {swim.Time} s");
            }

            TestContext.Out.WriteLine($"{swim.Position}, {math.length(swim.VelocityError)} m/s");
            Assert.That(swim.Position.y, Is.InRange(0.3f, 0.9f), "0.6 m wanted");
        }
    }
}
