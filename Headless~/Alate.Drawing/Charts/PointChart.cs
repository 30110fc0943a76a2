using System.Globalization;
using System.Text;

namespace Alate.Drawing;

/// <summary>A chart of curves whose points lie anywhere; what lies beyond its axes is cut off.</summary>
internal sealed class PointChart
{
    private const float k_Left = 44f, k_Top = 34f, k_Right = 14f, k_Bottom = 26f, k_Ring = 6.5f;
    private const string k_Grid = "#ded8c8", k_Axis = "#8a8272", k_Ground = "#f7f4ec";

    private readonly SvgPage m_Page;
    private readonly ChartAxis m_Across, m_Up;
    private readonly float m_X, m_Y, m_Width, m_Height;
    private readonly string m_Clip;

    /// <summary>Draws title, grid and labels.</summary>
    /// <param name="page">Where to.</param>
    /// <param name="title">Above the chart.</param>
    /// <param name="across">Horizontal axis.</param>
    /// <param name="up">Vertical axis.</param>
    /// <param name="x">Left end.</param>
    /// <param name="y">Upper end.</param>
    /// <param name="size">Of all, with labels.</param>
    public PointChart(SvgPage page, string title, ChartAxis across, ChartAxis up, float x, float y, float2 size)
    {
        m_Page = page;
        m_Across = across;
        m_Up = up;
        m_X = x + k_Left;
        m_Y = y + k_Top;
        m_Width = size.x - k_Left - k_Right;
        m_Height = size.y - k_Top - k_Bottom;
        m_Clip = string.Create(CultureInfo.InvariantCulture, $"c{x:0}-{y:0}");
        page.Text(x + 10f, y + 18f, 14f, title, look: "b");
        page.Append($"<clipPath id=\"{m_Clip}\">");
        page.Append($"<rect x=\"{m_X:0.#}\" y=\"{m_Y:0.#}\" width=\"{m_Width:0.#}\" height=\"{m_Height:0.#}\"/></clipPath>\n");
        DrawGrid();
    }

    /// <summary>Draws a curve.</summary>
    public void Draw(PointCurve curve)
    {
        if (curve.Look != CurveLook.Dots)
            DrawLine(curve);
        foreach (ChartPoint point in curve.Points)
        {
            if (Contains(point))
                Mark(m_Page, Place(point), curve.Colour, curve.Look);
        }
    }

    private void DrawLine(PointCurve curve)
    {
        var path = new StringBuilder();
        foreach (ChartPoint point in curve.Points)
        {
            float2 place = Place(point);
            path.Append(CultureInfo.InvariantCulture, $"{(path.Length == 0 ? 'M' : 'L')}{place.x:0.#} {place.y:0.#}");
        }

        m_Page.Append(
            $"<path clip-path=\"url(#{m_Clip})\" d=\"{path.ToString()}\" fill=\"none\" stroke=\"{curve.Colour}\" {Stroke(curve.Look)}/>\n");
    }

    /// <summary>Puts a ring around a point.</summary>
    public void Ring(ChartPoint point, string colour)
    {
        float2 place = Place(point);
        m_Page.Append(
            $"<circle cx=\"{place.x:0.#}\" cy=\"{place.y:0.#}\" r=\"{k_Ring}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>\n");
    }

    /// <summary>Puts a cross on a point.</summary>
    public void Cross(ChartPoint point, string colour) => Cross(m_Page, Place(point), colour);

    /// <summary>Writes above the right end of the chart.</summary>
    public void Remark(string text) => m_Page.Text(m_X + m_Width, m_Y - 16f, 11f, text, "end", "t");

    /// <summary>Attributes of the line of a look, also for a legend.</summary>
    public static string Stroke(CurveLook look) => look switch
    {
        CurveLook.Squares or CurveLook.Dashed => "stroke-width=\"2\" stroke-dasharray=\"5 4\"",
        CurveLook.Dotted => "stroke-width=\"1.5\" stroke-dasharray=\"1.5 3\"",
        CurveLook.Thin => "stroke-width=\"1\"",
        _ => "stroke-width=\"2\"",
    };

    /// <summary>Draws the mark of a point, also for a legend.</summary>
    public static void Mark(SvgPage page, float2 place, string colour, CurveLook look)
    {
        if (look == CurveLook.Discs)
        {
            page.Append($"<circle cx=\"{place.x:0.#}\" cy=\"{place.y:0.#}\" r=\"3\" fill=\"{colour}\"/>\n");
        }
        else if (look == CurveLook.Dots)
        {
            page.Append($"<circle cx=\"{place.x:0.#}\" cy=\"{place.y:0.#}\" r=\"1.6\" fill=\"{colour}\"/>\n");
        }
        else if (look == CurveLook.Squares)
        {
            page.Append($"<rect x=\"{place.x - 2.7f:0.#}\" y=\"{place.y - 2.7f:0.#}\" width=\"5.4\" height=\"5.4\"");
            page.Append($" fill=\"{k_Ground}\" stroke=\"{colour}\" stroke-width=\"1.3\"/>\n");
        }
    }

    /// <summary>Draws a cross, also for a legend.</summary>
    public static void Cross(SvgPage page, float2 place, string colour) => page.Append(
        $"<path d=\"M{place.x - 4f:0.#} {place.y - 4f:0.#}l8 8m0-8l-8 8\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>\n");

    private void DrawGrid()
    {
        foreach (double tick in m_Up.Ticks)
        {
            float y = Place(new ChartPoint(m_Across.From, tick)).y;
            m_Page.Line(m_X, y, m_X + m_Width, y, k_Grid);
            m_Page.Text(m_X - 6f, y + 4f, 11f, LineChart.Label(tick), "end", "t");
        }

        foreach (double tick in m_Across.Ticks)
        {
            float x = Place(new ChartPoint(tick, m_Up.From)).x;
            m_Page.Line(x, m_Y, x, m_Y + m_Height, k_Grid);
            m_Page.Text(x, m_Y + m_Height + 16f, 11f, LineChart.Label(tick), "middle", "t");
        }

        m_Page.Line(m_X, m_Y + m_Height, m_X + m_Width, m_Y + m_Height, k_Axis);
    }

    private float2 Place(ChartPoint point) =>
        new(m_X + m_Across.Fraction(point.X) * m_Width, m_Y + (1f - m_Up.Fraction(point.Y)) * m_Height);

    private bool Contains(ChartPoint point) =>
        m_Across.Fraction(point.X) is >= 0f and <= 1.0001f && m_Up.Fraction(point.Y) is >= 0f and <= 1.0001f;
}
