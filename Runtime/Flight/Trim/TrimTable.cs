using System;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Trims, bobs and gains of an insect over speeds and climbs: what its flight goes by. Points that do not close hold their nearest
    /// neighbour's numbers.
    /// </summary>
    public sealed class TrimTable : IDisposable
    {
        private readonly float[][] m_Points;
        private readonly bool[] m_Closed;
        private TrimTableMemory m_Memory;

        internal TrimTable(float[] speeds, float[] climbs)
        {
            Speeds = speeds;
            ClimbRates = climbs;
            m_Points = new float[speeds.Length * climbs.Length][];
            m_Closed = new bool[m_Points.Length];
        }

        /// <summary>Speeds ahead, m/s, ascending. Do not change.</summary>
        public float[] Speeds { get; }

        /// <summary>Climbs, m/s, ascending. Do not change.</summary>
        public float[] ClimbRates { get; }

        /// <summary>Fastest speed at which some climb closes, m/s.</summary>
        public float TopSpeed
        {
            get
            {
                float top = 0f;
                for (int s = 0; s < Speeds.Length; s++)
                {
                    for (int c = 0; c < ClimbRates.Length; c++)
                        top = m_Closed[At(s, c)] ? math.max(top, Speeds[s]) : top;
                }

                return top;
            }
        }

        /// <summary>True where a point says what air its wake sets moving at the wings.</summary>
        public bool HasWake
        {
            get
            {
                foreach (float[] point in m_Points)
                {
                    for (int k = TrimPoint.Inflow; point != null && k < point.Length; k++)
                    {
                        if (point[k] != 0f)
                            return true;
                    }
                }

                return false;
            }
        }

        /// <summary>Returns true where the insect flies at a point.</summary>
        public bool IsClosed(int speed, int climb) => m_Closed[At(speed, climb)];

        /// <summary>Slowest and fastest climb at a speed, m/s.</summary>
        public void Climbs(float speed, out float least, out float most)
        {
            int s = 0;
            while (s < Speeds.Length - 2 && speed > Speeds[s + 1])
                s++;
            int next = math.min(s + 1, Speeds.Length - 1);
            float width = Speeds[next] - Speeds[s];
            float blend = width > 0f ? math.saturate((speed - Speeds[s]) / width) : 0f;
            Ends(s, out float least0, out float most0);
            Ends(next, out float least1, out float most1);
            least = math.lerp(least0, least1, blend);
            most = math.lerp(most0, most1, blend);
        }

        /// <summary>Limits of the insect's flight by this table.</summary>
        public FlightLimits Limits => new FlightLimits(TopSpeed, ClimbRates[0], ClimbRates[ClimbRates.Length - 1], Acceleration);

        /// <summary>Largest change of velocity that the insect follows, m/s²; <see cref="FlightModel.AccelerationAt"/>.</summary>
        internal float Acceleration { get; set; } = FlightLimits.FlyersAcceleration;

        /// <summary>The beat of the trim that is nearest to a speed and a climb.</summary>
        internal WingDrive DriveNear(float speed, float climb)
        {
            float[] point = PointNear(speed, climb);
            return new WingDrive
            {
                frequency = point[TrimPoint.Drive],
                amplitude = point[TrimPoint.Drive + 1],
                tilt = point[TrimPoint.Drive + 2],
                meanSweep = point[TrimPoint.Drive + 3],
            };
        }

        /// <summary>The table in native memory; made at the first use.</summary>
        internal TrimTableView View
        {
            get
            {
                if (m_Memory == null)
                {
                    m_Memory = new TrimTableMemory(Speeds, ClimbRates);
                    for (int s = 0; s < Speeds.Length; s++)
                    {
                        for (int c = 0; c < ClimbRates.Length; c++)
                            m_Memory.Write(s, c, m_Points[At(s, c)]);
                    }
                }

                return m_Memory.View;
            }
        }

        /// <summary>A point's numbers, as <see cref="TrimPoint"/> says.</summary>
        internal float[] Point(int speed, int climb) => m_Points[At(speed, climb)];

        /// <summary>Takes a point that closes.</summary>
        internal void Set(int speed, int climb, float[] point)
        {
            m_Points[At(speed, climb)] = point;
            m_Closed[At(speed, climb)] = true;
        }

        /// <summary>
        /// Gives the points that do not close their nearest neighbour's numbers; what flies by the table next flies by them.
        /// </summary>
        /// <returns>Whether any point closes.</returns>
        internal bool Fill()
        {
            Dispose();
            bool any = false;
            for (int s = 0; s < Speeds.Length; s++)
            {
                for (int c = 0; c < ClimbRates.Length; c++)
                {
                    any |= m_Closed[At(s, c)];
                    if (!m_Closed[At(s, c)])
                        m_Points[At(s, c)] = Nearest(s, c);
                }
            }

            return any;
        }

        /// <summary>Index of the climb that is nearest to 0.</summary>
        internal int LevelClimb
        {
            get
            {
                int level = 0;
                for (int c = 1; c < ClimbRates.Length; c++)
                    level = math.abs(ClimbRates[c]) < math.abs(ClimbRates[level]) ? c : level;
                return level;
            }
        }

        /// <summary>A table with these points and one more speed, at which none closes yet.</summary>
        internal TrimTable WithSpeed(float speed)
        {
            float[] speeds = With(Speeds, speed, out int added);
            var table = new TrimTable(speeds, ClimbRates);
            for (int k = 0; k < m_Points.Length; k++)
                Give(table, k / ClimbRates.Length, k % ClimbRates.Length, added, int.MaxValue);
            return table;
        }

        /// <summary>A table with these points and one more climb, at which none closes yet.</summary>
        internal TrimTable WithClimb(float climb)
        {
            float[] climbs = With(ClimbRates, climb, out int added);
            var table = new TrimTable(Speeds, climbs);
            for (int k = 0; k < m_Points.Length; k++)
                Give(table, k / ClimbRates.Length, k % ClimbRates.Length, int.MaxValue, added);
            return table;
        }

        private void Give(TrimTable table, int s, int c, int addedSpeed, int addedClimb)
        {
            if (IsClosed(s, c))
                table.Set(s < addedSpeed ? s : s + 1, c < addedClimb ? c : c + 1, Point(s, c));
        }

        private static float[] With(float[] axis, float value, out int added)
        {
            float[] longer = new float[axis.Length + 1];
            axis.CopyTo(longer, 0);
            longer[axis.Length] = value;
            Array.Sort(longer);
            added = Array.IndexOf(longer, value);
            return longer;
        }

        /// <summary>Frees the native memory; a table that is used again makes it again.</summary>
        public void Dispose()
        {
            m_Memory?.Dispose();
            m_Memory = null;
        }

        /// <summary>Numbers of the point that is nearest to a speed and a climb.</summary>
        internal float[] PointNear(float speed, float climb)
        {
            int s = 0, c = 0;
            for (int k = 1; k < Speeds.Length; k++)
                s = math.abs(Speeds[k] - speed) < math.abs(Speeds[s] - speed) ? k : s;
            for (int k = 1; k < ClimbRates.Length; k++)
                c = math.abs(ClimbRates[k] - climb) < math.abs(ClimbRates[c] - climb) ? k : c;
            return m_Points[At(s, c)];
        }

        private float[] Nearest(int speed, int climb)
        {
            float[] nearest = null;
            float least = float.PositiveInfinity;
            for (int s = 0; s < Speeds.Length; s++)
            {
                for (int c = 0; c < ClimbRates.Length; c++)
                {
                    float distance = 4f * math.abs(Speeds[s] - Speeds[speed]) + math.abs(ClimbRates[c] - ClimbRates[climb]);
                    if (m_Closed[At(s, c)] && distance < least)
                    {
                        least = distance;
                        nearest = m_Points[At(s, c)];
                    }
                }
            }

            return nearest;
        }

        /// <summary>Takes a point out again; <see cref="Fill"/> gives it its neighbour's numbers.</summary>
        internal void Open(int speed, int climb) => m_Closed[At(speed, climb)] = false;

        private void Ends(int speed, out float least, out float most)
        {
            least = float.PositiveInfinity;
            most = float.NegativeInfinity;
            for (int c = 0; c < ClimbRates.Length; c++)
            {
                if (m_Closed[At(speed, c)])
                {
                    least = math.min(least, ClimbRates[c]);
                    most = math.max(most, ClimbRates[c]);
                }
            }

            if (least > most)
                least = most = 0f;
        }

        private int At(int speed, int climb) => speed * ClimbRates.Length + climb;
    }
}
