namespace Alate.Cli;

/// <summary>
/// Flight and wake in rounds, until each is that of the other: fly, compute the wake, replay its air at the wings, fly again. Wings that
/// bend meet their wake in this way without being stepped together with it.
/// </summary>
internal sealed class WakeRounds : IDisposable
{
    /// <summary>Share of the way to the air of the last wake: all of it overshoots where wings beat in their own wake.</summary>
    private const float k_Step = 0.9f;

    private readonly FlightPlan m_Plan;
    private readonly Insect m_Insect;
    private readonly WakePlan m_Wake;
    private readonly List<WakeRound> m_Rounds = [];
    private FlightInflow m_Replayed;
    private TetheredFlight m_Flight;

    /// <summary>Prepares the first round.</summary>
    /// <param name="plan">The flight in air at rest.</param>
    /// <param name="insect">The insect.</param>
    /// <param name="wake">The wake.</param>
    public WakeRounds(FlightPlan plan, Insect insect, WakePlan wake)
    {
        m_Plan = plan;
        m_Insect = insect;
        m_Wake = wake;
        m_Flight = new TetheredFlight(plan, insect);
        Steps = m_Flight.Steps + wake.Beats * wake.StepsPerBeat;
    }

    /// <summary>Steps of a round.</summary>
    public int Steps { get; }

    /// <summary>[round] Results; the first one is of a flight in air at rest.</summary>
    public IReadOnlyList<WakeRound> All => m_Rounds;

    /// <summary>The flight in air at rest.</summary>
    public FlightRecord Still { get; private set; }

    /// <summary>The last wake.</summary>
    public WakeFlight Wake { get; private set; }

    /// <summary>[step] Loads of the last wake over its last beat.</summary>
    public List<WakeMoment> Beat { get; private set; }

    /// <summary>Air that the last wake sets moving.</summary>
    public FlightInflow Found { get; private set; }

    /// <summary>Runs the next round.</summary>
    /// <param name="progress">Told the steps of this round done so far.</param>
    public void Run(Action<int> progress)
    {
        m_Flight ??= new TetheredFlight(m_Plan with { Inflow = m_Replayed }, m_Insect);
        FlightRecord record = m_Flight.Run(progress);
        int flown = m_Flight.Steps;
        m_Flight.Dispose();
        m_Flight = null;
        Still ??= record;
        Wake?.Dispose();
        Wake = new WakeFlight(record, m_Wake);
        Beat = Wake.Run(done => progress(flown + done));
        Found = InflowOf(Wake, Beat);
        m_Rounds.Add(WakeRound.Of(record, Beat, Found.ChangeFrom(m_Replayed)));
        m_Replayed = m_Replayed == null ? Found : m_Replayed.Towards(Found, k_Step);
    }

    /// <summary>Frees the memory.</summary>
    public void Dispose()
    {
        m_Flight?.Dispose();
        Wake?.Dispose();
    }

    /// <summary>Mean and two harmonics of the air at each wing.</summary>
    internal static FlightInflow InflowOf(WakeFlight wake, IReadOnlyList<WakeMoment> beat) => new(
        Enumerable.Range(0, wake.Wings.Count).ToDictionary(
            k => (wake.Wings[k].Wing.Name, wake.Wings[k].Placement.Side),
            k => beat.Aggregate(default(WingInflow),
                (sum, at) => sum + WingInflow.Sample(at.Turns, at.Wings[k].Inflow) * (1f / beat.Count))));
}
