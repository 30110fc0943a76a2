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

    /// <summary>Side and kind of each wing.</summary>
    public IReadOnlyList<string> WingNames { get; init; } = [];

    /// <summary>Sentence about hover and climbs that the table lacks; null where it has both.</summary>
    public string Missing { get; init; }

    /// <summary>[moment][wing] Powers.</summary>
    public IReadOnlyList<WingPower[]> Powers { get; init; } = [];

    /// <summary>Mean upward force of the air over the weight.</summary>
    public double LiftOverWeight => Moments.Average(at => at.Force.y) / Weight;

    /// <summary>Mean power of the aid, W.</summary>
    public double AidPower => Moments.Average(at => at.AidPower);

    /// <summary>Mean powers of all wings.</summary>
    public WingPower MeanPower => WingPower.Mean(Powers.SelectMany(wings => wings), Moments.Count);

    /// <summary>Velocity off that which the insect followed, root mean square, m/s; bob and all.</summary>
    public double VelocityError => System.Math.Sqrt(Moments.Average(at => math.lengthsq(at.Velocity - at.Wanted)));

    /// <summary>Tumbles in order.</summary>
    public IReadOnlyList<FlightTumble> Tumbles
    {
        get
        {
            var tumbles = new List<FlightTumble>();
            var watch = new TumbleWatch();
            for (int k = 0; k < Moments.Count; k++)
            {
                FreeMoment at = Moments[k];
                double from = k > 0 ? Moments[k - 1].Time : 0;
                float3 moved = k > 0 ? at.Position - Moments[k - 1].Position : at.Position;
                if (watch.Step(at.State == FlightState.Tumbling, moved, at.Time, (float)(at.Time - from)) && !watch.IsTumbling)
                    tumbles.Add(watch.Last);
            }

            return watch.IsTumbling ? [.. tumbles, watch.Last] : tumbles;
        }
    }

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
