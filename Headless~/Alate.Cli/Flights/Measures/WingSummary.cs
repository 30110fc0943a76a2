namespace Alate.Cli;

/// <summary>The numbers of one kind of wing over the last beat, degrees and per cent.</summary>
internal sealed record WingSummary(
    string Name,
    double FrequencyHz,
    double TwistPpDeg,
    double CamberMinPct,
    double CamberMaxPct,
    double TipBendPpDeg,
    double TipBendMaxDeg,
    double LagDeg,
    double TipLagDeg,
    double EdgeStretchMaxPct,
    double EdgeStretchP99Pct)
{
    /// <summary>Summary of the wing's joints.</summary>
    public WingStiffness Stiffness { get; init; }

    /// <summary>Measures the right wing of a kind.</summary>
    public static WingSummary Of(RecordedWing wing)
    {
        WingDeformation beat = wing.Measurement.Measure(wing.Beat);
        return new WingSummary(
            wing.Wing.Name,
            wing.Frequency,
            math.degrees(beat.TwistRange),
            100.0 * beat.CamberMin,
            100.0 * beat.CamberMax,
            math.degrees(beat.TipBendRange),
            math.degrees(beat.TipBendMax),
            math.degrees(beat.Lag),
            math.degrees(beat.TipLag),
            100.0 * beat.StretchMax,
            100.0 * beat.Stretch99)
        {
            Stiffness = wing.Stiffness,
        };
    }
}
