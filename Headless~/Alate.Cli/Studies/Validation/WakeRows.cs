namespace Alate.Cli;

/// <summary>Comparisons of wings in their own free wake with published flights of dragonflies.</summary>
internal static class WakeRows
{
    /// <summary>Of the air, kg/m³.</summary>
    private const double k_Density = 1.225;

    private const double k_Bearing = 0.12, k_Band = 0.40, k_Correlation = 0.9;
    private const int k_Places = 50, k_Steps = 24, k_Strips = 10;

    private const string k_Name = "dragonfly in its own wake", k_Wings = "rigid wings, drag of a dragonfly's wing";
    private const string k_Drag = "it hangs on its drag, at 74° against its way, whose momentum a lifting line does not shed",
        k_Tip = "strips of a finite number end short of the tip, and the pitch angles are read from plots";

    /// <summary>Weight support of the three flights, and the tethered insect's vertical force.</summary>
    public static IEnumerable<ValidationRow> Dragonflies(Fineness fineness, Action done)
    {
        for (int k = 0; k < MeasuredDragonfly.Flights.Count; k++)
        {
            MeasuredDragonfly flight = MeasuredDragonfly.Flights[k];
            double ours = Even(Shed(flight, fineness, 1)).Average(), fine = Even(Shed(flight, fineness, 2)).Average();
            yield return new ValidationRow(
                $"{k_Name}, flight {k + 1}, {k_Wings}: lift over weight", 1 - k_Bearing, 1 + k_Bearing, "1 ± 0.12: steady flight",
                flight.Source, ours, fine, k_Tip);
            done();
        }

        MeasuredDragonfly tethered = MeasuredDragonfly.Tethered;
        IReadOnlyList<double> measured = MeasuredDragonfly.TetheredForce;
        double[] lift = Even(Shed(tethered, fineness, 1)), finer = Even(Shed(tethered, fineness, 2));
        string name = $"tethered {k_Name}, {k_Wings}";
        yield return new ValidationRow(
            $"{name}: correlation of the vertical force", k_Correlation, 1, "0.9 or more with the computed curve", tethered.Source,
            DragonflyRows.Correlation(lift, measured), DragonflyRows.Correlation(finer, measured), k_Drag);
        yield return DragonflyRows.Near(
            "mean", name, measured.Average(), k_Band, tethered.Source, lift.Average(), finer.Average(), k_Drag);
        yield return DragonflyRows.Near("peak", name, measured.Max(), k_Band, tethered.Source, lift.Max(), finer.Max(), k_Drag);
        done();
    }

    /// <summary>Sheds the wake of a published flight at its published areas.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="substeps">Of a beat of the wings that fly.</param>
    /// <param name="beats">Beats from rest.</param>
    /// <param name="fineness">Factor on the wake's steps and strips.</param>
    /// <param name="run">The flight without the wake.</param>
    public static WakeFlight Of(MeasuredDragonfly flight, int substeps, int beats, int fineness, out DragonflyRun run)
    {
        run = DragonflyRun.Fly(flight, true, substeps, ownDrag: true);
        IReadOnlyList<WingDefinition> kinds = InsectCatalogue.Find("dragonfly").Wings;
        return new WakeFlight(run.Record, new WakePlan
        {
            Chords = [.. kinds.Select((kind, k) => flight.Areas[k] / (kind.Outline.Area * flight.Lengths[k] * flight.Lengths[k]))],
            Density = k_Density,
            Beats = beats,
            StepsPerBeat = fineness * k_Steps,
            SpanPanels = fineness * k_Strips,
        });
    }

    // [step] Lift over the weight. In hover the first beats still meet the start.
    private static List<double> Shed(MeasuredDragonfly flight, Fineness fineness, int factor)
    {
        int substeps = factor == 1 ? fineness.Substeps : fineness.Fine;
        using WakeFlight wake = Of(flight, substeps, flight.Speed > 0 ? 3 : 5, factor, out _);
        return wake.Run(_ => { }).ConvertAll(at => at.Force.y / flight.Weight);
    }

    // Between the steps along straight lines.
    private static double[] Even(List<double> beat) => [.. Enumerable.Range(0, k_Places).Select(n =>
    {
        double place = (double)n * beat.Count / k_Places;
        int k = (int)place;
        return math.lerp(beat[k], beat[(k + 1) % beat.Count], place - k);
    })];
}
