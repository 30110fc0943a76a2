using Unity.Mathematics;

namespace Alate
{
    /// <summary>Air that the wake of a trimmed beat sets moving at the wings of a body.</summary>
    internal static unsafe class BodyWake
    {
        /// <summary>Largest share of the trim's air: a command of far more than the trim's beat has no wake yet.</summary>
        private const float k_MostShare = 2f;

        /// <summary>Series of a pair of wings at a point, wing lengths per second; none beyond the pairs of a table.</summary>
        /// <param name="point">A <see cref="TrimPoint"/>.</param>
        /// <param name="pair">Number of the wing among those of its side.</param>
        public static WingInflow At(float* point, int pair)
        {
            if (pair < 0 || pair >= TrimPoint.Pairs)
                return default;
            var parts = (float3*)(point + TrimPoint.Inflow + pair * TrimPoint.InflowFloats);
            return new WingInflow { mean = parts[0], cosine1 = parts[1], sine1 = parts[2], cosine2 = parts[3], sine2 = parts[4] };
        }

        /// <summary>Series of a pair of wings at a point.</summary>
        public static WingInflow Read(float[] point, int pair)
        {
            fixed (float* numbers = point)
                return At(numbers, pair);
        }

        /// <summary>Writes a series into a point.</summary>
        public static void Write(float[] point, int pair, in WingInflow inflow)
        {
            Write(point, pair, 0, inflow.mean);
            Write(point, pair, 1, inflow.cosine1);
            Write(point, pair, 2, inflow.sine1);
            Write(point, pair, 3, inflow.cosine2);
            Write(point, pair, 4, inflow.sine2);
        }

        /// <summary>
        /// Share of the trim's air under another beat: a wake is as fast as the circulation that is shed, force over airspeed, which goes
        /// with the speed of the wings.
        /// </summary>
        /// <param name="point">A <see cref="TrimPoint"/>.</param>
        /// <param name="drive">The beat.</param>
        public static float Share(float* point, in WingDrive drive)
        {
            float trimmed = point[TrimPoint.Drive] * point[TrimPoint.Drive + 1], flown = drive.frequency * drive.amplitude;
            return trimmed > 0f ? math.clamp(flown / trimmed, 0f, k_MostShare) : 0f;
        }

        private static void Write(float[] point, int pair, int part, float3 value)
        {
            int at = TrimPoint.Inflow + pair * TrimPoint.InflowFloats + 3 * part;
            for (int axis = 0; axis < 3; axis++)
                point[at + axis] = value[axis];
        }
    }
}
