using Alate.Wake;

namespace Alate.Cli;

/// <summary>
/// Motion of a wing as it is flown: its edges at the last moment, and how they move. Once a beat is known, both are those of a Fourier
/// series through it, as a wake behind a recorded beat has them; poses between two substeps lie on straight lines, whose kinks the series
/// takes out. Before, velocities are differences.
/// </summary>
internal sealed class FlownWing : IWingMotion
{
    /// <summary>Moments that a velocity by differences needs.</summary>
    public const int FirstMoments = 3;

    private readonly BilinearSurface m_Surface;
    private readonly float3[][] m_History;
    private readonly float[] m_Shares, m_Rates;
    private readonly float3[] m_Points, m_Velocities;
    private long m_Count;

    /// <param name="beat">Moments of a beat.</param>
    /// <param name="rows">Rows of places from the leading to the trailing edge, 2 or more.</param>
    /// <param name="columns">Places of a row, 2 or more.</param>
    public FlownWing(int beat, int rows, int columns)
    {
        m_Surface = new BilinearSurface(rows, columns);
        int places = m_Surface.Count;
        m_History = [.. Enumerable.Range(0, beat).Select(_ => new float3[places])];
        (m_Points, m_Velocities) = (new float3[places], new float3[places]);
        (m_Shares, m_Rates) = (new float[beat], new float[beat]);
        for (int ago = 0; ago < beat; ago++)
        {
            m_Shares[ago] = 1f / beat;
            for (int harmonic = 1; harmonic <= Math.Min(FourierMotion.MostHarmonics, (beat - 1) / 2); harmonic++)
            {
                (double sin, double cos) = Math.SinCos(2.0 * Math.PI * harmonic * ago / beat);
                m_Shares[ago] += (float)(2.0 * cos / beat);
                m_Rates[ago] -= (float)(4.0 * Math.PI * harmonic * sin / beat);
            }
        }
    }

    /// <summary>True where the moments so far give a velocity.</summary>
    public bool IsKnown => m_Count >= FirstMoments;

    /// <summary>Forgets all moments.</summary>
    public void Restart() => m_Count = 0;

    /// <summary>Takes the next moment.</summary>
    /// <param name="places">[row · columns + column] Axes of the body.</param>
    /// <param name="scale">Reference lengths of their unit.</param>
    public void Move(ReadOnlySpan<float3> places, float scale)
    {
        float3[] now = Ago(0);
        for (int k = 0; k < now.Length; k++)
            now[k] = scale * places[k];
        if (m_Count + 1 < m_History.Length)
            Differ(now);
        else
            Blend();
        m_Count++;
    }

    /// <summary>Writes the last moment, whatever the time.</summary>
    public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
    {
        for (int k = 0; k < places.Length; k++)
        {
            points[k] = m_Surface.At(m_Points, places[k]);
            velocities[k] = m_Surface.At(m_Velocities, places[k]);
        }
    }

    // Of the moment that comes now, or some before it.
    private float3[] Ago(int moments) => m_History[(m_Count + m_History.Length - moments) % m_History.Length];

    private void Differ(float3[] now)
    {
        float3[] before = Ago(1), longBefore = Ago(2);
        for (int k = 0; k < now.Length; k++)
        {
            m_Points[k] = now[k];
            m_Velocities[k] = 0.5f * m_History.Length * (3f * now[k] - 4f * before[k] + longBefore[k]);
        }
    }

    private void Blend()
    {
        Array.Clear(m_Points);
        Array.Clear(m_Velocities);
        for (int ago = 0; ago < m_History.Length; ago++)
        {
            float3[] places = Ago(ago);
            for (int k = 0; k < places.Length; k++)
            {
                m_Points[k] += m_Shares[ago] * places[k];
                m_Velocities[k] += m_Rates[ago] * places[k];
            }
        }
    }
}
