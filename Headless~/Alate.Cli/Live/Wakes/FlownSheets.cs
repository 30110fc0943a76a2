using Alate.Wake;

namespace Alate.Cli;

/// <summary>Wakes of all computed wings at a moment, and how they moved in the step before; metres, axes of the body.</summary>
internal sealed class FlownSheets
{
    private readonly int m_Rows, m_Width;
    private readonly float3[][] m_Points, m_Ways;
    private readonly float[][] m_Circulation;

    /// <param name="wings">Wings that are computed.</param>
    /// <param name="rows">Most rows of points.</param>
    /// <param name="width">Points of a row.</param>
    public FlownSheets(int wings, int rows, int width)
    {
        (m_Rows, m_Width) = (rows, width);
        m_Points = [.. Enumerable.Range(0, wings).Select(_ => new float3[rows * width])];
        m_Ways = [.. m_Points.Select(_ => new float3[rows * width])];
        m_Circulation = [.. m_Points.Select(_ => new float[rows * width])];
    }

    /// <summary>Moment of the flight; below 0 where there is none.</summary>
    public long Index { get; private set; } = -1;

    /// <summary>Number of rows of points.</summary>
    public int Rows { get; private set; }

    /// <summary>The strongest circulation, m²/s.</summary>
    public float Strongest { get; private set; }

    /// <summary>Drops the sheets.</summary>
    public void Clear()
    {
        Index = -1;
        Strongest = 0f;
    }

    /// <summary>Copies the sheets of a step.</summary>
    /// <param name="index">Moment of the flight.</param>
    /// <param name="wake">The wake.</param>
    /// <param name="length">Metres of its unit of length.</param>
    /// <param name="period">Seconds of its unit of time.</param>
    /// <param name="stream">Way of the air in a step, metres.</param>
    /// <param name="isLeft">[wing] True for a left wing, whose rows run the other way.</param>
    /// <param name="before">Sheets of the step before; null for none.</param>
    public void Take(
        long index, FreeWake wake, float length, float period, float3 stream, IReadOnlyList<bool> isLeft, FlownSheets before)
    {
        (Index, Rows, Strongest) = (index, Math.Min(wake.Sheet(0).RowCount, m_Rows), 0f);
        for (int wing = 0; wing < m_Points.Length; wing++)
        {
            WakeSheet sheet = wake.Sheet(wing);
            float factor = (isLeft[wing] ? 1f : -1f) * length * length / period;
            float3[] points = m_Points[wing], ways = m_Ways[wing], old = before?.m_Points[wing];
            for (int k = 0; k < Rows * m_Width; k++)
            {
                int row = k / m_Width;
                points[k] = length * sheet.Point(row, k % m_Width);
                // A row was one place newer in the step before.
                ways[k] = row > 0 && old != null ? points[k] - old[k - m_Width] : stream;
                m_Circulation[wing][k] = factor * Circulation(sheet, row, k % m_Width);
                Strongest = math.max(Strongest, math.abs(m_Circulation[wing][k]));
            }

            // The row that has just been shed leaves as the one before does.
            for (int k = 0; k < m_Width && Rows > 1; k++)
                ways[k] = ways[m_Width + k];
        }
    }

    /// <summary>Point of a wing's wake some steps after the moment.</summary>
    public float3 Point(int wing, int at, float steps) => m_Points[wing][at] + steps * m_Ways[wing][at];

    /// <summary>Circulation of the rings behind a point, m²/s, positive as a wing sheds it that the air pushes up.</summary>
    public float Circulation(int wing, int at) => m_Circulation[wing][at];

    // The mean of the rings on both sides, or the half of one at the ends; none behind the last row.
    private static float Circulation(in WakeSheet sheet, int row, int point)
    {
        if (row + 1 >= sheet.RowCount)
            return 0f;
        return 0.5f * ((point > 0 ? sheet.Circulation(row, point - 1) : 0f)
            + (point + 1 < sheet.PointsPerRow ? sheet.Circulation(row, point) : 0f));
    }
}
