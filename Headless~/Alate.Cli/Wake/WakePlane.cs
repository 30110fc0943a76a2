using Alate.Wake;
using static Alate.Formats.CsvTable;

namespace Alate.Cli;

/// <summary>
/// Upright plane behind an insect, across its way, with the velocity that the wake gives to the air there: means over a beat, along the
/// world's axes.
/// </summary>
internal sealed class WakePlane
{
    /// <summary>Half of the width and of the height, and the step between places, wing lengths.</summary>
    private const float k_HalfWidth = 1.6f, k_HalfHeight = 1.4f, k_Step = 0.05f;

    private readonly FlightPlan m_Flight;
    private readonly float3[] m_Places, m_Seen, m_Now, m_Sums;
    private readonly double m_Length, m_Period;
    private int m_Count;

    /// <param name="flight">How the body is pitched.</param>
    /// <param name="distance">Metres behind the middle of the thorax.</param>
    /// <param name="length">Metres of a wing length.</param>
    /// <param name="period">Seconds of a beat.</param>
    public WakePlane(FlightPlan flight, double distance, double length, double period)
    {
        m_Flight = flight;
        m_Length = length;
        m_Period = period;
        Columns = 2 * (int)Math.Round(k_HalfWidth / k_Step) + 1;
        Rows = 2 * (int)Math.Round(k_HalfHeight / k_Step) + 1;
        m_Places = new float3[Columns * Rows];
        for (int k = 0; k < m_Places.Length; k++)
        {
            m_Places[k] = new float3(
                (k % Columns) * k_Step - k_HalfWidth, k_HalfHeight - (k / Columns) * k_Step, (float)(-distance / length));
        }

        m_Seen = Array.ConvertAll(m_Places, flight.ToBody);
        m_Now = new float3[m_Places.Length];
        m_Sums = new float3[m_Places.Length];
    }

    /// <summary>Places from left to right of the insect.</summary>
    public int Columns { get; }

    /// <summary>Places from above to below.</summary>
    public int Rows { get; }

    /// <summary>Adds the air of a step.</summary>
    public void Add(FreeWake wake)
    {
        wake.Velocities(m_Seen, m_Now);
        for (int k = 0; k < m_Sums.Length; k++)
            m_Sums[k] += m_Flight.ToWorld(m_Now[k]);
        m_Count++;
    }

    /// <summary>A place, metres from the middle of the thorax: right, up, ahead.</summary>
    public float3 Place(int column, int row) => (float)m_Length * m_Places[row * Columns + column];

    /// <summary>Velocity at a place, m/s: right, up, ahead.</summary>
    public float3 Velocity(int column, int row) => (float)(m_Length / m_Period) / m_Count * m_Sums[row * Columns + column];

    /// <summary>
    /// Vorticity across the plane, 1/s: twice the rate at which the air turns, positive clockwise to who looks along the insect's way.
    /// </summary>
    public double Vorticity(int column, int row)
    {
        int left = Math.Max(column - 1, 0), right = Math.Min(column + 1, Columns - 1), above = Math.Max(row - 1, 0),
            below = Math.Min(row + 1, Rows - 1);
        double step = k_Step * m_Length;
        return (Velocity(column, above).x - Velocity(column, below).x) / ((below - above) * step)
            - (Velocity(right, row).y - Velocity(left, row).y) / ((right - left) * step);
    }

    /// <summary>Rows of plane.csv.</summary>
    public IEnumerable<IReadOnlyList<string>> Table()
    {
        yield return ["x_m", "y_m", "z_m", "velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s", "vorticity_1_s"];
        for (int row = 0; row < Rows; row++)
        {
            for (int column = 0; column < Columns; column++)
            {
                float3 place = Place(column, row), velocity = Velocity(column, row);
                yield return
                [
                    Number(place.x), Number(place.y), Number(place.z), Number(velocity.x), Number(velocity.y), Number(velocity.z),
                    Number(Vorticity(column, row)),
                ];
            }
        }
    }
}
