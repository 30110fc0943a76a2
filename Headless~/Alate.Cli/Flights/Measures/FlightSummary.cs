namespace Alate.Cli;

/// <summary>The numbers of a flight.</summary>
internal sealed class FlightSummary
{
    private const double k_BearableP99 = 8.0, k_BearableMax = 25.0;

    private readonly Lazy<Plausibility> m_Plausibility;

    private FlightSummary(FlightRecord flight)
    {
        Flight = flight;
        Wings = flight.Wings.Where(wing => !wing.Placement.IsLeft).Select(WingSummary.Of).ToList();
        (MeanForce, MeanMoment) = MeanAir(flight);
        MeanPower = WingPower.Mean(
            flight.Wings.SelectMany(wing => wing.Frames).Select(frame => frame.Power), flight.Wings[0].Frames.Count);
        LiftOverWeight = math.dot(MeanForce, flight.Plan.UpOfBody) / (flight.Wings[0].Wing.Preset.Size.insectMass * EarthGravity.Precise);
        NewtonIterationsMean = flight.Wings.SelectMany(wing => wing.Frames).Average(frame => frame.NewtonIterations);
        Resets = flight.Wings.Sum(wing => wing.Resets);
        m_Plausibility = new(() => Plausibility.Of(flight));
        Triangles = flight.Wings.Sum(wing => wing.Triangles.Length / 3);
    }

    public FlightRecord Flight { get; }

    /// <summary>Each kind of wing, the first being the main one.</summary>
    public IReadOnlyList<WingSummary> Wings { get; }

    public WingSummary Main => Wings[0];

    /// <summary>Mean force of the air on all wings in body axes, newtons: right, up, ahead.</summary>
    public float3 MeanForce { get; }

    /// <summary>
    /// Mean moment of the air on all wings about the middle of the thorax in body axes, newton metres: nose down, nose right, right wing
    /// up.
    /// </summary>
    public float3 MeanMoment { get; }

    /// <summary>Mean powers of all wings.</summary>
    public WingPower MeanPower { get; }

    /// <summary>True where some wing is driven outside its limits: beyond 8 % at the 99th percentile or 25 % anywhere.</summary>
    public bool IsOverstretched => Overstretched != null;

    /// <summary>The wing that is farthest outside what it bears; null where none is.</summary>
    public WingSummary Overstretched => Wings.Where(wing => Strain(wing) > 1).MaxBy(Strain);

    /// <summary>Mean force of the air on all wings along the world's up, over the weight of the insect.</summary>
    public double LiftOverWeight { get; }

    public double NewtonIterationsMean { get; }

    public int Resets { get; }

    /// <summary>Groups of the insect's numbers beside those of real ones.</summary>
    public Plausibility Plausibility => m_Plausibility.Value;

    /// <summary>Triangles of all wings.</summary>
    public int Triangles { get; }

    public static FlightSummary Of(FlightRecord flight) => new(flight);

    // Of a wing over what it bears.
    internal static double Strain(WingSummary wing) =>
        Math.Max(wing.EdgeStretchP99Pct / k_BearableP99, wing.EdgeStretchMaxPct / k_BearableMax);

    private static (float3 Force, float3 Moment) MeanAir(FlightRecord flight)
    {
        float3 force = default, moment = default;
        foreach (RecordedWing wing in flight.Wings)
        {
            PresetSize size = wing.Wing.Preset.Size;
            float unit = size.wingMass * size.wingLength / wing.Frames.Count;
            foreach (RecordedFrame frame in wing.Frames)
            {
                force += unit * wing.Placement.DirectionToBody(frame.AirForce);
                moment += unit * size.wingLength * wing.Placement.AxisToBody(frame.AirMoment);
            }
        }

        return (force, moment);
    }
}
