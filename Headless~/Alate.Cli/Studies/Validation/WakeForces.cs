using Alate.Wake;

namespace Alate.Cli;

/// <summary>Forces on the wings of a published flight of a dragonfly in their own free wake, over the weight.</summary>
internal static class WakeForces
{
    /// <summary>Of the air, kg/m³.</summary>
    private const double k_Density = 1.225;

    private const int k_Steps = 24, k_Strips = 10;

    /// <summary>Sheds the wake of a published flight at its published areas.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="substeps">Of a beat of the wings that fly.</param>
    /// <param name="beats">Beats from rest.</param>
    /// <param name="fineness">Factor on the wake's steps and strips.</param>
    /// <param name="run">The flight without the wake.</param>
    /// <param name="rigid">Whether the wings are stiff.</param>
    /// <param name="ownDrag">Whether lift and drag are those of a dragonfly's wing.</param>
    /// <param name="downwash">Part of the wake that the coefficients hold.</param>
    public static WakeFlight Shed(MeasuredDragonfly flight, int substeps, int beats, int fineness, out DragonflyRun run, bool rigid = true,
        bool ownDrag = true, MeasuredDownwash downwash = MeasuredDownwash.Angle)
    {
        run = DragonflyRun.Fly(flight, rigid, substeps, ownDrag: ownDrag);
        IReadOnlyList<WingDefinition> kinds = InsectCatalogue.Find("dragonfly").Wings;
        return new WakeFlight(run.Record, new WakePlan
        {
            Chords = [.. kinds.Select((kind, k) => flight.Areas[k] / (kind.Outline.Area * flight.Lengths[k] * flight.Lengths[k]))],
            Density = k_Density,
            Beats = beats,
            StepsPerBeat = fineness * k_Steps,
            SpanPanels = fineness * k_Strips,
            Downwash = downwash,
        });
    }

    /// <summary>Mean force up and ahead.</summary>
    /// <inheritdoc cref="Shed"/>
    public static (double Lift, double Thrust) Of(MeasuredDragonfly flight, int substeps, int fineness, bool rigid = true,
        bool ownDrag = true, MeasuredDownwash downwash = MeasuredDownwash.Angle)
    {
        List<float3> beat = Beat(flight, substeps, fineness, rigid, ownDrag, downwash);
        return (beat.Average(force => force.y), beat.Average(force => force.z));
    }

    /// <summary>Force up at t/T = 0, 0.02, …</summary>
    /// <inheritdoc cref="Shed"/>
    public static double[] Curve(MeasuredDragonfly flight, int substeps, int fineness, bool rigid = true, bool ownDrag = true,
        MeasuredDownwash downwash = MeasuredDownwash.Angle)
    {
        List<float3> beat = Beat(flight, substeps, fineness, rigid, ownDrag, downwash);
        return [.. Enumerable.Range(0, DragonflyCurves.Places).Select(n =>
        {
            // Between the steps along straight lines.
            double place = (double)n * beat.Count / DragonflyCurves.Places;
            int k = (int)place;
            return math.lerp((double)beat[k].y, beat[(k + 1) % beat.Count].y, place - k);
        })];
    }

    // [step] In hover the first beats still meet the start.
    private static List<float3> Beat(
        MeasuredDragonfly flight, int substeps, int fineness, bool rigid, bool ownDrag, MeasuredDownwash downwash)
    {
        using WakeFlight wake = Shed(flight, substeps, flight.Speed > 0 ? 3 : 5, fineness, out _, rigid, ownDrag, downwash);
        return wake.Run(_ => { }).ConvertAll(at => at.Force / (float)flight.Weight);
    }
}
