namespace Alate.Cli;

/// <summary>
/// span.svg: circulation around each wing and the upward part of the air that vortices have set moving there, over the beat from left to
/// right and from the root at the bottom to the tip.
/// </summary>
internal static class SpanPicture
{
    private const float k_Width = 420f, k_Height = 130f, k_Edge = 58f, k_Between = 40f, k_Header = 74f, k_Row = k_Height + 66f,
        k_Foot = 16f;
    private const string k_Ink = "#3d3a34";

    /// <summary>The whole file.</summary>
    public static string Draw(WakeFlight wake, IReadOnlyList<WakeMoment> beat)
    {
        var page = new SvgPage();
        string title = $"{wake.Flight.Insect.DisplayName}: circulation and moving air over span and beat";
        page.Text(k_Edge, 34f, 20f, title, look: "b");
        page.Text(k_Edge, 56f, 13f, "red is above 0, blue below; a circulation above 0 lifts a wing that moves ahead", look: "t");
        for (int wing = 0; wing < wake.Wings.Count; wing++)
        {
            int at = wing;
            string name = wake.Wings[wing].SideAndName;
            float top = k_Header + wing * k_Row;
            Map(page, beat, at, k_Edge, top, $"{name}: circulation, cm²/s", strip => 1e4 * strip.Circulation);
            Map(page, beat, at, k_Edge + k_Width + k_Between, top, $"{name}: air upwards, m/s",
                strip => wake.Flight.Plan.ToWorld(strip.Inflow).y);
        }

        return page.Finish(2f * (k_Edge + k_Width) + k_Between - k_Edge + 26f, k_Header + wake.Wings.Count * k_Row + k_Foot, title);
    }

    private static void Map(
        SvgPage page, IReadOnlyList<WakeMoment> beat, int wing, float left, float top, string name, Func<WakeStrip, double> value)
    {
        double[][] values = [.. beat.Select(at => at.Wings[wing].Strips.Select(value).ToArray())];
        double least = values.Min(column => column.Min()), most = values.Max(column => column.Max()),
            largest = Math.Max(Math.Max(most, -least), 1e-12);
        page.Text(left, top + 14f, 13f, Text($"{name}, {least:0.##} to {most:0.##}"));
        top += 22f;
        float width = k_Width / values.Length, height = k_Height / values[0].Length;
        for (int column = 0; column < values.Length; column++)
        {
            for (int strip = 0; strip < values[column].Length; strip++)
            {
                Cell(page, left + column * width, top + k_Height - (strip + 1) * height, width, height,
                    (float)(values[column][strip] / largest));
            }
        }

        page.Append($"<rect x=\"{left}\" y=\"{top}\" width=\"{k_Width}\" height=\"{k_Height}\" ");
        page.Append($"fill=\"none\" stroke=\"{k_Ink}\"/>\n");
        page.Text(left - 8f, top + 10f, 12f, "tip", "end", "t");
        page.Text(left - 8f, top + k_Height, 12f, "root", "end", "t");
        for (int quarter = 0; quarter <= 4; quarter++)
            page.Text(left + quarter * k_Width / 4f, top + k_Height + 17f, 12f, Text($"{quarter / 4f:0.##}"), "middle", "t");
        page.Text(left + k_Width, top + k_Height + 33f, 12f, "beat", "end", "t");
    }

    private static void Cell(SvgPage page, float x, float y, float width, float height, float share)
    {
        int3 bytes = WakeColours.Bytes(share);
        page.Append($"<rect x=\"{x:0.##}\" y=\"{y:0.##}\" width=\"{width:0.##}\" height=\"{height:0.##}\" ");
        page.Append($"fill=\"#{bytes.x:x2}{bytes.y:x2}{bytes.z:x2}\" fill-opacity=\"{math.abs(share):0.###}\" ");
        page.Append($"shape-rendering=\"crispEdges\"/>\n");
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
