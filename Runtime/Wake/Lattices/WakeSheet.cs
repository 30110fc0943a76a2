using System;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Wake of a wing: rows of points that were shed at its trailing edge, the newest first, with a row of vortex rings between each two.
    /// Lengths are reference lengths, in axes of the body; times are beats.
    /// </summary>
    public readonly struct WakeSheet
    {
        private readonly VortexSheet m_Sheet;

        internal WakeSheet(VortexSheet sheet) => m_Sheet = sheet;

        /// <summary>Number of rows of points; one more a step, until the oldest are dropped.</summary>
        public int RowCount => m_Sheet.RowCount;

        /// <summary>Number of points of a row, from the root to the tip.</summary>
        public int PointsPerRow => m_Sheet.Width;

        /// <summary>Place of a point.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such row or point.</exception>
        public float3 Point(int row, int point)
        {
            Check(row, RowCount, nameof(row));
            Check(point, PointsPerRow, nameof(point));
            return m_Sheet.Point(row, point);
        }

        /// <summary>
        /// Circulation Γ of the ring between a row and the next older one, and between a point and the next one: squared reference lengths
        /// a beat.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such ring.</exception>
        public float Circulation(int row, int ring)
        {
            Check(row, RowCount - 1, nameof(row));
            Check(ring, PointsPerRow - 1, nameof(ring));
            return m_Sheet.Circulation(row, ring);
        }

        /// <summary>Time since a row was shed.</summary>
        /// <exception cref="ArgumentOutOfRangeException">There is no such row.</exception>
        public float Age(int row)
        {
            Check(row, RowCount, nameof(row));
            return m_Sheet.Age(row);
        }

        private static void Check(int index, int count, string name)
        {
            if (index < 0 || index >= count)
                throw new ArgumentOutOfRangeException(name, index, $"There are {math.max(count, 0)}, from 0.");
        }
    }
}
