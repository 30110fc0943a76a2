using Alate.Flight;

namespace Alate.Cli;

/// <summary>Record of a free flight.</summary>
/// <param name="Insect">Who flew.</param>
/// <param name="Moments">Each step.</param>
/// <param name="Centre">Centre of mass from the middle of the thorax, metres.</param>
/// <param name="Weight">N.</param>
/// <param name="Beat">A beat on the spot as in the middle of the flight, for pictures.</param>
internal sealed record FreeRecord(
    InsectDefinition Insect, IReadOnlyList<FreeMoment> Moments, float3 Centre, double Weight, FlightRecord Beat)
{
    /// <summary>All that is needed to fly it again.</summary>
    public FlightRecording Recording { get; init; }

    /// <summary>Middle of the thorax, metres.</summary>
    public float3 Thorax(in FreeMoment at) => at.Position - math.rotate(at.Rotation, Centre);

    /// <summary>Share of the weight's support that falls on the half stroke upwards, 0 to 1.</summary>
    public double UpstrokeShare
    {
        get
        {
            double all = Moments.Sum(at => at.Force.y), up = Moments.Where(at => at.Phase >= System.Math.PI).Sum(at => at.Force.y);
            return up / all;
        }
    }
}
