using System.Globalization;
using System.Text;

namespace Alate.Drawing;

/// <summary>A small chart of curves over one parameter.</summary>
internal sealed class LineChart
{
    private const float k_Left = 44f, k_Top = 26f, k_Right = 12f, k_Bottom = 24f;
    private const string k_Grid = "#ded8c8", k_Axis = "#8a8272";
    private const int k_MostLabels = 6;

    private readonly IReadOnlyList<double> m_Places;
    private readonly bool m_IsLogarithmic;
    private readonly float m_X, m_Y, m_Width, m_Height;

    /// <param name="places">Values of the parameter, in order.</param>
    /// <param name="isLogarithmic">Equal ratios are equally far apart.</param>
    /// <param name="x">Left end.</param>
    /// <param name="y">Upper end.</param>
    /// <param name="width">Of all, with labels.</param>
    /// <param name="height">Of all, with labels.</param>
    public LineChart(IReadOnlyList<double> places, bool isLogarithmic, float x, float y, float width, float height)
    {
        m_Places = places;
        m_IsLogarithmic = isLogarithmic;
        m_X = x + k_Left;
        m_Y = y + k_Top;
        m_Width = width - k_Left - k_Right;
        m_Height = height - k_Top - k_Bottom;
    }

    /// <summary>Draws the chart.</summary>
    public void Draw(SvgPage page, string title, IReadOnlyList<ChartCurve> curves)
    {
        IReadOnlyList<double> ticks = ChartAxis.Linear(curves.SelectMany(curve => curve.Values)).Ticks;
        double low = ticks[0], high = ticks[^1];
        page.Text(m_X - k_Left + 8f, m_Y - 10f, 13f, title, look: "b");
        foreach (double tick in ticks)
        {
            float y = Down(tick, low, high);
            page.Line(m_X, y, m_X + m_Width, y, k_Grid);
            page.Text(m_X - 6f, y + 4f, 11f, Label(tick), "end", "t");
        }

        int step = (m_Places.Count + k_MostLabels - 1) / k_MostLabels;
        for (int k = 0; k < m_Places.Count; k += step)
        {
            float x = Along(m_Places[k]);
            page.Line(x, m_Y + m_Height, x, m_Y + m_Height + 4f, k_Axis);
            page.Text(x, m_Y + m_Height + 17f, 11f, Label(m_Places[k]), "middle", "t");
        }

        page.Line(m_X, m_Y + m_Height, m_X + m_Width, m_Y + m_Height, k_Axis);
        foreach (ChartCurve curve in curves)
            DrawCurve(page, curve, low, high);
    }

    /// <summary>A number in a few digits.</summary>
    public static string Label(double value) => value.ToString("0.###", CultureInfo.InvariantCulture).Replace('-', '−');

    private void DrawCurve(SvgPage page, ChartCurve curve, double low, double high)
    {
        var path = new StringBuilder();
        for (int k = 0; k < m_Places.Count; k++)
        {
            if (!double.IsFinite(curve.Values[k]))
                continue;
            float x = Along(m_Places[k]), y = Down(curve.Values[k], low, high);
            path.Append(CultureInfo.InvariantCulture, $"{(path.Length == 0 ? 'M' : 'L')}{x:0.#} {y:0.#}");
            page.Append($"<circle cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"{(curve.IsDashed ? 1.8 : 2.6)}\" fill=\"{curve.Colour}\"/>\n");
        }

        string dash = curve.IsDashed ? " stroke-dasharray=\"5 4\"" : "";
        page.Add($"<path d=\"{path}\" fill=\"none\" stroke=\"{curve.Colour}\" stroke-width=\"2\"{dash}/>\n");
    }

    private float Along(double place)
    {
        double from = Scaled(m_Places[0]), to = Scaled(m_Places[^1]);
        return m_X + (float)((Scaled(place) - from) / (to - from)) * m_Width;
    }

    private float Down(double value, double low, double high) => m_Y + m_Height * (float)((high - value) / (high - low));

    private double Scaled(double place) => m_IsLogarithmic ? Math.Log(place) : place;
}
