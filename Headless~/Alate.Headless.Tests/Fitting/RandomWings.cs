using System;

namespace Alate.Tests
{
    /// <summary>Random wings: Fourier series from slender to round; some with a tail, a notch or scallops, swept either way.</summary>
    internal static class RandomWings
    {
        /// <summary>The wing of a seed.</summary>
        public static PolarWing Make(int seed)
        {
            var random = new Random(seed);
            var wing = new PolarWing
            {
                waves = new double[6],
                phases = new double[6],
                aspect = Math.Exp(Math.Log(0.12) * random.NextDouble()),
                sweep = 0.5 * (random.NextDouble() - 0.6),
                tailAngle = -0.6 - 1.4 * random.NextDouble(),
                tailWidth = 0.05 + 0.07 * random.NextDouble(),
                scallops = random.Next(12, 30),
            };
            double wildness = 0.25 * random.NextDouble();
            for (int k = 2; k < 6; k++)
            {
                wing.waves[k] = wildness * random.NextDouble() / k;
                wing.phases[k] = 2.0 * Math.PI * random.NextDouble();
            }

            switch (random.Next(4))
            {
                case 0:
                    wing.tail = 0.25 + 0.45 * random.NextDouble();
                    break;
                case 1:
                    wing.tail = -0.35 * random.NextDouble();
                    break;
                case 2:
                    wing.scallop = 0.01 + 0.02 * random.NextDouble();
                    break;
            }

            return wing;
        }
    }
}
