namespace Alate.Cli;

/// <summary>
/// plane.svg: the air behind an insect, seen by who flies behind it: lines along its velocity over colours of its vorticity.
/// </summary>
internal static class WakePlanePicture
{
    private const float k_Cell = 10f, k_Edge = 26f, k_Header = 70f, k_Foot = 40f, k_LongestArrow = 30f;

    /// <summary>Places between two arrows.</summary>
    private const int k_Between = 4;

    /// <summary>The whole file.</summary>
    public static string Draw(WakePlane plane, string name)
    {
        var page = new SvgPage();
        float width = plane.Columns * k_Cell + 2f * k_Edge, height = plane.Rows * k_Cell + k_Header + k_Foot;
        (int Column, int Row)[] all =
            [.. Enumerable.Range(0, plane.Columns * plane.Rows).Select(k => (k % plane.Columns, k / plane.Columns))];
        double strongest = Math.Max(all.Max(at => Math.Abs(plane.Vorticity(at.Column, at.Row))), 1e-9);
        float fastest = math.max(all.Max(at => math.length(plane.Velocity(at.Column, at.Row).xy)), 1e-9f);
        float3 first = plane.Place(0, 0);
        string title = Text($"{name}: the air {-1000f * first.z:0.#} mm behind, mean of a beat");
        page.Text(k_Edge, 34f, 20f, title, look: "b");
        page.Text(
            k_Edge, 56f, 13f, Text($"seen from behind; lines up to {fastest:0.00} m/s, vorticity up to {strongest:0} 1/s"), look: "t");
        foreach ((int column, int row) in all)
            Cell(page, column, row, (float)(plane.Vorticity(column, row) / strongest));
        foreach ((int column, int row) in all.Where(at => at.Column % k_Between == 0 && at.Row % k_Between == 0))
            Arrow(page, column, row, k_LongestArrow / fastest * plane.Velocity(column, row).xy);
        page.Text(
            k_Edge, height - 14f, 13f, Text($"{2000f * math.abs(first.x):0.#} mm wide; red turns clockwise, blue the other way"),
            look: "t");
        return page.Finish(width, height, title);
    }

    private static void Cell(SvgPage page, int column, int row, float share)
    {
        float opacity = math.abs(share);
        if (opacity < 0.01f)
            return;
        int3 bytes = WakeColours.Bytes(share);
        page.Append($"<rect x=\"{k_Edge + k_Cell * column:0.#}\" y=\"{k_Header + k_Cell * row:0.#}\" ");
        page.Append($"width=\"{k_Cell}\" height=\"{k_Cell}\" ");
        page.Append($"fill=\"#{bytes.x:x2}{bytes.y:x2}{bytes.z:x2}\" fill-opacity=\"{opacity:0.##}\"/>\n");
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    // A line with a dot at its beginning.
    private static void Arrow(SvgPage page, int column, int row, float2 way)
    {
        float x = k_Edge + k_Cell * (column + 0.5f), y = k_Header + k_Cell * (row + 0.5f);
        page.Line(x, y, x + way.x, y - way.y, "#3d3a34");
        page.Append($"<circle cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"1.6\" fill=\"#3d3a34\"/>\n");
    }
}
