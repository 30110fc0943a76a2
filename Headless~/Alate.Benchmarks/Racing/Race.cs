using System;
using System.Diagnostics;
using System.Linq;

namespace Alate.Benchmarks;

/// <summary>
/// Times several ways of doing the same in one process, in turn, many rounds: what disturbs the machine disturbs all of them,
/// and the best round of each is nearest to what the code itself costs.
/// </summary>
internal sealed class Race
{
    private const int k_LeastRounds = 40;
    private const int k_MostRounds = 400;
    private const double k_RoundSeconds = 250e-6;
    private const double k_RaceSeconds = 1.2;

    private readonly Contestant m_Contestant;
    private readonly int m_Repeats;
    private readonly double[] m_Best;

    private Race(Contestant contestant)
    {
        m_Contestant = contestant;
        m_Repeats = contestant.Phases > 1 ? 1 : Repeats(contestant.Work);
        m_Best = new double[contestant.Phases];
        Array.Fill(m_Best, double.PositiveInfinity);
    }

    private double NanosecondsPerUnit => 1e9 * m_Best.Average() / (m_Repeats * m_Contestant.Units);

    /// <summary>Nanoseconds per unit of each contestant, in their order.</summary>
    public static double[] Run(params Contestant[] contestants) => Run(k_LeastRounds, contestants);

    /// <inheritdoc cref="Run(Contestant[])"/>
    public static double[] Run(int leastRounds, params Contestant[] contestants)
    {
        Race[] lanes = Array.ConvertAll(contestants, contestant => new Race(contestant));
        long start = Stopwatch.GetTimestamp();
        for (int round = 0; round < leastRounds || (round < k_MostRounds && Seconds(start) < k_RaceSeconds); round++)
        {
            foreach (Race lane in lanes)
                lane.Round();
        }

        return Array.ConvertAll(lanes, lane => lane.NanosecondsPerUnit);
    }

    private void Round()
    {
        m_Contestant.Prepare?.Invoke();
        for (int phase = 0; phase < m_Best.Length; phase++)
            m_Best[phase] = Math.Min(m_Best[phase], Time(m_Contestant.Work, m_Repeats));
    }

    // Warm, then as many calls as fill a round.
    private static int Repeats(Action work)
    {
        work();
        for (int repeats = 1; ; repeats *= 2)
        {
            if (Math.Min(Time(work, repeats), Time(work, repeats)) >= k_RoundSeconds)
                return repeats;
        }
    }

    private static double Time(Action work, int repeats)
    {
        long start = Stopwatch.GetTimestamp();
        for (int k = 0; k < repeats; k++)
            work();
        return Seconds(start);
    }

    private static double Seconds(long start) => (Stopwatch.GetTimestamp() - start) / (double)Stopwatch.Frequency;
}
