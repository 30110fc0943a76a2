using Unity.Mathematics;

namespace Alate
{
    /// <summary>A trim table as the job reads it: points on a grid of air speeds and climbs.</summary>
    internal unsafe struct TrimTableView
    {
        /// <summary>[speed] and [climb], m/s, ascending.</summary>
        public float* speeds, climbs;

        /// <summary>[speed][climb] <see cref="TrimPoint"/>.</summary>
        public float* points;

        /// <summary>1 where a point has the air of a wake, else 0.</summary>
        public float* wake;

        public int speedCount, climbCount;

        /// <summary>True where the table says what air the wings meet.</summary>
        public readonly bool HasWake => *wake != 0f;

        /// <summary>Fills a point between the four around a speed and a climb; outside of the grid its edge.</summary>
        public void Read(float speed, float climb, float* point)
        {
            Span(speeds, speedCount, speed, out int s, out int s1, out float u);
            Span(climbs, climbCount, climb, out int c, out int c1, out float v);
            float* a = At(s, c), b = At(s, c1), d = At(s1, c), e = At(s1, c1);
            for (int k = 0; k < TrimPoint.Floats; k++)
                point[k] = math.lerp(math.lerp(a[k], b[k], v), math.lerp(d[k], e[k], v), u);
        }

        private float* At(int speed, int climb) => points + (speed * climbCount + climb) * TrimPoint.Floats;

        private static void Span(float* axis, int count, float at, out int before, out int after, out float blend)
        {
            before = 0;
            while (before < count - 2 && at > axis[before + 1])
                before++;
            after = math.min(before + 1, count - 1);
            float width = axis[after] - axis[before];
            blend = width > 0f ? math.saturate((at - axis[before]) / width) : 0f;
        }
    }
}
