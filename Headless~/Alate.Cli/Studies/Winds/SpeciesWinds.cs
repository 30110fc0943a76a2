namespace Alate.Cli;

/// <summary>An insect in winds of several speeds, by today's model and by version 0.1.</summary>
/// <param name="Plan">Its flight.</param>
/// <param name="DisplayName">What it is called.</param>
/// <param name="SpeedShare">Factor on the plan's speeds.</param>
/// <param name="Wings">Each kind.</param>
internal sealed record SpeciesWinds(FlightPlan Plan, string DisplayName, double SpeedShare, IReadOnlyList<WingWinds> Wings)
{
    /// <summary>Measures all insects.</summary>
    /// <param name="plan">Which insects and winds.</param>
    /// <param name="progress">Told how many insects are done.</param>
    public static List<SpeciesWinds> Measure(WindPlan plan, Action<int> progress)
    {
        var measured = new List<SpeciesWinds>();
        foreach (FlightPlan flight in plan.Flights)
        {
            var insect = Insect.Of(flight);
            double share = WindPlan.ShareOf(flight.Definition);
            var speeds = plan.Speeds.Select(speed => share * speed).ToList();
            var wings = insect.Wings
                .Select(wing => new WingWinds(
                    wing.Name, Points(flight, wing, speeds, plan.InGusts), Points(flight.AsVersion01(), wing, speeds, plan.InGusts)))
                .ToList();
            measured.Add(new SpeciesWinds(flight, insect.DisplayName, share, wings));
            progress(measured.Count);
        }

        return measured;
    }

    private static List<WindPoint> Points(FlightPlan flight, InsectWing wing, List<double> speeds, bool inGusts)
    {
        using var tunnel = new WindTunnel(flight, wing);
        return speeds.ConvertAll(speed => tunnel.Measure(speed, inGusts));
    }
}
