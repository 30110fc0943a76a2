namespace Alate.Drawing;

/// <summary>A picture of small charts of one size in rows of three, below a heading and a legend of two lines.</summary>
internal sealed class ChartSheet
{
    /// <summary>Left edge of the text.</summary>
    public const float Edge = 26f;

    /// <summary>Colour of marks in a legend that stand for all wings.</summary>
    public const string Ink = "#3d3a34";

    private const int k_Columns = 3;
    private const float k_Width = 1000f, k_ChartHeight = 280f, k_Charts = 136f;

    /// <summary>Begins a sheet.</summary>
    /// <param name="title">Its heading.</param>
    /// <param name="caption">One line below the heading: what the axes are.</param>
    public ChartSheet(string title, string caption)
    {
        Page.Text(Edge, 38f, 22f, title, look: "b");
        Page.Text(Edge, 60f, 13f, caption, look: "t");
    }

    /// <summary>Colours of kinds of wings.</summary>
    public static IReadOnlyList<string> Colours { get; } = ["#0b5fa5", "#c2410c"];

    public SvgPage Page { get; } = new();

    /// <summary>Middle of the legend's first line.</summary>
    public float LegendTop => 86f;

    /// <summary>Begins the chart of an index, row by row.</summary>
    public PointChart Chart(int index, string title, ChartAxis across, ChartAxis up)
    {
        var size = new float2((k_Width - Edge) / k_Columns, k_ChartHeight);
        return new PointChart(Page, title, across, up, 12f + index % k_Columns * size.x, k_Charts + index / k_Columns * size.y, size);
    }

    /// <summary>The whole file.</summary>
    /// <param name="count">Charts.</param>
    /// <param name="title">What the picture shows, for those who do not see it.</param>
    public string Finish(int count, string title) =>
        Page.Finish(k_Width, k_Charts + MathF.Ceiling(count / (float)k_Columns) * k_ChartHeight + 12f, title);
}
