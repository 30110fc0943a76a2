using System;

namespace Alate
{
    /// <summary>
    /// A chain of measured stiffness as a beam of straight bones between hinges, clamped at its root. Bends out of its plane alone, so that
    /// only distances along it count.
    /// </summary>
    internal sealed class ChainBeam
    {
        /// <summary>Intervals of a bone's integral by Simpson's rule.</summary>
        private const int k_Intervals = 16;

        /// <summary>Passes of the power method: a beam's second frequency is six times its first, so that a dozen would do.</summary>
        private const int k_Passes = 30;

        private readonly double[] m_Places;
        private readonly double[] m_Distances;

        /// <param name="places">[joint] Place on the chain where its stiffness is read, 0 at the root, 1 at the tip.</param>
        /// <param name="distances">[joint] Distance from the root along the chain, rising.</param>
        public ChainBeam(double[] places, double[] distances)
        {
            m_Places = places;
            m_Distances = distances;
        }

        /// <summary>Number of bones, and of hinges.</summary>
        public int Bones => m_Distances.Length - 1;

        /// <summary>The same beam with every bone cut into equal parts.</summary>
        public ChainBeam Cut(int parts) => new ChainBeam(Cut(m_Places, parts), Cut(m_Distances, parts));

        /// <summary>
        /// [hinge] Stiffness in bending, EI over length. The joints lie on the curve of the beam under even load, M(s) = s²/2 at the
        /// distance s from the tip: a hinge's compliance is ∫ h M/EI over its own M, h the hat from the joint before to the joint after.
        /// The root's has half a hat, and is about twice as stiff.
        /// </summary>
        public double[] Hinges(float[] stiffness)
        {
            double[] hinges = new double[Bones];
            for (int j = 0; j < Bones; j++)
            {
                double turn = Hat(stiffness, j, j + 1) + (j > 0 ? Hat(stiffness, j, j - 1) : 0.0);
                hinges[j] = Moment(m_Distances[j]) / turn;
            }

            return hinges;
        }

        /// <summary>[hinge] Stiffness in torsion, GJ over length: each bone turns as the beam's section in its middle.</summary>
        public double[] Twists(float[] stiffness)
        {
            double[] twists = new double[Bones];
            for (int j = 0; j < Bones; j++)
                twists[j] = 1.0 / (HalfTurn(stiffness, j, j + 1) + (j > 0 ? HalfTurn(stiffness, j, j - 1) : 0.0));
            return twists;
        }

        /// <summary>
        /// Square of the time in which the beam swings through a radian of its first mode, 1/ω²; in the units of masses, distances and
        /// hinges.
        /// </summary>
        /// <param name="masses">[joint] At the joints.</param>
        /// <param name="hinges">[hinge] Their stiffness.</param>
        public double SwingTimeSquared(double[] masses, double[] hinges)
        {
            double[] angles = new double[Bones], heights = new double[Bones + 1];
            double largest = 0.0;
            for (int j = 0; j < Bones; j++)
                angles[j] = 1.0;
            for (int pass = 0; pass < k_Passes; pass++)
            {
                double slope = 0.0, force = 0.0, torque = 0.0;
                for (int j = 0; j < Bones; j++)
                {
                    slope += angles[j];
                    heights[j + 1] = heights[j] + slope * (m_Distances[j + 1] - m_Distances[j]);
                }

                largest = 0.0;
                for (int j = Bones - 1; j >= 0; j--)
                {
                    force += masses[j + 1] * heights[j + 1];
                    torque += force * (m_Distances[j + 1] - m_Distances[j]);
                    angles[j] = torque / hinges[j];
                    largest = Math.Max(largest, angles[j]);
                }

                for (int j = 0; j < Bones; j++)
                    angles[j] /= largest;
            }

            return largest;
        }

        /// <summary>Masses of the joints of the cut beam, spread over the bones so that an even beam stays even.</summary>
        /// <param name="masses">[joint] Of this beam.</param>
        /// <param name="parts">Parts of every bone.</param>
        public double[] Spread(double[] masses, int parts)
        {
            double[] densities = new double[masses.Length];
            for (int j = 0; j < masses.Length; j++)
                densities[j] = masses[j] / LengthShare(m_Distances, j);
            double[] fine = Cut(densities, parts), distances = Cut(m_Distances, parts);
            for (int k = 0; k < fine.Length; k++)
                fine[k] *= LengthShare(distances, k);
            return fine;
        }

        private static double LengthShare(double[] distances, int joint) =>
            0.5 * (distances[Math.Min(joint + 1, distances.Length - 1)] - distances[Math.Max(joint - 1, 0)]);

        private static double[] Cut(double[] values, int parts)
        {
            double[] fine = new double[(values.Length - 1) * parts + 1];
            for (int k = 0; k < fine.Length; k++)
            {
                int before = Math.Min(k / parts, values.Length - 2);
                double share = (double)(k - before * parts) / parts;
                fine[k] = values[before] * (1.0 - share) + values[before + 1] * share;
            }

            return fine;
        }

        private double Moment(double distance) => 0.5 * (m_Distances[Bones] - distance) * (m_Distances[Bones] - distance);

        private double Hat(float[] stiffness, int joint, int neighbour)
        {
            double place = m_Places[joint], toPlace = m_Places[neighbour] - place, distance = m_Distances[joint],
                to = m_Distances[neighbour] - distance;
            return Math.Abs(to) * Simpson(
                share => (1.0 - share) * Moment(distance + share * to) / ChainValues.At(stiffness, place + share * toPlace));
        }

        private double HalfTurn(float[] stiffness, int joint, int neighbour)
        {
            double place = m_Places[joint], to = 0.5 * (m_Places[neighbour] - place);
            return 0.5 * Math.Abs(m_Distances[neighbour] - m_Distances[joint]) * Simpson(
                share => 1.0 / ChainValues.At(stiffness, place + share * to));
        }

        private static double Simpson(Func<double, double> of)
        {
            double sum = of(0.0) + of(1.0);
            for (int k = 1; k < k_Intervals; k++)
                sum += (2 + 2 * (k & 1)) * of((double)k / k_Intervals);
            return sum / (3 * k_Intervals);
        }
    }
}
