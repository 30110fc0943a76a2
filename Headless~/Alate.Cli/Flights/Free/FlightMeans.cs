using Alate.Flight;

namespace Alate.Cli;

/// <summary>Means over whole beats of a free flight at constant velocity, without aid and wind. Angles in degrees.</summary>
/// <param name="Speed">Mean speed ahead, m/s.</param>
/// <param name="Climb">Mean climb, m/s.</param>
/// <param name="Error">Distance of the mean velocity from the wanted one, m/s.</param>
/// <param name="Pitch">Mean pitch of the body.</param>
/// <param name="PitchBob">Half of the range of the pitch.</param>
/// <param name="HeightBob">Half of the range of the height about its mean climb, millimetres.</param>
/// <param name="Frequency">Hertz.</param>
/// <param name="Flap">From end to end.</param>
/// <param name="Lift">Mean upward force over the weight.</param>
/// <param name="DownLift">Mean upward force over the weight in the half stroke downwards.</param>
/// <param name="UpSupport">Share of the upward impulse that falls on the half stroke upwards, 0 to 1; not a number where the body
/// floats.</param>
/// <param name="UpForce">Share of the half stroke upwards in the mean size of the force, 0 to 1.</param>
/// <param name="Power">Mean power that the wings give to the air, W.</param>
/// <param name="PowerPerMass">The same over the mass, W/kg.</param>
internal sealed record FlightMeans(
    double Speed, double Climb, double Error, double Pitch, double PitchBob, double HeightBob, double Frequency, double Flap, double Lift,
    double DownLift, double UpSupport,
    double UpForce, double Power, double PowerPerMass)
{
    /// <summary>Steps of a beat, seconds flown before the means, and seconds of the means; slow beats take more.</summary>
    private const double k_StepsPerBeat = 32, k_Settled = 3, k_Averaged = 2, k_LeastBeats = 12;

    /// <summary>Flies.</summary>
    /// <param name="model">The insect.</param>
    /// <param name="table">Its trims.</param>
    /// <param name="condition">Speed and climb; bounded by the table.</param>
    /// <param name="seconds">Least time of the means.</param>
    public static FlightMeans Fly(FlightModel model, TrimTable table, FlightCondition condition, double seconds = k_Averaged)
    {
        using var flight = new FreeFlight(model, table, condition);
        var command = FlightCommand.Fly(new float3(0f, condition.Climb, condition.Speed), 0f);
        float step = (float)(1 / (k_StepsPerBeat * flight.World.Read(flight.Wings[0]).Frequency));
        double averaged = Math.Max(seconds, k_LeastBeats * k_StepsPerBeat * step), settled = k_Settled / k_Averaged * averaged;
        var moments = new List<FreeMoment>();
        int beat = -1;
        while (flight.Time < settled + averaged || flight.Beats == beat)
        {
            beat = flight.Beats;
            flight.Step(command, step);
            if (flight.Time > settled && (moments.Count > 0 || flight.Beats != beat))
                moments.Add(FreeRun.Moment(flight));
        }

        return Of(model, moments, command.velocity);
    }

    internal static FlightMeans Of(FlightModel model, List<FreeMoment> moments, float3 wanted)
    {
        FreeMoment first = moments[0], last = moments[^1];
        double time = last.Time - first.Time;
        float3 velocity = (last.Position - first.Position) / (float)time;
        List<double> pitches = moments.ConvertAll(
            at => math.degrees((double)math.asin(math.clamp(math.rotate(at.Rotation, new float3(0f, 0f, 1f)).y, -1f, 1f))));
        List<double> heights = moments.ConvertAll(at => at.Position.y - velocity.y * (at.Time - first.Time));
        List<FreeMoment> down = moments.FindAll(at => at.Phase < Math.PI), up = moments.FindAll(at => at.Phase >= Math.PI);
        double lift = moments.Sum(at => at.Force.y), size = moments.Sum(at => math.length(at.Force)),
            power = moments.Average(at => at.Power);
        return new FlightMeans(
            velocity.z, velocity.y, math.length(velocity - wanted), pitches.Average(), 0.5 * (pitches.Max() - pitches.Min()),
            500 * (heights.Max() - heights.Min()),
            moments.Average(at => at.Frequency), 2 * math.degrees(moments.Average(at => at.Amplitude)), lift / moments.Count / model.Weight,
            down.Average(at => at.Force.y) / model.Weight, model.Floats ? double.NaN : up.Sum(at => at.Force.y) / lift,
            up.Sum(at => math.length(at.Force)) / size, power, power / model.Mass);
    }
}
