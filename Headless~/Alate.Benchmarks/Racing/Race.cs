using System;
using System.Diagnostics;

namespace Alate.Benchmarks;

/// <summary>
/// Times several ways of doing the same in one process, in turn, many rounds: what disturbs the machine disturbs all of them,
/// and the best round of each is nearest to what the code itself costs.
/// </summary>
internal static class Race
{
    private const int k_LeastRounds = 40;
    private const int k_MostRounds = 400;
    private const double k_RoundSeconds = 250e-6;
    private const double k_RaceSeconds = 1.2;

    /// <summary>Nanoseconds per unit of each contestant, in their order.</summary>
    public static double[] Run(params Contestant[] contestants)
    {
        var repeats = Array.ConvertAll(contestants, Repeats);
        var best = new double[contestants.Length];
        Array.Fill(best, double.PositiveInfinity);
        var start = Stopwatch.GetTimestamp();
        for (var round = 0; round < k_LeastRounds || (round < k_MostRounds && Seconds(start) < k_RaceSeconds); round++)
        {
            for (var k = 0; k < contestants.Length; k++)
                best[k] = Math.Min(best[k], Time(contestants[k].Work, repeats[k]));
        }

        for (var k = 0; k < contestants.Length; k++)
            best[k] *= 1e9 / (repeats[k] * contestants[k].Units);
        return best;
    }

    /// <summary>Nanoseconds per unit of one contestant alone.</summary>
    public static double Alone(Contestant contestant) => Run(contestant)[0];

    /// <summary>Seconds of the fastest of a few calls; for work that takes milliseconds.</summary>
    public static double Best(int calls, Action work)
    {
        var best = double.PositiveInfinity;
        for (var call = 0; call < calls; call++)
            best = Math.Min(best, Time(work, 1));
        return best;
    }

    // Warm, then as many calls as fill a round.
    private static int Repeats(Contestant contestant)
    {
        contestant.Work();
        for (var repeats = 1; ; repeats *= 2)
        {
            var seconds = Math.Min(Time(contestant.Work, repeats), Time(contestant.Work, repeats));
            if (seconds >= k_RoundSeconds)
                return repeats;
        }
    }

    private static double Time(Action work, int repeats)
    {
        var start = Stopwatch.GetTimestamp();
        for (var k = 0; k < repeats; k++)
            work();
        return Seconds(start);
    }

    private static double Seconds(long start) => (Stopwatch.GetTimestamp() - start) / (double)Stopwatch.Frequency;
}
