namespace Alate.Cli;

/// <summary>One insect by one model at several numbers of substeps, and at so many that more would change nothing.</summary>
internal sealed class SchemeFlights
{
    private readonly FlightPlan m_Plan;
    private readonly List<RecordedWing> m_Reference;

    /// <summary>Flies the reference.</summary>
    /// <param name="plan">The flight; its substeps are replaced.</param>
    public SchemeFlights(FlightPlan plan)
    {
        m_Plan = plan;
        Reference = TetheredFlight.Fly(plan with { Substeps = ConvergencePlan.ReferenceSubsteps });
        m_Reference = RightWings(Reference);
    }

    /// <summary>The flight that all others are held against.</summary>
    public FlightRecord Reference { get; }

    /// <summary>[kind of wing] Error at a number of substeps, % of the wing's length.</summary>
    public List<double> ErrorsAt(int substeps) => RightWings(TetheredFlight.Fly(m_Plan with { Substeps = substeps }))
        .Select((wing, kind) => JointError.Percent(wing, m_Reference[kind])).ToList();

    private static List<RecordedWing> RightWings(FlightRecord flight) => flight.Wings.Where(wing => !wing.Placement.IsLeft).ToList();
}
