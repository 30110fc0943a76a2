using Alate.Wake;

namespace Alate.Cli;

/// <summary>Motion of a wing as it is flown: its edges at the last moment, and how they moved through the last three.</summary>
internal sealed class FlownWing : IWingMotion
{
    private readonly int m_Beat;
    private readonly float3[] m_Velocities;
    private float3[] m_Now, m_Before, m_LongBefore;

    /// <param name="beat">Moments of a beat.</param>
    /// <param name="places">Places of a moment.</param>
    public FlownWing(int beat, int places)
    {
        m_Beat = beat;
        (m_Now, m_Before, m_LongBefore) = (new float3[places], new float3[places], new float3[places]);
        m_Velocities = new float3[places];
    }

    /// <summary>Takes the next moment.</summary>
    /// <param name="places">Axes of the body.</param>
    /// <param name="scale">Reference lengths of their unit.</param>
    public void Move(ReadOnlySpan<float3> places, float scale)
    {
        (m_Now, m_Before, m_LongBefore) = (m_LongBefore, m_Now, m_Before);
        for (int k = 0; k < m_Now.Length; k++)
        {
            m_Now[k] = scale * places[k];
            m_Velocities[k] = 0.5f * m_Beat * (3f * m_Now[k] - 4f * m_Before[k] + m_LongBefore[k]);
        }
    }

    /// <summary>Writes the last moment, whatever the time: the places are those of a lattice of strips.</summary>
    public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
    {
        m_Now.AsSpan(0, places.Length).CopyTo(points);
        m_Velocities.AsSpan(0, places.Length).CopyTo(velocities);
    }
}
