namespace Alate.Cli;

/// <summary>Record of a flight: the last beat of every wing.</summary>
internal sealed class FlightRecord
{
    public FlightPlan Plan { get; init; }
    public Insect Insect { get; init; }

    /// <summary>Right and left wing of each kind in turn.</summary>
    public IReadOnlyList<RecordedWing> Wings { get; init; }

    public double Seconds { get; init; }
    public double Beats { get; init; }

    /// <summary>Velocity of the air that the wings draw along, m/s: right, up, ahead; 0 where the plan asks for none.</summary>
    public float3 InducedVelocity { get; init; }

    /// <summary>Time of one substep of all wings of the insect, microseconds, without the first beat.</summary>
    public double MicrosecondsPerSubstep { get; init; }

    /// <summary>Returns the angle of the abdomen above where it does not swing, radians; of an insect that has one.</summary>
    /// <param name="turns">Beats.</param>
    public float AbdomenAt(double turns) => Insect.Abdomen.AngleAt(turns, Wings[0].Flap, Wings[0].Parameters);
}
