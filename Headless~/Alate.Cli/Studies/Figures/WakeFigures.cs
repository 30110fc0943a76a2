using Alate.Wake;

namespace Alate.Cli;

/// <summary>Chart and table of accuracy of the documentation's page on wakes.</summary>
internal static class WakeFigures
{
    /// <summary>The page, in the documentation's folder.</summary>
    public const string Page = "wake.md";

    private const string k_Picture = "images/wake-accuracy.svg";
    private const int k_Substeps = 96;

    /// <summary>All files, in the documentation's folder.</summary>
    public static IReadOnlyList<string> Files { get; } = [Page, k_Picture];

    /// <summary>A monarch that cruises by its own wings: its wake is measured, and drawn for the front page.</summary>
    internal static FlightPlan Flown => new()
    {
        Species = "monarch",
        Variant = InsectVariant.Flight,
        Speed = 1.3,
        PitchDegrees = 28,
        Substeps = k_Substeps,
    };

    /// <summary>Measures, draws, and writes the page's table again.</summary>
    /// <param name="page">The page as it is.</param>
    /// <returns>Each of <see cref="Files"/> with its text.</returns>
    public static IEnumerable<(string Name, string Text)> Make(string page) => Make(page, Measure());

    /// <summary>Wakes of a dragonfly's published flight by both methods, and of a monarch that cruises.</summary>
    internal static List<WakeAccuracy> Measure()
    {
        MeasuredDragonfly measured = MeasuredDragonfly.Flights[1];
        FlightRecord dragonfly = DragonflyRun.Fly(measured, true, k_Substeps, ownDrag: true).Record;
        FlightRecord monarch = TetheredFlight.Fly(Flown);
        return
        [
            WakeAccuracy.Of("dragonfly, published flight 2, strips", dragonfly, measured.Weight, WakeMethod.Strips),
            WakeAccuracy.Of("the same, panels", dragonfly, measured.Weight, WakeMethod.Panels),
            WakeAccuracy.Of("monarch at 1.3 m/s, strips", monarch,
                monarch.Wings[0].Wing.Preset.Size.insectMass * EarthGravity.Precise, WakeMethod.Strips),
        ];
    }

    internal static IEnumerable<(string Name, string Text)> Make(string page, IReadOnlyList<WakeAccuracy> wakes) =>
    [
        (Page, PageBlock.Replace(page, "accuracy of wakes", MarkdownTable.Write(WakeAccuracyPicture.Table(wakes)))),
        (k_Picture, WakeAccuracyPicture.Draw(wakes)),
    ];
}
