namespace Alate.Cli;

/// <summary>Curves over the beat of the tethered dragonfly beside published ones.</summary>
internal static class DragonflyCurves
{
    /// <summary>Places of the beat.</summary>
    public const int Places = 50;

    private const string k_NoneFound = "no curve over the beat was found for this insect";

    /// <summary>Largest distance of a place from the middle of a stroke, beats.</summary>
    private const double k_Middle = 0.1;

    /// <summary>Curves over the beat of the tethered insect, at t/T = 0, 0.02, …</summary>
    public static List<ValidationCurve> Make(int substeps)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        DragonflyRun still = DragonflyRun.Fly(flight, true, substeps), rigid = DragonflyRun.Fly(flight, true, substeps, 1),
            soft = DragonflyRun.Fly(flight, false, substeps, 1);
        RecordedWing wing = soft.Record.Wings[0];
        List<BeatFrame> beat = wing.Beat;
        List<BladeElements.Moment> blades = BladeElements.Curve(flight, BladeElements.Point.MidChord, rigid.Record.InducedVelocity);
        double[] Shape(Func<BeatFrame, double> of) => soft.Even(beat.ConvertAll(frame => of(frame)), Places);
        double[] Blades(Func<BladeElements.Moment, double> of) =>
            Enumerable.Range(0, Places).Select(n => of(blades[n * blades.Count / Places])).ToArray();
        return
        [
            new("vertical-force", "vertical force / weight", [("no induced flow", still.Even(still.Lift, Places)),
                ("rigid", rigid.Even(rigid.Lift, Places)), ("flexible", soft.Even(soft.Lift, Places))],
                MeasuredDragonfly.TetheredForce.ToArray(), $"computed by {flight.Source}, mean of five beats")
            {
                Units = ["weights", "weight", "1"],
                Range = (-100, 100),
            },
            new("angle-of-attack", "angle of attack at 0.75 span, °",
                [("no induced flow", still.Even(still.Attack, Places)), ("blade elements", Blades(moment => moment.Attack)),
                    ("rigid", rigid.Even(rigid.Attack, Places)), ("flexible", soft.Even(soft.Attack, Places))],
                MeasuredDragonfly.TetheredAttack.ToArray(),
                $"measured by {flight.Source}, mean of five beats, as in still air: beside the curve without an induced flow; around the "
                + "upper turn few beats have points")
            {
                Range = (0, 90),
            },
            new("twist", "twist of the fore wing, °",
                [("flexible", Shape(frame => 180 / Math.PI * wing.Measurement.Twist(frame.Positions)))], null, k_NoneFound),
            new("camber", "camber of the fore wing, % chord",
                [("flexible", Shape(frame => 100 * wing.Measurement.Camber(frame.Positions)))],
                null, k_NoneFound) { Units = ["%", "% chord", "percent"], Range = (-100, 100) },
            new("tip-bend", "bend of the fore wing's tip, °", [("flexible", Shape(frame => 180 / Math.PI * wing.Measurement.Bend(frame)))],
                null, k_NoneFound),
            new("power", "power, W/kg", [("blade elements", Blades(moment => moment.Power)), ("rigid", rigid.Even(rigid.Power, Places)),
                ("flexible", soft.Even(soft.Power, Places))],
                null,
                FormattableString.Invariant($"{k_NoneFound}; a mean of {DragonflyVariants.HoverPower} W/kg by {DragonflyVariants.Hover}"))
            {
                Units = ["W/kg"],
                Range = (-10000, 10000),
            },
        ];
    }

    /// <summary>Mean over a tenth of a beat around the middle of a stroke.</summary>
    public static double Stroke(IReadOnlyList<double> curve, double middle) => Enumerable.Range(0, curve.Count)
        .Where(n => Math.Abs((double)n / curve.Count - middle - Math.Round((double)n / curve.Count - middle)) < k_Middle + 1e-9)
        .Average(n => curve[n]);

    /// <summary>Pearson's correlation, over the places where the second one has no hole.</summary>
    public static double Correlation(IReadOnlyList<double> a, IReadOnlyList<double> b)
    {
        List<(double A, double B)> pairs = a.Zip(b).Where(pair => double.IsFinite(pair.Second)).ToList();
        double meanA = pairs.Average(pair => pair.A), meanB = pairs.Average(pair => pair.B);
        double both = pairs.Sum(pair => (pair.A - meanA) * (pair.B - meanB));
        double alone = Math.Sqrt(
            pairs.Sum(pair => (pair.A - meanA) * (pair.A - meanA)) * pairs.Sum(pair => (pair.B - meanB) * (pair.B - meanB)));
        return Math.Clamp(both / alone, -1, 1);
    }
}
