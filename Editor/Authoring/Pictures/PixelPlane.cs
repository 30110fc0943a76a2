using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>Plane of one number a pixel; rows from top to bottom.</summary>
    internal sealed class PixelPlane
    {
        public readonly int width;
        public readonly int height;

        /// <summary>[row * width + column] Number of a pixel.</summary>
        public readonly float[] values;

        public PixelPlane(int width, int height)
        {
            this.width = width;
            this.height = height;
            values = new float[width * height];
        }

        public float this[int column, int row]
        {
            get => values[row * width + column];
            set => values[row * width + column] = value;
        }

        /// <summary>The pixels whose number is above a limit.</summary>
        public PixelMask Above(float limit)
        {
            var mask = new PixelMask(width, height);
            for (int k = 0; k < values.Length; k++)
                mask[k % width, k / width] = values[k] > limit;
            return mask;
        }

        /// <summary>Numbers of every seventh pixel, those within a mask, rising; seven is prime, so that no column is favoured.</summary>
        public List<float> Sampled(PixelMask within)
        {
            var sampled = new List<float>();
            for (int k = 0; k < values.Length; k += 7)
            {
                if (within[k % width, k / width])
                    sampled.Add(values[k]);
            }

            sampled.Sort();
            return sampled;
        }

        /// <summary>Convolves the plane with a Gaussian bell; the last pixels continue beyond the rim.</summary>
        /// <param name="sigma">Width of the bell, pixels.</param>
        public PixelPlane Blurred(double sigma)
        {
            float[] kernel = Kernel(sigma);
            int reach = kernel.Length - 1;
            var across = new PixelPlane(width, height);
            float[] line = new float[width + 2 * reach];
            for (int row = 0; row < height; row++)
                BlurRow(kernel, row, line, across);
            var both = new PixelPlane(width, height);
            for (int row = 0; row < height; row++)
                across.BlurDown(kernel, row, both);
            return both;
        }

        /// <summary>The largest value within a square around each pixel.</summary>
        /// <param name="radius">Half a side of the square, pixels.</param>
        public PixelPlane Highest(int radius) => Highest(radius, 1, 0).Highest(radius, 0, 1);

        private PixelPlane Highest(int radius, int right, int down)
        {
            var highest = new PixelPlane(width, height);
            values.CopyTo(highest.values, 0);
            for (int step = -radius; step <= radius; step++)
            {
                int x = step * right, y = step * down;
                for (int row = Math.Max(0, -y); row < Math.Min(height, height - y); row++)
                {
                    for (int column = Math.Max(0, -x); column < Math.Min(width, width - x); column++)
                        highest[column, row] = Math.Max(highest[column, row], this[column + x, row + y]);
                }
            }

            return highest;
        }

        private void BlurRow(float[] kernel, int row, float[] line, PixelPlane into)
        {
            int reach = kernel.Length - 1, start = row * width;
            Array.Copy(values, start, line, reach, width);
            Array.Fill(line, values[start], 0, reach);
            Array.Fill(line, values[start + width - 1], reach + width, reach);
            for (int column = 0; column < width; column++)
            {
                int middle = column + reach;
                float sum = kernel[0] * line[middle];
                for (int k = 1; k <= reach; k++)
                    sum += kernel[k] * (line[middle - k] + line[middle + k]);
                into.values[start + column] = sum;
            }
        }

        private void BlurDown(float[] kernel, int row, PixelPlane into)
        {
            int start = row * width;
            for (int k = 0; k < kernel.Length; k++)
            {
                float weight = k == 0 ? 0.5f * kernel[0] : kernel[k];
                var above = new ReadOnlySpan<float>(values, Math.Max(0, row - k) * width, width);
                var below = new ReadOnlySpan<float>(values, Math.Min(height - 1, row + k) * width, width);
                var target = new Span<float>(into.values, start, width);
                for (int column = 0; column < target.Length; column++)
                    target[column] += weight * (above[column] + below[column]);
            }
        }

        // The half of the bell from its middle on; both halves together sum to 1.
        private static float[] Kernel(double sigma)
        {
            float[] kernel = new float[1 + (int)Math.Ceiling(3.0 * sigma)];
            double sum = 0.0;
            for (int k = 0; k < kernel.Length; k++)
            {
                kernel[k] = (float)Math.Exp(-0.5 * k * k / (sigma * sigma));
                sum += k == 0 ? kernel[k] : 2.0 * kernel[k];
            }

            for (int k = 0; k < kernel.Length; k++)
                kernel[k] = (float)(kernel[k] / sum);
            return kernel;
        }
    }
}
