namespace Alate.Cli;

/// <summary>Height over the distance flown, or over time where an insect stays about where it is, in the colours of the map.</summary>
internal static class PathProfile
{
    private const int k_Grid = 0xdcd6c6, k_Ink = 0x3d3a34;

    /// <summary>Reaches of an insect that it must fly for distances to be shown.</summary>
    private const float k_Far = 10f;

    private const double k_Centimetres = 0.1;

    /// <summary>Least length of the axis, of a flight of one step, which begins where it ends.</summary>
    private const double k_Shortest = 1e-3;

    /// <summary>Least distance of marks, units of the page: their words need it.</summary>
    private const float k_Apart = 32f;

    /// <summary>Moments on both sides of a mark that tell whether the way climbs there.</summary>
    private const int k_Around = 15;

    /// <param name="page">Where to.</param>
    /// <param name="way">What was flown.</param>
    /// <param name="corner">Upper left one of the plot, units of the page.</param>
    /// <param name="size">Of the plot, units of the page.</param>
    /// <param name="reach">Farthest that a wing comes from the middle of the thorax, metres.</param>
    public static void Draw(PixelPage page, FlownWay way, float2 corner, float2 size, float reach)
    {
        bool isFar = way.Distances[^1] > k_Far * reach;
        (string unit, double factor) = way.Highest - way.Lowest < k_Centimetres ? ("cm", 100.0) : ("m", 1.0);
        double Across(int moment) => isFar ? way.Distances[moment] : way.Times[moment];
        ChartAxis across = new(0.0, Math.Max(Across(way.Places.Length - 1), k_Shortest), false, []),
            up = ChartAxis.Around([factor * way.Lowest, factor * way.Highest]);
        page.Text(corner.x - 50f, corner.y - 14f, 13f,
            $"Height, {unit}, over {(isFar ? "the distance flown, m" : "time, s")}; colours as above", look: "t");
        foreach (double tick in up.Ticks)
        {
            float y = corner.y + size.y * (1f - up.Fraction(tick));
            page.Line(corner.x, y, corner.x + size.x, y, k_Grid);
            page.Text(corner.x - 8f, y + 4f, 12f, Written(tick), "end", "t");
        }

        foreach (double tick in ChartAxis.Around([0.0, across.To]).Ticks.Where(tick => tick <= across.To))
        {
            float x = corner.x + size.x * across.Fraction(tick);
            page.Line(x, corner.y, x, corner.y + size.y, k_Grid);
            page.Text(x, corner.y + size.y + 18f, 12f, Written(tick), "middle", "t");
        }

        way.Draw(page, OnPage, 1.8f);
        if (!isFar)
            return;
        float last = float.NegativeInfinity;
        foreach ((int moment, double time) in way.Marks.Where(mark => OnPage(mark.Moment).x < corner.x + size.x - k_Apart))
        {
            if (OnPage(moment).x < last + k_Apart)
                continue;
            last = OnPage(moment).x;

            // Above the way: to its left where it climbs, to its right where it sinks.
            float2 place = OnPage(moment);
            float slope = OnPage(Math.Min(moment + k_Around, way.Means.Length - 1)).y - OnPage(Math.Max(moment - k_Around, 0)).y;
            page.Line(place.x, place.y - 5f, place.x, place.y + 5f, k_Ink, 1.4f);
            page.Text(place.x - 5f * Math.Sign(-slope), place.y - 8f, 11f, string.Create(CultureInfo.InvariantCulture, $"{time:0.##} s"),
                slope < 0f ? "end" : "start");
        }

        float2 OnPage(int moment) => corner + size * new float2(
            across.Fraction(Across(moment)), 1f - up.Fraction(factor * way.Drawn(moment).y));
    }

    private static string Written(double value) => (Math.Abs(value) < 1e-9 ? 0.0 : value).ToString("0.###", CultureInfo.InvariantCulture);
}
