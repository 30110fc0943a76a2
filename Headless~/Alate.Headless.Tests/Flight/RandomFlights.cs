using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Flights of random commands in random gusts, each changed every second, with full aid.</summary>
    public sealed class RandomFlights
    {
        /// <summary>Seconds of a flight; the last ones are calm, so that a tumble that lasts is seen.</summary>
        private const double k_Seconds = 12, k_Calm = 10;

        /// <summary>Fastest gust, m/s.</summary>
        private const float k_Gust = 2f;

        private static readonly string[] s_Species = ["monarch", "swallowtail", "firefly", "fishfly", "painted-lichen-moth", "dragonfly"];

        [Test]
        public void ARandomFlight_DoesNotTumble() => Fly("monarch", 1, 1);

        [Test, Explicit, Category("Long")]
        public void OfTwoHundredRandomFlights_NoneTumbles([ValueSource(nameof(s_Species))] string species) => Fly(species, 200, 1000);

        private static void Fly(string species, int flights, uint seed)
        {
            using var insect = new FlyingInsect(species);
            int tumbled = 0, over = 0, lost = 0;
            var turns = new List<double>();
            for (int k = 0; k < flights; k++)
            {
                double turn = Turn(insect, seed + (uint)k, out bool finite, out bool ends);
                turns.Add(math.degrees((float)turn));
                lost += finite ? 0 : 1;
                tumbled += ends ? 1 : 0;
                over += turn > 0.5 * math.PI ? 1 : 0;
            }

            turns.Sort();
            double worst = turns[^1];
            TestContext.Out.WriteLine($"{species}: {flights} flights, largest turn out of the trim: median "
                + $"{turns[flights / 2]:0}°, 90 % {turns[flights * 9 / 10]:0}°, worst "
                + $"{worst:0}°; beyond 70° {turns.FindAll(t => t > 70).Count}, beyond 90° {over}, tumbling at the end {tumbled}");
            Assert.That(lost, Is.Zero, "left the finite");
            Assert.That(tumbled, Is.Zero, "tumbling at the end");
            Assert.That(over, Is.Zero, "beyond 90°");
        }

        private static double Turn(FlyingInsect insect, uint seed, out bool finite, out bool tumbles)
        {
            var random = new Random(seed * 747796405u + 1u);
            using var flight = new FreeFlight(insect.Model, insect.Table) { Aid = 1f };
            float3 wanted = default;
            double worst = 0, next = 0;
            finite = true;
            while (flight.Time < k_Seconds && finite)
            {
                if (flight.Time >= next)
                {
                    next += 1;
                    wanted = random.NextFloat3Direction() * new float3(1.3f, 0.4f, 1.3f) * random.NextFloat();
                    flight.Wind = flight.Time < k_Calm ? random.NextFloat3Direction() * random.NextFloat(0f, k_Gust) : default;
                }

                flight.Step(FlightCommand.Fly(wanted), 0.02f);
                worst = math.max(worst, (double)flight.Tilt);
                finite = math.all(math.isfinite(flight.Position)) && math.all(math.isfinite(flight.Rotation.value));
            }

            tumbles = flight.State == FlightState.Tumbling;
            return worst;
        }
    }
}
