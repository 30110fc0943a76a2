using Alate.Wake;

namespace Alate.Cli;

/// <summary>Comparisons with published flights of dragonflies by the best physics: stiff wings in the wake of all.</summary>
internal static class DragonflyRows
{
    /// <summary>Substeps of the rows, and those of their limit.</summary>
    public const int Substeps = 240, FineSubsteps = 480;

    /// <summary>Quantities of the rows.</summary>
    public const string Lift = "lift over weight", Thrust = "thrust over weight", Mean = "mean of the vertical force over the weight",
        Peak = "peak of the vertical force over the weight", Likeness = "correlation of the vertical force over the beat";

    private const string k_Digits = "what the last printed digits of the motion leave open (95 %)",
        k_Beats = "the least and the largest of its five beats", k_OneBeat = "its least correlation of a beat with the other four";

    /// <summary>Degrees by which the pitch is moved in an experiment.</summary>
    private const float k_Pitch = 5f;

    private static readonly Lazy<double> s_Drag = new(() =>
    {
        using Flight.FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("dragonfly"));
        return model.Drag.z;
    });

    /// <summary>Flights that count, by the names of their records.</summary>
    public static IReadOnlyList<(string Record, MeasuredDragonfly Flight)> Steady { get; } =
    [
        .. MeasuredDragonfly.Flights.Select((flight, k) => ($"dragonfly, flight {k + 1}", flight)),
        ("small dragonfly that climbs", MeasuredDragonfly.Climbing), ("dragonfly, flight 4", MeasuredDragonfly.Fourth),
    ];

    /// <summary>Weight support and thrust of the steady flights.</summary>
    public static IEnumerable<ValidationRow> Flights(Fineness fineness, Action done)
    {
        foreach ((string record, MeasuredDragonfly flight) in Steady)
        {
            (double Lift, double Thrust) ours = WakeForces.Of(flight, fineness.Substeps, 1),
                fine = WakeForces.Of(flight, fineness.Fine, 2);
            var experiments = new Lazy<List<(string Changed, double Lift, double Thrust)>>(() => [.. Changes(flight, fineness, fine)]);
            foreach (ValidationRow row in Rows(record, flight))
            {
                bool lifts = row.Quantity == Lift;
                ValidationRow told = row with
                {
                    Ours = lifts ? ours.Lift : ours.Thrust,
                    Fine = lifts ? fine.Lift : fine.Thrust,
                    Reason = flight == MeasuredDragonfly.Fourth ? "the mass and the wings of this animal are not at hand; the first one's "
                        + "stand for them" : null,
                };
                yield return told.IsInside || !told.IsCounted ? told : told with
                {
                    Experiments = experiments.Value.ConvertAll(one => new ValidationExperiment(one.Changed, lifts ? one.Lift : one.Thrust)),
                };
            }

            done();
        }
    }

    /// <summary>Rows of lift and thrust of a flight, without our values.</summary>
    public static IEnumerable<ValidationRow> Rows(string record, MeasuredDragonfly flight)
    {
        double scale = flight.BodyLength / MeasuredDragonfly.Flights[0].BodyLength, drag = s_Drag.Value * scale * scale
            * (flight.Speed * flight.Speed + flight.Climb * flight.Climb) / flight.Weight;
        double way = Math.Atan2(flight.Climb, flight.Speed), up = 1 + drag * Math.Sin(way), ahead = drag * Math.Cos(way);
        (double lift, double thrust) = LastDigits.Of(flight);
        yield return new ValidationRow(
            record, Lift, up - lift, up + lift, Text($"known: {up:0.00}, the weight and the body's drag"), k_Digits, flight.Source,
            double.NaN, double.NaN);
        yield return new ValidationRow(record, Thrust, ahead - thrust, ahead + thrust, Text($"known: {ahead:0.000}, the body's drag"),
            k_Digits, flight.Source, double.NaN, double.NaN);
    }

    /// <summary>The tethered insect's vertical force.</summary>
    public static IEnumerable<ValidationRow> Tethered(Fineness fineness, Action done)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        double[] ours = WakeForces.Curve(flight, fineness.Substeps, 1), fine = WakeForces.Curve(flight, fineness.Fine, 2);
        var experiments = new Lazy<List<(string Changed, double[] Lift)>>(() => [.. Changes(fineness)]);
        foreach (ValidationRow row in TetheredRows())
        {
            ValidationRow told = row with { Ours = Of(row.Quantity, ours), Fine = Of(row.Quantity, fine) };
            yield return told.IsInside ? told : told with
            {
                Experiments = experiments.Value.ConvertAll(one => new ValidationExperiment(one.Changed, Of(row.Quantity, one.Lift))),
            };
        }

        done();
    }

    /// <summary>Rows of the tethered insect, without our values.</summary>
    public static IEnumerable<ValidationRow> TetheredRows()
    {
        string source = MeasuredDragonfly.Tethered.Source;
        IReadOnlyList<double> force = MeasuredDragonfly.TetheredForce, means = MeasuredDragonfly.TetheredMeans,
            peaks = MeasuredDragonfly.TetheredPeaks;
        yield return new ValidationRow(
            "tethered dragonfly", Mean, means.Min(), means.Max(), Text($"computed: {force.Average():0.00}"), k_Beats, source,
            double.NaN, double.NaN);
        yield return new ValidationRow("tethered dragonfly", Peak, peaks.Min(), peaks.Max(), Text($"computed: {force.Max():0.00}"), k_Beats,
            source, double.NaN, double.NaN);
        yield return new ValidationRow(
            "tethered dragonfly", Likeness, MeasuredDragonfly.TetheredLikeness, 1, "computed: a curve of five beats", k_OneBeat, source,
            double.NaN, double.NaN);
    }

    /// <summary>A quantity of the tethered insect's force over the beat.</summary>
    public static double Of(string quantity, double[] lift) => quantity switch
    {
        Mean => lift.Average(),
        Peak => lift.Max(),
        _ => DragonflyCurves.Correlation(lift, MeasuredDragonfly.TetheredForce),
    };

    private static IEnumerable<(string Changed, double Lift, double Thrust)> Changes(
        MeasuredDragonfly flight, Fineness fineness, (double Lift, double Thrust) before)
    {
        (string, double, double) Told(string changed, (double Lift, double Thrust) force) => (changed, force.Lift, force.Thrust);
        var still = DragonflyRun.Fly(flight, true, fineness.Substeps, ownDrag: true);
        yield return ("no wake", still.Lift.Average(), still.Thrust.Average());
        var even = DragonflyRun.Fly(flight, true, fineness.Substeps, 1, ownDrag: true);
        yield return ("the even downwash of momentum theory in place of the wake", even.Lift.Average(), even.Thrust.Average());
        yield return Told("lift and drag of a fruit fly's wing", WakeForces.Of(flight, fineness.Substeps, 1, ownDrag: false));
        yield return Told("the coefficients' own downwash is not taken out",
            WakeForces.Of(flight, fineness.Substeps, 1, downwash: MeasuredDownwash.None));
        yield return Told("wings that bend besides", WakeForces.Of(flight, fineness.Substeps, 1, rigid: false));
        // Of blade elements apart from the model: their change, put on the value of the row.
        (double lift, double thrust) = Blades(flight);
        IReadOnlyList<PresetKinematics> wings = DragonflyRun.Kinematics(flight);
        foreach (float degrees in new[] { k_Pitch, -k_Pitch })
        {
            (double up, double ahead) = Blades(flight, wings: [.. wings.Select(wing => wing with
            {
                feather = new AngleSeries(wing.feather.mean - degrees, wing.feather.harmonics),
            })]);
            yield return (Text($"pitch of all wings {Math.Abs(degrees)}° {(degrees > 0 ? "higher" : "lower")}, by blade elements"),
                before.Lift + up - lift, before.Thrust + ahead - thrust);
        }

        (double onAxis, double onAxisAhead) = Blades(flight, BladeElements.Point.Axis);
        yield return ("air met on the pitching axis, by blade elements", before.Lift + onAxis - lift, before.Thrust + onAxisAhead - thrust);
        if (flight == MeasuredDragonfly.Flights[0])
        {
            (double up, double ahead) = Blades(flight, twisted: true);
            yield return ("the fore wing's published twist, by blade elements", before.Lift + up - lift, before.Thrust + ahead - thrust);
        }
    }

    private static IEnumerable<(string Changed, double[] Lift)> Changes(Fineness fineness)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        double[] Even(DragonflyRun run) => run.Even(run.Lift, DragonflyCurves.Places);
        yield return ("no wake", Even(DragonflyRun.Fly(flight, true, fineness.Substeps, ownDrag: true)));
        yield return ("the even downwash of momentum theory in place of the wake",
            Even(DragonflyRun.Fly(flight, true, fineness.Substeps, 1, ownDrag: true)));
        yield return ("lift and drag of a fruit fly's wing", WakeForces.Curve(flight, fineness.Substeps, 1, ownDrag: false));
        yield return ("the coefficients' own downwash is not taken out",
            WakeForces.Curve(flight, fineness.Substeps, 1, downwash: MeasuredDownwash.None));
        yield return ("wings that bend besides", WakeForces.Curve(flight, fineness.Substeps, 1, rigid: false));
        yield return ("added mass, in the even downwash", Even(DragonflyRun.Fly(flight, true, fineness.Substeps, 1, true, true)));
    }

    private static (double Lift, double Thrust) Blades(MeasuredDragonfly flight, BladeElements.Point point = BladeElements.Point.MidChord,
        bool twisted = false, IReadOnlyList<PresetKinematics> wings = null)
    {
        List<BladeElements.Moment> beat = BladeElements.Curve(flight, point, twisted: twisted, ownDrag: true, wings: wings);
        return (beat.Average(moment => moment.Lift), beat.Average(moment => moment.Thrust));
    }

    private static string Text(FormattableString text) =>
        text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
