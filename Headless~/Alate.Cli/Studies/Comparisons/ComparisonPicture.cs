namespace Alate.Cli;

/// <summary>SPECIES.png: a column for each part of the model, a row for each phase, and the numbers below each column.</summary>
internal static class ComparisonPicture
{
    private const float k_Edge = 26f, k_Left = 62f, k_Header = 100f, k_Panel = 236f, k_Line = 19f, k_LetterWidth = 5.9f;

    /// <summary>Of the lines around the full model's wings.</summary>
    private static readonly float3 s_Outline = Shading.ToLinear(Shading.Colour(0x1666b0));

    private static readonly (string Title, Func<WingSummary, double> Of, MeasureBound Bound)[] s_Numbers =
    [
        ("twist", wing => wing.TwistPpDeg, MeasureBound.Find("twist_pp_deg")),
        ("camber", wing => wing.CamberMaxPct - wing.CamberMinPct, null),
        ("tip bend", wing => wing.TipBendPpDeg, null), ("lag", wing => wing.LagDeg, MeasureBound.Find("lag_deg")),
        ("stretch", wing => wing.EdgeStretchMaxPct, MeasureBound.Find("edge_stretch_max_pct")),
    ];

    /// <summary>The whole picture.</summary>
    public static byte[] Draw(Comparison comparison) => Compose(comparison).Write(isSmall: true);

    internal static PixelPage Compose(Comparison comparison)
    {
        var page = new PixelPage();
        FlightRecord full = comparison.Flights.Single(flight => flight.Column == ComparisonColumn.FullModel).Summary.Flight;
        var scenes = comparison.Flights.Select(flight => Scene(flight.Summary.Flight, full)).ToList();
        var grid = new PoseGrid(scenes, comparison.Phases, k_Left, k_Header, k_Panel);
        float width = grid.Right + k_Edge;
        page.Text(k_Edge, 38f, 22f, comparison.Name, look: "b");
        page.Text(width - k_Edge, 37f, 14f, Caption(comparison), "end");
        for (int k = 0; k < scenes.Count; k++)
            Heading(page, comparison.Flights[k].Column, k_Left + (k + 0.5f) * k_Panel);
        grid.Draw(page);
        grid.LabelRows(page, comparison.Phases, k_Left - 10f);
        float bottom = grid.Bottom + 12f;
        page.Line(k_Edge, bottom, width - k_Edge, bottom, 0xded8c8);
        float top = bottom;
        for (int k = 0; k < scenes.Count; k++)
            bottom = Numbers(page, comparison.Flights[k], k_Left + (k + 0.5f) * k_Panel, top + 24f);
        page.Text(
            k_Edge, bottom + 12f, 11f,
            "Peak to peak over the beat: twist and tip bend in degrees, camber in % of the chord; lag of the trailing edge in degrees; "
            + "largest stretch of an edge in %;",
            look: "t");
        page.Text(k_Edge, bottom + 27f, 11f, "off full: mean distance of the surface from the full model's at equal phase, % of the wing's "
            + "length. † outside what is expected here: " + Expected(comparison.Plan.Variant), look: "t");
        page.Text(
            k_Edge, bottom + 42f, 11f,
            "Blue lines: the full model's wings at the same phase. First row: the phase at which the first column is farthest off.",
            look: "t");
        return page.End(
            width, bottom + 57f, $"{comparison.Name}: {string.Join(", ", comparison.Flights.Select(flight => flight.Column.Title))}");
    }

    private static PhotoScene Scene(FlightRecord flight, FlightRecord full)
    {
        PhotoScene scene = FlightPhoto.Scene(flight);
        return flight == full ? scene : FlightPhoto.WithOutlines(scene, full, s_Outline);
    }

    private static string Expected(InsectVariant variant) =>
        string.Join(", ", s_Numbers.Where(number => number.Bound != null).Select(number => $"{number.Title} "
            + $"{number.Bound.RangeOf(variant).TrimEnd('*', ' ')}{(number.Bound.Unit == "%" ? " %" : number.Bound.Unit)}")) + ".";

    private static void Heading(PixelPage page, ComparisonColumn column, float middle)
    {
        page.Text(middle, 68f, 15f, column.Title, "middle", "b");
        (string first, string second) = Broken(column.Description);
        page.Text(middle, 85f, 11f, first, "middle", "t");
        page.Text(middle, 98f, 11f, second, "middle", "t");
    }

    // In two lines where one is too short.
    private static (string First, string Second) Broken(string text)
    {
        int most = (int)(k_Panel / k_LetterWidth);
        if (text.Length <= most)
            return (text, "");
        int space = text.LastIndexOf(' ', most);
        return (text[..space], text[(space + 1)..]);
    }

    private static float Numbers(PixelPage page, ComparedFlight flight, float middle, float top)
    {
        IReadOnlyList<WingSummary> wings = flight.Summary.Wings;
        float y = top;
        if (wings.Count > 1)
        {
            page.Text(middle + 38f, y, 12f, wings[0].Name, "end", "t");
            page.Text(middle + 104f, y, 12f, wings[1].Name, "end", "t");
            y += k_Line;
        }

        InsectVariant variant = flight.Summary.Flight.Plan.Variant;
        foreach ((string title, Func<WingSummary, double> of, MeasureBound bound) in s_Numbers)
        {
            y = Line(
                page, title, wings.Select(of).ToList(), middle, y, wings.Select(wing => bound?.Holds(wing, variant) == false).ToList());
        }
        y = Line(page, "off full", flight.Distances.Select(distance => distance.MeanPct).ToList(), middle, y);
        page.Text(middle - 84f, y, 13f, "lift / weight", look: "t");
        page.Text(middle + 38f, y, 13f, Text(flight.Summary.LiftOverWeight, 2), "end");
        return y + k_Line;
    }

    private static float Line(PixelPage page, string title, List<double> values, float middle, float y, List<bool> areOutside = null)
    {
        page.Text(middle - 84f, y, 13f, title, look: "t");
        for (int k = 0; k < values.Count; k++)
        {
            page.Text(middle + 38f + 66f * k, y, 13f, Text(values[k], 1), "end");
            if (areOutside?[k] == true)
                page.Text(middle + 42f + 66f * k, y, 13f, "†", look: "t");
        }

        return y + k_Line;
    }

    // Rounded first, so that there is no minus nought.
    private static string Text(double value, int digits) =>
        (Math.Round(value, digits) + 0.0).ToString("F" + digits, CultureInfo.InvariantCulture).Replace('-', '−');

    private static string Caption(Comparison comparison)
    {
        FlightRecord flight = comparison.Flights[0].Summary.Flight;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{flight.Wings[0].Frequency:0.#} Hz, at {flight.Plan.BodySpeed:0.##} m/s, seen from {flight.Plan.View.Words}");
    }
}
