using System;
using System.Collections.Generic;
using System.Globalization;
using System.Security;
using System.Text;
using Alate.Cli.Flights;

namespace Alate.Cli.Pictures;

/// <summary>strip.svg: twelve phases of a beat, all wings and the body, from one side.</summary>
internal sealed class BeatStrip
{
    private const int k_Columns = 4, k_Rows = 3;

    private static readonly string s_Style =
        "<style>text{font-family:Helvetica,Arial,sans-serif;fill:#3d3a34}.t{fill:#8a8272}" + PictureDetail.Fine.Style + "</style>\n";

    private readonly FlightRecord m_Flight;
    private readonly InsectScene m_Scene;
    private readonly StringBuilder m_Svg = new();

    private BeatStrip(FlightRecord flight)
    {
        m_Flight = flight;
        m_Scene = new InsectScene(flight, PictureDetail.Fine);
    }

    /// <summary>The whole picture.</summary>
    public static string Draw(FlightRecord flight) => new BeatStrip(flight).Draw();

    private string Draw()
    {
        var poses = new List<Pose>();
        for (int k = 0; k < k_Columns * k_Rows; k++)
            poses.Add(m_Scene.PoseAt(k / (double)(k_Columns * k_Rows)));
        var layout = new StripLayout(poses, k_Columns);
        Begin(layout);
        for (int k = 0; k < poses.Count; k++)
            DrawPanel(k, poses[k], layout);
        m_Svg.Append("</svg>\n");
        return m_Svg.ToString();
    }

    private void Begin(StripLayout layout)
    {
        float width = layout.Width, height = layout.Height;
        Line($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">");
        Line($"<title>{SecurityElement.Escape(Title())}</title>");
        m_Svg.Append(s_Style);
        Line($"<rect width=\"{width}\" height=\"{height}\" rx=\"14\" fill=\"#f7f4ec\"/>");
        Line($"<text x=\"26\" y=\"40\" font-size=\"24\" font-weight=\"bold\">{SecurityElement.Escape(m_Flight.Insect.DisplayName)}</text>");
        Line($"<text x=\"{width - 26}\" y=\"39\" font-size=\"17\" text-anchor=\"end\">{SecurityElement.Escape(Caption())}</text>");
    }

    private void DrawPanel(int index, Pose pose, StripLayout layout)
    {
        StripPanel panel = layout[index];
        m_Svg.Append(m_Scene.Draw(pose, panel));
        DrawLabel(index / (double)(k_Columns * k_Rows), panel.Left + 0.5f * panel.Width, panel.Top + panel.Height + 10f);
    }

    private void DrawLabel(double turns, float middle, float bottom)
    {
        const float k_Gap = 5f;
        double milliseconds = 1000.0 * turns / m_Flight.Wings[0].Frequency;
        Line($"<text x=\"{middle - k_Gap}\" y=\"{bottom}\" font-size=\"17\" text-anchor=\"end\">{360.0 * turns:0}°</text>");
        Line($"<text class=\"t\" x=\"{middle + k_Gap}\" y=\"{bottom}\" font-size=\"13\">{milliseconds:0.0} ms</text>");
    }

    private string Title() => $"{m_Flight.Insect.DisplayName}: twelve phases of a beat, seen from {m_Flight.Plan.View.Words}";

    private string Caption()
    {
        double frequency = m_Flight.Wings[0].Frequency;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"one beat, {1000.0 / frequency:0.#} ms at {frequency:0.#} Hz, flying {m_Flight.Plan.BodySpeed:0.##} m/s");
    }

    private void Line(FormattableString text) => m_Svg.Append(text.ToString(CultureInfo.InvariantCulture)).Append('\n');
}
