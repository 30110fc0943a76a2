namespace Alate.Cli;

/// <summary>
/// Variants of the published flights of dragonflies, which are shown and not counted: without a wake, flexible, other drag.
/// </summary>
internal static class DragonflyVariants
{
    /// <summary>Power of a hovering dragonfly, W/kg.</summary>
    public const double HoverPower = 37;

    /// <summary>Source of that power.</summary>
    public const string Hover = "Sun and Lan 2004, J. exp. Biol. 207:1887, computed for a hovering Aeshna juncea";

    private const double k_Wake = 1.2;

    /// <summary>
    /// Middles of the fore wing's strokes: its flap is highest at t/T = 0.19 and lowest at 0.69, and they reach a tenth of a beat to both
    /// sides.
    /// </summary>
    private const double k_MiddleDown = 0.44, k_MiddleUp = 0.94;

    private const string k_OwnDrag = "a dragonfly's coefficients", k_Input =
        "it follows from the motion that is prescribed: the row says how well the series has it, and nothing of the air";

    /// <summary>Weight support and thrust of the three flights without a wake.</summary>
    public static IEnumerable<ValidationRow> Flights(Fineness fineness, Action done)
    {
        for (int k = 0; k < MeasuredDragonfly.Flights.Count; k++)
        {
            (string record, MeasuredDragonfly flight) = DragonflyRows.Steady[k];
            ValidationRow[] rows = [.. DragonflyRows.Rows(record, flight)];
            foreach ((bool rigid, double wake, bool own) in new[] { (true, 0.0, false), (true, 1.0, false), (false, 0.0, false),
                (true, 0.0, true), (true, 1.0, true) })
            {
                DragonflyRun ours = DragonflyRun.Fly(flight, rigid, fineness.Substeps, wake, ownDrag: own),
                    fine = DragonflyRun.Fly(flight, rigid, fineness.Fine, wake, ownDrag: own);
                string variant = Name(rigid, wake, fine, false, own);
                yield return rows[0] with { Variant = variant, Ours = ours.Lift.Average(), Fine = fine.Lift.Average() };
                yield return rows[1] with { Variant = variant, Ours = ours.Thrust.Average(), Fine = fine.Thrust.Average() };
                done();
            }
        }
    }

    /// <summary>The tethered insect's vertical force, power and angles of attack without a wake.</summary>
    public static IEnumerable<ValidationRow> Tethered(Fineness fineness, Action done)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        foreach ((double wake, bool addedMass, bool own) in new[] { (0, false, false), (1, false, false), (k_Wake, false, false),
            (1, true, false), (1, false, true) })
        {
            DragonflyRun run = DragonflyRun.Fly(flight, true, fineness.Substeps, wake, addedMass, own),
                finer = DragonflyRun.Fly(flight, true, fineness.Fine, wake, addedMass, own);
            string variant = Name(true, wake, finer, addedMass, own);
            double[] ours = run.Even(run.Lift, DragonflyCurves.Places), fine = finer.Even(finer.Lift, DragonflyCurves.Places);
            foreach (ValidationRow row in DragonflyRows.TetheredRows())
            {
                yield return row with
                {
                    Variant = variant,
                    Ours = DragonflyRows.Of(row.Quantity, ours),
                    Fine = DragonflyRows.Of(row.Quantity, fine),
                };
            }

            if (wake == 0)
            {
                foreach (ValidationRow row in Attacks(flight, run, finer))
                    yield return row;
            }

            if (wake == 1 && own)
            {
                yield return new ValidationRow(
                    "hovering dragonfly", "power to the air, W/kg", double.NegativeInfinity, double.PositiveInfinity,
                    FormattableString.Invariant($"computed: {HoverPower}"), "", Hover, run.Power.Average(), finer.Power.Average())
                {
                    Reason = "one value of another species, without a spread; the tethered insect flies in the even downwash of momentum "
                        + "theory here",
                };
            }

            done();
        }
    }

    // Measured as in still air, so beside the wing without an induced flow.
    private static IEnumerable<ValidationRow> Attacks(MeasuredDragonfly flight, DragonflyRun run, DragonflyRun finer)
    {
        IReadOnlyList<double> measured = MeasuredDragonfly.TetheredAttack;
        double[] ours = run.Even(run.Attack, DragonflyCurves.Places), fine = finer.Even(finer.Attack, DragonflyCurves.Places);
        yield return new ValidationRow("tethered dragonfly in still air", "correlation of the fore wing's angle of attack",
            double.NegativeInfinity, double.PositiveInfinity, "measured: a curve", "", flight.Source,
            DragonflyCurves.Correlation(ours, measured), DragonflyCurves.Correlation(fine, measured))
        {
            Reason = k_Input,
        };
        foreach ((string stroke, double middle) in new[] { ("downstroke", k_MiddleDown), ("upstroke", k_MiddleUp) })
        {
            yield return new ValidationRow("tethered dragonfly in still air",
                $"mean angle of attack of the fore wing in the middle of the {stroke}, °", double.NegativeInfinity, double.PositiveInfinity,
                FormattableString.Invariant($"measured: {DragonflyCurves.Stroke(measured, middle):0}"), "", flight.Source,
                DragonflyCurves.Stroke(ours, middle), DragonflyCurves.Stroke(fine, middle))
            {
                Reason = k_Input,
            };
        }
    }

    private static string Name(bool rigid, double wake, DragonflyRun run, bool addedMass, bool own) => string.Join(", ",
        new[]
        {
            rigid ? "rigid wings" : "flexible wings",
            wake == 0 ? "no wake" : FormattableString.Invariant($"induced flow of {run.Induced:0.00} m/s")
                + (wake == 1 ? "" : FormattableString.Invariant($" (wake factor {wake})")),
            addedMass ? "added mass" : "", own ? k_OwnDrag : "a fruit fly's coefficients",
        }.Where(part => part.Length > 0));
}
