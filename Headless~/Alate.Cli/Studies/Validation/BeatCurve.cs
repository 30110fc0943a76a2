namespace Alate.Cli;

/// <summary>A quantity over one beat, straight between the frames, over the end of the beat too.</summary>
internal sealed class BeatCurve
{
    private const int k_Intervals = 960;

    private readonly (double Turn, double Value)[] m_Points;

    /// <param name="frames">Of one beat.</param>
    /// <param name="values">[frame]</param>
    public BeatCurve(IReadOnlyList<RecordedFrame> frames, IReadOnlyList<double> values)
    {
        m_Points = frames.Select((frame, k) => (frame.Phase / (2 * Math.PI), values[k])).OrderBy(point => point.Item1).ToArray();
    }

    /// <summary>Values at t/T = 0, 1/n, …</summary>
    public double[] Even(int count) => Enumerable.Range(0, count).Select(n => At((double)n / count)).ToArray();

    /// <summary>
    /// Mean between two moments of the beat, by the trapezoidal rule: frames alone would count one end of it twice and the other not at
    /// all.
    /// </summary>
    /// <param name="from">t/T.</param>
    /// <param name="to">t/T, after it.</param>
    public double Mean(double from, double to)
    {
        double sum = 0.5 * (At(from) + At(to));
        for (int k = 1; k < k_Intervals; k++)
            sum += At(from + (to - from) * k / k_Intervals);
        return sum / k_Intervals;
    }

    private double At(double turn)
    {
        turn -= Math.Floor(turn);
        int after = Array.FindIndex(m_Points, point => point.Turn >= turn);
        (double Turn, double Value) b = after < 0 ? (m_Points[0].Turn + 1, m_Points[0].Value) : m_Points[after];
        (double Turn, double Value) a =
            after > 0 ? m_Points[after - 1] : after < 0 ? m_Points[^1] : (m_Points[^1].Turn - 1, m_Points[^1].Value);
        double share = b.Turn > a.Turn ? (turn - a.Turn) / (b.Turn - a.Turn) : 0;
        return a.Value + share * (b.Value - a.Value);
    }
}
