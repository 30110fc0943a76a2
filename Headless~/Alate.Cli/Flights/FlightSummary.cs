using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Alate.Cli.Flights;

/// <summary>The numbers of a flight.</summary>
internal sealed class FlightSummary
{
    private FlightSummary(FlightRecord flight)
    {
        Flight = flight;
        Wings = flight.Wings.Where(wing => !wing.Placement.IsLeft).Select(WingSummary.Of).ToList();
        LiftOverWeight = Lift(flight);
        NewtonIterationsMean = flight.Wings.SelectMany(wing => wing.Frames).Average(frame => frame.NewtonIterations);
        Resets = flight.Wings.Sum(wing => wing.Resets);
        Triangles = flight.Wings.Sum(wing => wing.Triangles.Length / 3);
    }

    public FlightRecord Flight { get; }

    /// <summary>Each kind of wing, the first being the main one.</summary>
    public IReadOnlyList<WingSummary> Wings { get; }

    public WingSummary Main => Wings[0];

    /// <summary>Mean force of the air on all wings along the world's up, over the weight of the insect.</summary>
    public double LiftOverWeight { get; }

    public double NewtonIterationsMean { get; }

    public int Resets { get; }

    /// <summary>Triangles of all wings.</summary>
    public int Triangles { get; }

    public static FlightSummary Of(FlightRecord flight) => new(flight);

    // The x of a left wing's force is mirrored, which the pitched up axis does not see.
    private static double Lift(FlightRecord flight)
    {
        const double k_Gravity = 9.81;
        float3 up = flight.Plan.UpOfBody;
        double lift = 0.0;
        foreach (RecordedWing wing in flight.Wings)
        {
            SpeciesSize size = wing.Wing.Species.Size;
            lift += size.wingMass * size.wingLength * wing.Frames.Average(frame => (double)math.dot(frame.AirForce, up));
        }

        return lift / (flight.Wings[0].Wing.Species.Size.insectMass * k_Gravity);
    }
}
