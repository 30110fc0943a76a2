namespace Alate.Cli;

/// <summary>sweep.png, the insect at some phases for each value, and sweep.svg, charts of what was measured over all values.</summary>
internal sealed class SweepPicture
{
    private const float k_Edge = 26f, k_Left = 56f, k_Header = 98f, k_MostWidth = 210f, k_GridWidth = 1000f, k_ChartHeight = 170f,
        k_Section = 10f, k_Narrowest = 760f;
    private const int k_MostColumns = 8, k_Charts = 3;

    private static readonly double[] s_Phases = [0.0, 0.25, 0.5, 0.75];
    private static readonly string[] s_Colours = ["#0b5fa5", "#c2410c"];

    private readonly Sweep m_Sweep;
    private readonly PixelPage m_Poses = new();
    private readonly SvgPage m_Charts = new();

    private SweepPicture(Sweep sweep)
    {
        m_Sweep = sweep;
    }

    /// <summary>The insect, as a PNG file.</summary>
    public static byte[] DrawPoses(Sweep sweep) => Compose(sweep).Write(isSmall: true);

    internal static PixelPage Compose(Sweep sweep) => new SweepPicture(sweep).ComposePoses();

    /// <summary>The charts, as SVG.</summary>
    public static string DrawCharts(Sweep sweep) => new SweepPicture(sweep).DrawCharts();

    private PixelPage ComposePoses()
    {
        List<int> columns = Columns(m_Sweep.Plan.Values.Count);
        float panel = Math.Min(k_MostWidth, (k_GridWidth - k_Left) / columns.Count), bottom = k_Header;
        foreach (bool wave in new[] { true, false })
        {
            List<SweepPoint> points = m_Sweep.With(wave);
            if (points.Count > 0)
                bottom = DrawPoses(columns.ConvertAll(k => points[k]), wave, bottom, panel);
        }

        float width = Math.Max(k_Left + columns.Count * panel + k_Edge, k_Narrowest);
        Heading(columns, panel, width);
        return m_Poses.End(width, MathF.Ceiling(bottom + 6f), $"{Name}: {m_Sweep.Plan.Parameter.Title}");
    }

    private string DrawCharts()
    {
        m_Charts.Text(k_Edge, 38f, 22f, Name, look: "b");
        float bottom = DrawCharts(62f, k_GridWidth);
        return m_Charts.Finish(k_GridWidth, MathF.Ceiling(bottom + 14f), $"{Name}: {m_Sweep.Plan.Parameter.Title}");
    }

    private string Name => m_Sweep.Points[0].Summary.Flight.Insect.DisplayName;

    private void Heading(List<int> columns, float panel, float width)
    {
        m_Poses.Text(k_Edge, 38f, 22f, Name, look: "b");
        m_Poses.Text(width - k_Edge, 37f, 15f, m_Sweep.Plan.Parameter.Title, "end");
        for (int k = 0; k < columns.Count; k++)
            m_Poses.Text(k_Left + (k + 0.5f) * panel, 72f, 15f, LineChart.Label(m_Sweep.Plan.Values[columns[k]]), "middle", "b");
    }

    private float DrawPoses(List<SweepPoint> points, bool wave, float top, float panel)
    {
        if (m_Sweep.Plan.Waves != SweepWaves.On)
        {
            m_Poses.Text(k_Edge, top + 4f, 14f, wave ? "with the deformation wave" : "without the deformation wave", look: "t");
            top += 12f;
        }

        List<PhotoScene> scenes = points.ConvertAll(point => FlightPhoto.Scene(point.Summary.Flight));
        var grid = new PoseGrid(scenes, s_Phases, k_Left, top, panel);
        grid.Draw(m_Poses);
        grid.LabelRows(m_Poses, s_Phases, k_Left - 8f);
        return grid.Bottom + k_Section;
    }

    private float DrawCharts(float top, float width)
    {
        float chart = (width - k_Edge) / k_Charts;
        top = DrawLegend(top) + 8f;
        int drawn = 0;
        Chart("twist, peak to peak, °", (point, kind) => point.Summary.Wings[kind].TwistPpDeg);
        Chart("camber by the loads, % of the chord", (point, kind) => point.LoadCamberPct[kind]);
        Chart("lag of the tip, °", (point, kind) => point.Summary.Wings[kind].TipLagDeg);
        Chart("tip bend, peak to peak, °", (point, kind) => point.Summary.Wings[kind].TipBendPpDeg);
        Chart("edge stretch, largest, %", (point, kind) => point.Summary.Wings[kind].EdgeStretchMaxPct);
        Chart("lift over weight, all wings", (point, kind) => kind == 0 ? point.Summary.LiftOverWeight : double.NaN);
        return top + (drawn + k_Charts - 1) / k_Charts * k_ChartHeight;

        void Chart(string title, Func<SweepPoint, int, double> value)
        {
            float x = 12f + drawn % k_Charts * chart, y = top + drawn / k_Charts * k_ChartHeight;
            new LineChart(m_Sweep.Plan.Values, m_Sweep.Plan.IsLogarithmic, x, y, chart, k_ChartHeight).Draw(m_Charts, title, Curves(value));
            drawn++;
        }
    }

    private List<ChartCurve> Curves(Func<SweepPoint, int, double> value)
    {
        var curves = new List<ChartCurve>();
        foreach (bool wave in new[] { true, false })
        {
            List<SweepPoint> points = m_Sweep.With(wave);
            for (int kind = 0; points.Count > 0 && kind < Kinds.Count; kind++)
            {
                List<double> values = points.ConvertAll(point => value(point, kind));
                if (values.Exists(double.IsFinite))
                    curves.Add(new ChartCurve(values, s_Colours[kind % s_Colours.Length], !wave));
            }
        }

        return curves;
    }

    private IReadOnlyList<WingSummary> Kinds => m_Sweep.Points[0].Summary.Wings;

    private float DrawLegend(float top)
    {
        float x = k_Edge;
        for (int kind = 0; kind < Kinds.Count; kind++)
            x = Entry(x, top, Kinds[kind].Name, s_Colours[kind % s_Colours.Length], "");
        if (m_Sweep.Plan.Waves == SweepWaves.Both)
            x = Entry(Entry(x, top, "with the wave", "#3d3a34", ""), top, "without", "#3d3a34", " stroke-dasharray=\"5 4\"");
        m_Charts.Text(x, top + 4f, 13f, $"over {m_Sweep.Plan.Parameter.Title}", look: "t");
        return top + 12f;
    }

    private float Entry(float x, float y, string text, string colour, string dash)
    {
        m_Charts.Append($"<path d=\"M{x:0.#} {y:0.#}h26\" stroke=\"{colour}\" stroke-width=\"2\" fill=\"none\"{dash}/>\n");
        m_Charts.Text(x + 32f, y + 4f, 13f, text);
        return x + 54f + 7.2f * text.Length;
    }

    // All of a few values; of many, some evenly chosen ones with both ends.
    private static List<int> Columns(int count) => count <= k_MostColumns
        ? Enumerable.Range(0, count).ToList()
        : Enumerable.Range(0, k_MostColumns).Select(k => (int)Math.Round(k * (count - 1) / (k_MostColumns - 1.0))).ToList();
}
