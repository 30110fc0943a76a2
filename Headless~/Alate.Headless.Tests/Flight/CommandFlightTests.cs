using System.Collections.Generic;
using System.Linq;
using Alate.Tests.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Commands of people who do not know what insects fly: no insect tumbles or gets lost by any of them, without aid.</summary>
    public sealed class CommandFlightTests
    {
        /// <summary>Longest tumble, seconds, and farthest way off the reference, metres, that count as none.</summary>
        private const double k_Tumbled = 0.5, k_Lost = 2.0;

        // Behind, straight down, and back and up: from hovering.
        [TestCase(0f, 0f, -1f)]
        [TestCase(0f, -2f, 0f)]
        [TestCase(3f, 0.5f, -4f)]
        public void ForAGoalBehindOrBelow_AMonarchFlies(float x, float y, float z)
        {
            using var insect = new FlyingInsect("monarch");
            var flight = new CommandFlight(insect, 0.02f);
            flight.ForAGoal(new float3(x, y, z));
            Assert.That(flight.Tumbled, Is.Zero);
            Assert.That(flight.Lost, Is.LessThan(k_Lost));
            Assert.That(flight.Missed, Is.LessThan(0.6));
        }

        [Test]
        public void AHawkmothOfAFile_FliesForAnyGoal_AndByAnyScript()
        {
            using var insect = new FlyingInsect(FlownInsects.Hawkmoth);
            var flight = new CommandFlight(insect, 0.02f);
            flight.ForAGoal(1000);
            Assert.That(IsSafe(flight) && flight.Tumbled == 0.0);
            flight.ByAScript(1000);
            Assert.That(IsSafe(flight) && flight.Tumbled == 0.0);
        }

        [Test]
        public void ByScripts_AMonarchFlies_AndUnguardedTumbles([Values] bool guarded)
        {
            using var insect = new FlyingInsect("monarch");
            var flight = new CommandFlight(insect, 0.02f) { GuardCommands = guarded };
            int tumbled = 0;
            for (uint seed = 1; seed <= (guarded ? 2 : 4); seed++)
            {
                flight.ByAScript(seed);
                tumbled += IsSafe(flight) ? 0 : 1;
            }

            Assert.That(tumbled, guarded ? Is.Zero : Is.GreaterThan(1));
        }

        [Test, Explicit, Category("Long")]
        public void OfFiveHundredGoals_NoneTumblesAnInsect(
            [ValueSource(typeof(FlownInsects), nameof(FlownInsects.All))] string species, [Values(0.01f, 0.02f)] float step)
        {
            using var insect = new FlyingInsect(species);
            AssertSafe(500, seed =>
            {
                var flight = new CommandFlight(insect, step);
                flight.ForAGoal(seed);
                return flight;
            });
        }

        [Test, Explicit, Category("Long")]
        public void OfTwoHundredScripts_NoneTumblesAnInsect(
            [ValueSource(typeof(FlownInsects), nameof(FlownInsects.All))] string species, [Values(0.01f, 0.02f)] float step)
        {
            using var insect = new FlyingInsect(species);
            AssertSafe(200, seed =>
            {
                var flight = new CommandFlight(insect, step);
                flight.ByAScript(seed);
                return flight;
            });
        }

        private static bool IsSafe(CommandFlight flight) => flight.Tumbled <= k_Tumbled && flight.Lost <= k_Lost;

        private static void AssertSafe(int count, System.Func<uint, CommandFlight> fly)
        {
            var bad = new List<string>();
            double worst = 0.0, farthest = 0.0;
            foreach (uint seed in Enumerable.Range(1000, count).Select(seed => (uint)seed))
            {
                CommandFlight flight = fly(seed);
                worst = math.max(worst, flight.Tumbled);
                farthest = math.max(farthest, flight.Lost);
                if (!IsSafe(flight))
                    bad.Add($"seed {seed}: tumbled {flight.Tumbled:0.00} s, lost by {flight.Lost:0.0} m");
            }

            TestContext.Out.WriteLine($"longest tumble {worst:0.00} s, farthest off {farthest:0.0} m");
            Assert.That(bad, Is.Empty, string.Join("\n", bad));
        }
    }
}
