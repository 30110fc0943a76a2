using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>
    /// Colour of the ground behind a wing, which may change smoothly over the picture: a quadratic surface for each channel, fitted so that
    /// pixels of the wing among those of the ground do not count.
    /// </summary>
    internal sealed class PlainGround
    {
        /// <summary>Width of the border that is taken for ground at first, as a share of the shorter side.</summary>
        private const double k_BorderShare = 0.02;

        /// <summary>Largest number of pixels in a fit.</summary>
        private const int k_MostSamples = 6000;

        private const int k_Rounds = 12;

        /// <summary>Distance beyond which a pixel does not count, in robust standard deviations (Tukey's biweight).</summary>
        private const double k_TukeyReach = 4.7;

        /// <summary>Least assumed spread, shades: pictures hold whole ones.</summary>
        private const double k_LeastSpread = 0.7;

        /// <summary>The spread of a normal distribution over its median absolute deviation.</summary>
        private const double k_SpreadOverMedian = 1.4826;

        /// <summary>Distance above the ground's median at which a pixel is surely no ground, in spreads.</summary>
        private const double k_SureSpreads = 6.0;

        /// <summary>Least distance, shades, at which a pixel is told from the ground.</summary>
        private const double k_LeastContrast = 8.0;

        private readonly PixelPlane[] m_Channels;
        private readonly SmoothSurfaces m_Surfaces;

        private PlainGround(PixelPlane[] channels)
        {
            m_Channels = channels;
            Distance = new PixelPlane(channels[0].width, channels[0].height);
            m_Surfaces = new SmoothSurfaces(Distance.width, Distance.height, channels.Length);
        }

        /// <summary>
        /// Distance of the colour of each pixel from the ground's: the root of the mean squared difference of the channels, shades.
        /// </summary>
        public PixelPlane Distance { get; }

        /// <summary>Distance below which a pixel may well be ground, shades.</summary>
        public double Noise { get; private set; }

        /// <summary>Fits the ground to the picture's border.</summary>
        public static PlainGround FromBorder(params PixelPlane[] channels)
        {
            int width = channels[0].width, height = channels[0].height;
            int band = Math.Max(1, (int)(k_BorderShare * Math.Min(width, height)));
            return From((column, row) => column < band || row < band || column >= width - band || row >= height - band, channels);
        }

        /// <summary>Fits the ground to all pixels outside a mask.</summary>
        public static PlainGround Outside(PixelMask wing, params PixelPlane[] channels) =>
            From((column, row) => !wing[column, row], channels);

        private static PlainGround From(Func<int, int, bool> isGround, PixelPlane[] channels)
        {
            var ground = new PlainGround(channels);
            List<(int Column, int Row)> samples = ground.Sample(isGround);
            ground.Fit(samples);
            ground.MeasureDistances();
            ground.MeasureNoise(samples);
            return ground;
        }

        private List<(int Column, int Row)> Sample(Func<int, int, bool> isGround)
        {
            int count = 0;
            for (int k = 0; k < Distance.values.Length; k++)
                count += isGround(k % Distance.width, k / Distance.width) ? 1 : 0;
            int wanted = Math.Min(count, k_MostSamples);
            var samples = new List<(int Column, int Row)>(wanted);
            for (int k = 0, passed = 0; samples.Count < wanted; k++)
            {
                int column = k % Distance.width, row = k / Distance.width;
                if (isGround(column, row) && passed++ == (int)((long)samples.Count * count / wanted))
                    samples.Add((column, row));
            }

            return samples;
        }

        private void Fit(List<(int Column, int Row)> samples)
        {
            double[] residuals = new double[samples.Count], values = new double[m_Channels.Length];
            StartFromMedians(samples);
            for (int round = 0; round < k_Rounds; round++)
            {
                for (int k = 0; k < residuals.Length; k++)
                    residuals[k] = DistanceAt(samples[k].Column, samples[k].Row);
                double reach = k_TukeyReach * Math.Max(k_LeastSpread, k_SpreadOverMedian * Median(residuals));
                for (int k = 0; k < residuals.Length; k++)
                {
                    double weight = Biweight(residuals[k] / reach);
                    if (weight == 0.0)
                        continue;
                    (int column, int row) = samples[k];
                    for (int c = 0; c < values.Length; c++)
                        values[c] = m_Channels[c][column, row];
                    m_Surfaces.Add(column, row, values, weight);
                }

                m_Surfaces.Fit();
            }
        }

        private void StartFromMedians(List<(int Column, int Row)> samples)
        {
            double[] medians = Array.ConvertAll(
                m_Channels, channel => Median(samples.ConvertAll(sample => (double)channel[sample.Column, sample.Row]).ToArray()));
            foreach ((int column, int row) in samples)
                m_Surfaces.Add(column, row, medians, 1.0);
            m_Surfaces.Fit();
        }

        private void MeasureDistances()
        {
            for (int row = 0; row < Distance.height; row++)
            {
                for (int column = 0; column < Distance.width; column++)
                    Distance[column, row] = (float)DistanceAt(column, row);
            }
        }

        private void MeasureNoise(List<(int Column, int Row)> samples)
        {
            double[] distances = samples.ConvertAll(sample => (double)Distance[sample.Column, sample.Row]).ToArray();
            double middle = Median(distances);
            double spread = k_SpreadOverMedian * Median(Array.ConvertAll(distances, distance => Math.Abs(distance - middle)));
            Noise = Math.Max(k_LeastContrast, middle + k_SureSpreads * spread);
        }

        private double DistanceAt(int column, int row)
        {
            double sum = 0.0;
            for (int c = 0; c < m_Channels.Length; c++)
            {
                double difference = m_Channels[c][column, row] - m_Surfaces.At(c, column, row);
                sum += difference * difference;
            }

            return Math.Sqrt(sum / m_Channels.Length);
        }

        private static double Biweight(double ratio)
        {
            double rest = 1.0 - ratio * ratio;
            return rest > 0.0 ? rest * rest : 0.0;
        }

        private static double Median(double[] values)
        {
            if (values.Length == 0)
                return 0.0;
            double[] sorted = (double[])values.Clone();
            Array.Sort(sorted);
            return sorted[sorted.Length / 2];
        }
    }
}
