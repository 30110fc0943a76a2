namespace Alate.Cli;

/// <summary>Comparisons with published flights of dragonflies.</summary>
internal static class DragonflyRows
{
    /// <summary>Substeps of the rows, and those of their limit.</summary>
    public const int Substeps = 240, FineSubsteps = 480;

    private const int k_Places = 50;
    private const double k_Bearing = 0.12, k_WithInflow = 0.40, k_WithWake = 0.30, k_Wake = 1.2, k_Correlation = 0.9, k_Attack = 10;

    /// <summary>
    /// Middles of the fore wing's strokes: its flap is highest at t/T = 0.19 and lowest at 0.69, and they reach a tenth of a beat to both
    /// sides.
    /// </summary>
    private const double k_MiddleDown = 0.44, k_MiddleUp = 0.94, k_Middle = 0.1;

    /// <summary>Power of a hovering dragonfly, W/kg, and its angle of attack in the middle of the downstroke, degrees.</summary>
    private const double k_HoverPower = 37, k_HoverAttack = 52;

    private const string k_Hover = "Sun and Lan 2004, J. exp. Biol. 207:1887, computed for a hovering Aeshna juncea",
        k_NoneFound = "no curve over the beat was found for this insect";
    private const string k_OwnDrag = ", drag of a dragonfly's wing", k_Even = "the downwash of momentum theory is even and steady";
    private const string k_Pitching = "what the wing's pitching adds to the air it meets; the coefficients were measured at steady angles",
        k_Lean = "what is left is within the reading of the pitch angles from plots: 5° of it change the thrust by about 0.1";
    private const string k_Angles = "the motion is flown by the first four harmonics of the mean beat, without its deviations from the "
        + "cone: it misses the dip of the measured angle at a third of the beat";

    /// <summary>Weight support and thrust of the three flights.</summary>
    public static IEnumerable<ValidationRow> Flights(Fineness fineness, Action done)
    {
        for (int k = 0; k < MeasuredDragonfly.Flights.Count; k++)
        {
            MeasuredDragonfly flight = MeasuredDragonfly.Flights[k];
            double axis = BladeElements.Lift(flight, BladeElements.Point.Axis),
                middle = BladeElements.Lift(flight, BladeElements.Point.MidChord);
            string cause = string.Create(
                CultureInfo.InvariantCulture,
                $"what the wing's pitching adds to the air it meets: "
                + $"blade elements apart from the model give {axis:0.00} with the stream met on the pitching axis and {middle:0.00} "
                + $"in the middle of the chord, where a stiff wing of uniform chord meets it; "
                + $"the coefficients were measured at steady angles");
            if (k == 0)
            {
                cause += "; with the fore wing's published twist, which is not prescribed here, "
                    + FormattableString.Invariant($"{BladeElements.Lift(flight, BladeElements.Point.Axis, true):0.00} and ")
                    + FormattableString.Invariant($"{BladeElements.Lift(flight, BladeElements.Point.MidChord, true):0.00}");
            }
            cause +=
                FormattableString.Invariant($". Both fall to {BladeElements.Lift(flight, BladeElements.Point.Axis, ownDrag: true):0.00} ")
                + FormattableString.Invariant($"and {BladeElements.Lift(flight, BladeElements.Point.MidChord, ownDrag: true):0.00} with ")
                + "the drag of a dragonfly's wing";
            foreach ((bool rigid, double wake, bool own) in new[] { (true, 0.0, false), (true, 1.0, false), (false, 0.0, false),
                (true, 0.0, true), (true, 1.0, true) })
            {
                DragonflyRun ours = DragonflyRun.Fly(flight, rigid, fineness.Substeps, wake, ownDrag: own),
                    fine = DragonflyRun.Fly(flight, rigid, fineness.Fine, wake, ownDrag: own);
                string wings = (rigid ? "rigid wings" : "flexible wings") + Inflow(fine, wake) + (own ? k_OwnDrag : "");
                yield return new ValidationRow(
                    $"dragonfly, flight {k + 1}, {wings}: lift over weight", 1 - k_Bearing, 1 + k_Bearing, "1 ± 0.12: steady flight",
                    flight.Source,
                    ours.Lift.Average(), fine.Lift.Average(),
                    own ? wake > 0 ? k_Even : k_Pitching : wake > 0 ? Drawn(flight, fine) : rigid ? cause : "as with rigid wings");
                yield return new ValidationRow(
                    $"dragonfly, flight {k + 1}, {wings}: thrust over weight", 0, double.PositiveInfinity,
                    "0 or more: the drag of the body", flight.Source,
                    ours.Thrust.Average(), fine.Thrust.Average(), own ? k_Lean : Dragged(flight, fine.Record.InducedVelocity));
                done();
            }
        }
    }

    /// <summary>The tethered insect's vertical force.</summary>
    public static IEnumerable<ValidationRow> Tethered(Fineness fineness, Action done)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        IReadOnlyList<double> measured = MeasuredDragonfly.TetheredForce;
        double mean = measured.Average(), peak = measured.Max();
        foreach ((double wake, bool addedMass, bool own) in new[] { (0, false, false), (1, false, false), (k_Wake, false, false),
            (1, true, false), (1, false, true) })
        {
            string cause = wake > 0 ? k_Even : Still(flight);
            double band = wake > 1 ? k_WithWake : k_WithInflow;
            DragonflyRun run = DragonflyRun.Fly(flight, true, fineness.Substeps, wake, addedMass, own),
                finer = DragonflyRun.Fly(flight, true, fineness.Fine, wake, addedMass, own);
            string name = "tethered dragonfly" + (wake > 0 ? Inflow(finer, wake) : ", no induced flow") + (addedMass ? ", added mass" : "")
                + (own ? k_OwnDrag : "");
            double[] ours = run.Even(run.Lift, k_Places), fine = finer.Even(finer.Lift, k_Places);
            yield return new ValidationRow(
                $"{name}: correlation of the vertical force", k_Correlation, 1, "0.9 or more with the computed curve", flight.Source,
                Correlation(ours, measured), Correlation(fine, measured), cause);
            yield return Near("mean", name, mean, band, flight.Source, ours.Average(), fine.Average(), cause);
            yield return Near("peak", name, peak, band, flight.Source, ours.Max(), fine.Max(), cause);
            if (wake == 0)
            {
                foreach (ValidationRow row in Attacks(name, flight, run, finer))
                    yield return row;
            }

            if (wake == 1 && !addedMass)
            {
                yield return new ValidationRow(
                    $"{name}: power to the air, W/kg", (1 - k_WithInflow) * k_HoverPower, (1 + k_WithInflow) * k_HoverPower,
                    FormattableString.Invariant($"{k_HoverPower} ± {100 * k_WithInflow:0} %"), k_Hover,
                    run.Power.Average(), finer.Power.Average(),
                    "another way to beat: in the middle of the downstroke this insect holds its fore wing at "
                    + FormattableString.Invariant($"{Stroke(MeasuredDragonfly.TetheredAttack, k_MiddleDown):0}° against its way, as ")
                    + FormattableString.Invariant($"measured, that one at {k_HoverAttack}°, and drag costs the power"));
            }

            done();
        }
    }

    // Measured as in still air, so beside the wing without an induced flow.
    private static IEnumerable<ValidationRow> Attacks(string name, MeasuredDragonfly flight, DragonflyRun run, DragonflyRun finer)
    {
        IReadOnlyList<double> measured = MeasuredDragonfly.TetheredAttack;
        double[] ours = run.Even(run.Attack, k_Places), fine = finer.Even(finer.Attack, k_Places);
        yield return new ValidationRow(
            $"{name}: correlation of the fore wing's angle of attack", k_Correlation, 1, "0.9 or more with the measured curve",
            flight.Source, Correlation(ours, measured), Correlation(fine, measured), k_Angles);
        foreach ((string stroke, double middle) in new[] { ("downstroke", k_MiddleDown), ("upstroke", k_MiddleUp) })
        {
            double mean = Stroke(measured, middle);
            yield return new ValidationRow(
                $"{name}: mean angle of attack of the fore wing in the middle of the {stroke}, °", mean - k_Attack, mean + k_Attack,
                FormattableString.Invariant($"{mean:0}; ± {k_Attack} is our tolerance"), flight.Source,
                Stroke(ours, middle), Stroke(fine, middle), k_Angles);
        }
    }

    internal static double Stroke(IReadOnlyList<double> curve, double middle) => Enumerable.Range(0, curve.Count)
        .Where(n => Math.Abs((double)n / curve.Count - middle - Math.Round((double)n / curve.Count - middle)) < k_Middle + 1e-9)
        .Average(n => curve[n]);

    /// <summary>Curves over the beat of the tethered insect, at t/T = 0, 0.02, …</summary>
    public static List<ValidationCurve> Curves(int substeps)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        DragonflyRun still = DragonflyRun.Fly(flight, true, substeps), rigid = DragonflyRun.Fly(flight, true, substeps, 1),
            soft = DragonflyRun.Fly(flight, false, substeps, 1);
        RecordedWing wing = soft.Record.Wings[0];
        List<BeatFrame> beat = wing.Beat;
        List<BladeElements.Moment> blades = BladeElements.Curve(flight, BladeElements.Point.MidChord, rigid.Record.InducedVelocity);
        double[] Shape(Func<BeatFrame, double> of) => soft.Even(beat.ConvertAll(frame => of(frame)), k_Places);
        double[] Blades(Func<BladeElements.Moment, double> of) =>
            Enumerable.Range(0, k_Places).Select(n => of(blades[n * blades.Count / k_Places])).ToArray();
        return
        [
            new("vertical-force", "vertical force / weight", [("no induced flow", still.Even(still.Lift, k_Places)),
                ("rigid", rigid.Even(rigid.Lift, k_Places)), ("flexible", soft.Even(soft.Lift, k_Places))],
                MeasuredDragonfly.TetheredForce.ToArray(), $"computed by {flight.Source}, mean of five beats")
            {
                Units = ["weights", "weight", "1"],
                Range = (-100, 100),
            },
            new("angle-of-attack", "angle of attack at 0.75 span, °",
                [("no induced flow", still.Even(still.Attack, k_Places)), ("blade elements", Blades(moment => moment.Attack)),
                    ("rigid", rigid.Even(rigid.Attack, k_Places)), ("flexible", soft.Even(soft.Attack, k_Places))],
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
            new("power", "power, W/kg", [("blade elements", Blades(moment => moment.Power)), ("rigid", rigid.Even(rigid.Power, k_Places)),
                ("flexible", soft.Even(soft.Power, k_Places))],
                null, FormattableString.Invariant($"{k_NoneFound}; a mean of {k_HoverPower} W/kg by {k_Hover}"))
            {
                Units = ["W/kg"],
                Range = (-10000, 10000),
            },
        ];
    }

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

    internal static ValidationRow Near(
        string what, string name, double measured, double band, string source, double ours, double fine, string cause) => new(
        $"{name}: {what} of the vertical force over the weight", (1 - band) * measured, (1 + band) * measured,
        FormattableString.Invariant($"{measured:0.00} ± {100 * band:0} %"), source, ours, fine, cause);

    private static string Drawn(MeasuredDragonfly flight, DragonflyRun run)
    {
        float3 induced = run.Record.InducedVelocity;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{k_Even}; blade elements apart from the model in the same stream give "
            + $"{BladeElements.Lift(flight, BladeElements.Point.Axis, induced: induced):0.00} with the stream met on the pitching axis and "
            + $"{BladeElements.Lift(flight, BladeElements.Point.MidChord, induced: induced):0.00} in the middle of the chord; "
            + $"of the flights without an induced flow one is inside, two carry too much");
    }

    private static string Dragged(MeasuredDragonfly flight, float3 induced)
    {
        double ours = BladeElements.Thrust(flight, BladeElements.Point.MidChord, induced),
            own = BladeElements.Thrust(flight, BladeElements.Point.MidChord, induced, true);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"the drag at small angles of attack: the coefficients, measured on a model of a fruit fly's wing, have 0.37 at least, "
            + $"a dragonfly's wing 0.09 (the same source); blade elements apart from the model "
            + $"have a thrust of {ours:0.00} with the first and of {own:0.00} with the second").Replace('-', '−');
    }

    private static string Still(MeasuredDragonfly flight)
    {
        List<BladeElements.Moment> ours = BladeElements.Curve(flight, BladeElements.Point.MidChord),
            own = BladeElements.Curve(flight, BladeElements.Point.MidChord, ownDrag: true);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"the wing meets air at rest; in hover it meets what it has set moving. "
            + $"The drag has a part too: blade elements apart from the model have a mean of "
            + $"{ours.Average(moment => moment.Lift):0.00} and a peak of {ours.Max(moment => moment.Lift):0.00}, "
            + $"with the drag of a dragonfly's wing {own.Average(moment => moment.Lift):0.00} and {own.Max(moment => moment.Lift):0.00}");
    }

    private static string Inflow(DragonflyRun run, double wake) => wake == 0 ? ""
        : wake == 1 ? FormattableString.Invariant($", induced flow of {run.Induced:0.00} m/s")
        : FormattableString.Invariant($", induced flow of {run.Induced:0.00} m/s, wake factor {wake}");
}
