namespace Alate.Cli;

/// <summary>Flies one insect again and again with one number changed.</summary>
internal sealed class Sweep
{
    private Sweep(SweepPlan plan, List<SweepPoint> points)
    {
        Plan = plan;
        Points = points;
    }

    public SweepPlan Plan { get; }

    /// <summary>Points with the wave in the order of the values, then without it.</summary>
    public IReadOnlyList<SweepPoint> Points { get; }

    /// <summary>The flights with or without the wave; none where the plan leaves them out.</summary>
    public List<SweepPoint> With(bool wave) => Points.Where(point => point.HasWave == wave).ToList();

    /// <summary>Flies all.</summary>
    /// <param name="plan">What to fly.</param>
    /// <param name="progress">Told how many of <see cref="Flights"/> are done.</param>
    public static Sweep Fly(SweepPlan plan, Action<int> progress)
    {
        var points = new List<SweepPoint>();
        foreach (bool wave in Waves(plan))
        {
            foreach (double value in plan.Values)
            {
                points.Add(Fly(plan, value, wave));
                progress(points.Count);
            }
        }

        return new Sweep(plan, points);
    }

    /// <summary>Number of points of a plan.</summary>
    public static int Flights(SweepPlan plan) => plan.Values.Count * Waves(plan).Length;

    private static bool[] Waves(SweepPlan plan) => plan.Waves switch
    {
        SweepWaves.On => [true],
        SweepWaves.Off => [false],
        _ => [true, false],
    };

    private static SweepPoint Fly(SweepPlan plan, double value, bool wave)
    {
        FlightPlan flight = plan.Parameter.In(plan.Flight, value) with
        {
            Column = wave
            ? ComparisonColumn.FullModel
            : ComparisonColumn.NoWave
        };
        FlightRecord record = TetheredFlight.Fly(flight), driven = TetheredFlight.Fly(flight with { HoldJoints = true });
        var cambers = new List<double>();
        for (int k = 0; k < record.Wings.Count; k++)
        {
            RecordedWing wing = record.Wings[k];
            if (!wing.Placement.IsLeft)
                cambers.Add(100.0 * wing.Measurement.CamberBeyond(wing.Beat, driven.Wings[k].Beat));
        }

        return new SweepPoint(value, wave, FlightSummary.Of(record), cambers);
    }
}
