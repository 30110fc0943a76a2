using System.Numerics;

namespace Alate.Flight
{
    /// <summary>Mean and harmonics of force and moment on a held insect over one beat, with the mean damping.</summary>
    internal sealed class BeatLoads
    {
        /// <summary>Force up and ahead, N; moment about X, N m.</summary>
        public readonly double[] mean = new double[3];

        /// <summary>[harmonic 1…][coordinate].</summary>
        public readonly Complex[,] harmonics = new Complex[TrimPoint.Harmonics, 3];

        /// <summary>Damping of velocity up, ahead and of turning.</summary>
        public readonly double[,] damping = new double[3, 3];

        /// <summary>Mean power that the wings give to the air, W.</summary>
        public double power;

        /// <summary>Adds one step of a beat.</summary>
        /// <param name="body">After the step.</param>
        /// <param name="phase">Φ in its middle.</param>
        /// <param name="share">Of the beat.</param>
        public void Add(in FlyingBody body, double phase, double share)
        {
            power += share * body.power;
            double[] load = { body.force.y, body.force.z, body.moment.x };
            for (int q = 0; q < 3; q++)
            {
                mean[q] += share * load[q];
                for (int k = 0; k < TrimPoint.Harmonics; k++)
                    harmonics[k, q] += 2.0 * share * load[q] * Complex.FromPolarCoordinates(1.0, -(k + 1) * phase);
                for (int p = 0; p < 3; p++)
                    damping[q, p] += share * body.damping[p][q];
            }
        }
    }
}
