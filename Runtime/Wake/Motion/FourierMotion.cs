using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Motion of a wing by its joints, each a Fourier series over the beat; between joints the surface is bilinear. The series smooths what
    /// samples of single steps have of noise, and its derivative is exact.
    /// </summary>
    public sealed class FourierMotion : IWingMotion
    {
        /// <summary>Most harmonics that are kept.</summary>
        public const int MostHarmonics = 6;

        private readonly BilinearSurface m_Surface;
        private readonly int m_Harmonics;

        private readonly double m_Start;

        // [joint · (2 harmonics + 1)] Mean; cosine and sine of each harmonic.
        private readonly float3[] m_Series;
        private readonly float3[] m_Points, m_Velocities;

        private FourierMotion(int chains, int joints, int harmonics, double start)
        {
            m_Start = start;
            m_Surface = new BilinearSurface(chains, joints);
            m_Harmonics = harmonics;
            m_Series = new float3[m_Surface.Count * (2 * harmonics + 1)];
            m_Points = new float3[m_Surface.Count];
            m_Velocities = new float3[m_Surface.Count];
        }

        /// <summary>Motion through samples of a beat, by as many harmonics as they carry, at most six.</summary>
        /// <param name="samples">
        /// [moment][chain · joints + joint] Joints at even times of the beat, leading chain first, root first.
        /// </param>
        /// <param name="chains">Chains, 2 or more.</param>
        /// <param name="joints">Joints of a chain, 2 or more.</param>
        /// <param name="start">Time of the first sample, beats.</param>
        /// <exception cref="ArgumentException">
        /// There are fewer than 3 samples, or one has not as many joints as the others or holds what is no number.
        /// </exception>
        public static FourierMotion Through(float3[][] samples, int chains, int joints, double start = 0.0)
        {
            if (chains < 2 || joints < 2)
                throw new ArgumentException($"A wing has {chains} chains of {joints} joints; at least 2 of 2 are needed.", nameof(chains));
            if (samples.Length < 3)
                throw new ArgumentException($"A beat has {samples.Length} samples; at least 3 are needed.", nameof(samples));
            for (int k = 0; k < samples.Length; k++)
            {
                if (samples[k] == null || samples[k].Length != chains * joints)
                {
                    throw new ArgumentException(
                        $"Sample {k} has {samples[k]?.Length ?? 0} joints, not {chains * joints}.", nameof(samples));
                }
                int bad = Array.FindIndex(samples[k], joint => !math.all(math.isfinite(joint)));
                if (bad >= 0)
                    throw new ArgumentException($"Joint {bad} of sample {k} is {samples[k][bad]}, no point.", nameof(samples));
            }

            var motion = new FourierMotion(chains, joints, math.min(MostHarmonics, (samples.Length - 1) / 2), start);
            motion.Fit(samples);
            return motion;
        }

        /// <inheritdoc/>
        public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
        {
            MoveJoints(beats - m_Start - Math.Floor(beats - m_Start));
            for (int k = 0; k < places.Length; k++)
            {
                points[k] = m_Surface.At(m_Points, places[k]);
                velocities[k] = m_Surface.At(m_Velocities, places[k]);
            }
        }

        private void Fit(float3[][] samples)
        {
            int stride = 2 * m_Harmonics + 1, count = samples.Length;
            for (int k = 0; k < count; k++)
            {
                for (int harmonic = 0; harmonic <= m_Harmonics; harmonic++)
                {
                    double angle = 2.0 * Math.PI * ((double)k * harmonic / count);
                    float cos = (float)(Math.Cos(angle) * (harmonic == 0 ? 1.0 : 2.0) / count),
                        sin = (float)(Math.Sin(angle) * 2.0 / count);
                    for (int joint = 0; joint < samples[k].Length; joint++)
                    {
                        int at = joint * stride + (harmonic == 0 ? 0 : 2 * harmonic - 1);
                        m_Series[at] += cos * samples[k][joint];
                        if (harmonic > 0)
                            m_Series[at + 1] += sin * samples[k][joint];
                    }
                }
            }
        }

        private void MoveJoints(double turn)
        {
            int stride = 2 * m_Harmonics + 1;
            for (int joint = 0; joint < m_Points.Length; joint++)
            {
                m_Points[joint] = m_Series[joint * stride];
                m_Velocities[joint] = default;
            }

            for (int harmonic = 1; harmonic <= m_Harmonics; harmonic++)
            {
                double rate = 2.0 * Math.PI * harmonic;
                float cos = (float)Math.Cos(rate * turn), sin = (float)Math.Sin(rate * turn);
                for (int joint = 0; joint < m_Points.Length; joint++)
                {
                    float3 a = m_Series[joint * stride + 2 * harmonic - 1], b = m_Series[joint * stride + 2 * harmonic];
                    m_Points[joint] += a * cos + b * sin;
                    m_Velocities[joint] += (float)rate * (b * cos - a * sin);
                }
            }
        }
    }
}
