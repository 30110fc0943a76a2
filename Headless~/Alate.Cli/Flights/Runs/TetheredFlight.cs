using System.Diagnostics;

namespace Alate.Cli;

/// <summary>Flies an insect: bakes its rigs, steps its wings substep by substep and records the last beat.</summary>
internal sealed class TetheredFlight : IDisposable
{
    /// <summary>Number of beats after which a beat is like the one before, so that its animation loops.</summary>
    private const int k_SettledBeats = 8;
    private const int k_StepsPerBeat = 4;

    /// <summary>Beats in which the induced flow settles besides.</summary>
    private const int k_InducedBeats = 6;

    private readonly FlightPlan m_Plan;
    private readonly Insect m_Insect;
    private readonly TetheredWings m_Wings;
    private readonly InducedStream m_Induced;
    private readonly double m_Frequency, m_Substep;
    private readonly int m_SubstepsPerBeat, m_Start;

    /// <summary>Bakes and places every wing; nothing has moved yet.</summary>
    /// <exception cref="UserException">A mesh and its skeleton do not fit, a parameter is out of range, or the time is shorter than a
    /// beat.</exception>
    public TetheredFlight(FlightPlan plan, Insect insect)
    {
        m_Plan = plan;
        m_Insect = insect;
        m_Wings = new TetheredWings(plan, insect);
        try
        {
            m_Frequency = m_Wings.Read(0).Frequency;
            m_SubstepsPerBeat = m_Wings.All[0].Parameters.substepsPerBeat;
            m_Substep = 1.0 / (m_Frequency * m_SubstepsPerBeat);
            int wanted = CountSteps();
            Steps = Math.Max(wanted, (k_SettledBeats + (plan.Induced == null ? 0 : k_InducedBeats)) * m_SubstepsPerBeat);
            m_Start = Steps - wanted;
        }
        catch
        {
            m_Wings.Dispose();
            throw;
        }

        if (plan.RecordsAir)
            m_Wings.RecordPatches();
        m_Induced = plan.Induced == null ? null : new InducedStream(plan, m_Wings);
    }

    /// <summary>Substeps of the whole flight, with those that it takes to settle before the clock starts.</summary>
    public int Steps { get; }

    /// <summary>Flies the insect of a plan.</summary>
    /// <exception cref="UserException">Anything the user can mend.</exception>
    public static FlightRecord Fly(FlightPlan plan)
    {
        using var flight = new TetheredFlight(plan, Insect.Of(plan));
        return flight.Run(_ => { });
    }

    /// <summary>Flies.</summary>
    /// <param name="progress">Told the substeps done so far.</param>
    public FlightRecord Run(Action<int> progress)
    {
        var cost = new List<double>();
        int done = 0;
        while (done < Steps)
        {
            // The last beat one substep at a time, for the record; what is before it in a few steps of many, as a game would.
            int left = Steps - m_SubstepsPerBeat - done;
            int count = left > 0 ? Math.Min(left, Math.Max(1, m_SubstepsPerBeat / k_StepsPerBeat)) : 1;
            if (m_Induced != null)
                count = Math.Min(count, m_SubstepsPerBeat - done % m_SubstepsPerBeat);
            cost.Add(Advance(count));
            done += count;
            if (left > 0)
                Draw(count, done);
            if (left <= 0)
                Record((done - m_Start) * m_Substep);
            progress(done);
        }

        for (int k = 0; k < m_Wings.All.Count; k++)
        {
            WingReading reading = m_Wings.Read(k);
            m_Wings.All[k].Frequency = reading.Frequency;
            m_Wings.All[k].Resets = reading.Resets;
        }

        return new FlightRecord
        {
            Plan = m_Plan,
            Insect = m_Insect,
            Wings = m_Wings.All,
            Seconds = (Steps - m_Start) * m_Substep,
            Beats = (double)(Steps - m_Start) / m_SubstepsPerBeat,
            MicrosecondsPerSubstep = Median(cost, m_SubstepsPerBeat),
            InducedVelocity = m_Induced?.Velocity ?? default,
        };
    }

    /// <summary>Frees the world and the rigs.</summary>
    public void Dispose() => m_Wings.Dispose();

    // The wings draw air along: what they meet follows at the end of each beat but the recorded one.
    private void Draw(int count, int done)
    {
        m_Induced?.Add(count);
        if (done % m_SubstepsPerBeat == 0)
            m_Induced?.EndBeat();
    }

    // Microseconds of each substep.
    private double Advance(int count)
    {
        long before = Stopwatch.GetTimestamp();
        m_Wings.World.Step((float)(count * m_Substep));
        return Stopwatch.GetElapsedTime(before).TotalMicroseconds / count;
    }

    // Of the steps of many substeps where there are any: the middle one, which other programs on the machine disturb least.
    internal static double Median(List<double> cost, int substepsPerBeat)
    {
        List<double> many = cost.GetRange(0, Math.Max(cost.Count - substepsPerBeat, 0));
        List<double> chosen = many.Count > 0 ? many : cost;
        chosen.Sort();
        return chosen[chosen.Count / 2];
    }

    private int CountSteps()
    {
        if (m_Plan.Seconds is not double seconds)
            return k_SettledBeats * m_SubstepsPerBeat;
        double steps = Math.Ceiling(seconds * m_Frequency * m_SubstepsPerBeat - 1e-6);
        if (steps >= m_SubstepsPerBeat)
            return (int)Math.Min(steps, int.MaxValue);
        throw new UserException(FormattableString.Invariant(
            $"--seconds {seconds} is shorter than one beat of this wing, {1.0 / m_Frequency:0.####} s at {m_Frequency:0.###} Hz."));
    }

    private void Record(double time)
    {
        m_Wings.World.Skin();
        for (int k = 0; k < m_Wings.All.Count; k++)
            m_Wings.All[k].Frames.Add(m_Wings.FrameOf(k, time));
    }
}
