using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>The periodic motion of a body about its mean in a steady beat, along the heading's axes.</summary>
    internal struct BodyBob
    {
        /// <summary>Velocity, m/s.</summary>
        public float3 velocity;

        /// <summary>Turn about X out of the trimmed attitude, radians, and its rate, rad/s.</summary>
        public float turn, rate;

        /// <summary>Bob at a phase of the beat.</summary>
        /// <param name="point">A <see cref="TrimPoint"/>.</param>
        /// <param name="phase">Φ, radians.</param>
        public static unsafe BodyBob At(float* point, float phase)
        {
            float* sums = stackalloc float[TrimPoint.Bobbing];
            Elementary.SinCos(phase, out float sin, out float cos);
            float s = sin, c = cos;
            for (int q = 0; q < TrimPoint.Bobbing; q++)
                sums[q] = 0f;
            for (int k = 0; k < TrimPoint.Harmonics; k++)
            {
                for (int q = 0; q < TrimPoint.Bobbing; q++)
                {
                    float* harmonic = point + TrimPoint.Bob + 2 * (q * TrimPoint.Harmonics + k);
                    sums[q] += harmonic[0] * c + harmonic[1] * s;
                }

                float next = c * cos - s * sin;
                s = s * cos + c * sin;
                c = next;
            }

            return new BodyBob { velocity = new float3(0f, sums[0], sums[1]), turn = sums[2], rate = sums[3] };
        }
    }
}
