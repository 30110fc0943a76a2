using System;
using System.Collections.Generic;
using System.Globalization;
using System.Security;
using System.Text;
using Alate.Cli.Flights;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>strip.svg: twelve phases of a beat, all wings and the body, from one side.</summary>
internal sealed class BeatStrip
{
    /// <summary>How the margins of wings are drawn.</summary>
    public static readonly PaintedShape MarginLine = new(0x2A211C, true, false);

    private const int k_Columns = 4, k_Rows = 3;
    private const float k_DistanceOverSpan = 5f;
    private const float k_TestFineness = 1.5f;

    private const string k_Style =
        "<style>text{font-family:Helvetica,Arial,sans-serif;fill:#3d3a34}.t{fill:#8a8272}"
        + ".f{fill:currentColor;stroke:currentColor;stroke-width:2;stroke-linejoin:round}"
        + ".l{fill:none;stroke:currentColor;stroke-width:3.5;stroke-linejoin:round;stroke-linecap:round}</style>\n";

    private readonly FlightRecord m_Flight;
    private readonly List<PictureSurface> m_Surfaces = [];
    private readonly PictureCamera m_Camera;
    private readonly Shading m_Shading;
    private readonly StringBuilder m_Svg = new();

    private BeatStrip(FlightRecord flight)
    {
        m_Flight = flight;
        float reach = 0f;
        SurfaceMesh body = flight.Insect.Body;
        m_Surfaces.Add(new PictureSurface(
            0, Array.ConvertAll(body.positions, p => (float3)p), body.triangles, fine => WingPaint.Of(body.colours, fine), isThin: false));
        foreach (RecordedWing wing in flight.Wings)
        {
            m_Surfaces.Add(new PictureSurface(m_Surfaces.Count, wing.Rest, wing.Triangles, fine => WingPaint.Of(wing.Wing, fine), isThin: true));
            reach = math.max(reach, math.length(wing.Placement.Hinge) + wing.Placement.Length);
        }

        m_Camera = new PictureCamera(flight.Plan.View, k_DistanceOverSpan * reach);
        m_Shading = new Shading(m_Camera);
    }

    /// <summary>The whole picture.</summary>
    public static string Draw(FlightRecord flight) => new BeatStrip(flight).Draw();

    private string Draw()
    {
        var poses = new List<Pose>();
        for (int k = 0; k < k_Columns * k_Rows; k++)
            poses.Add(PoseAt(k / (double)(k_Columns * k_Rows)));
        var layout = new StripLayout(poses, k_Columns);
        Begin(layout);
        for (int k = 0; k < poses.Count; k++)
            DrawPanel(k, poses[k], layout);
        m_Svg.Append("</svg>\n");
        return m_Svg.ToString();
    }

    private Pose PoseAt(double turns)
    {
        SurfaceMesh body = m_Flight.Insect.Body;
        var pose = new Pose();
        pose.Places.Add(Array.ConvertAll(body.positions, p => m_Camera.Project(p)));
        pose.Normals.Add(Array.ConvertAll(body.normals, n => (float3)n));
        foreach (RecordedWing wing in m_Flight.Wings)
        {
            var positions = new float3[wing.Rest.Length];
            var normals = new float3[wing.Rest.Length];
            wing.At(turns, positions, normals);
            pose.Places.Add(Array.ConvertAll(positions, m_Camera.Project));
            pose.Normals.Add(normals);
        }

        return pose;
    }

    private void Begin(StripLayout layout)
    {
        float width = layout.Width, height = layout.Height;
        Line($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">");
        Line($"<title>{SecurityElement.Escape(Title())}</title>");
        m_Svg.Append(k_Style);
        Line($"<rect width=\"{width}\" height=\"{height}\" rx=\"14\" fill=\"#f7f4ec\"/>");
        Line($"<text x=\"26\" y=\"40\" font-size=\"24\" font-weight=\"bold\">{SecurityElement.Escape(m_Flight.Insect.DisplayName)}</text>");
        Line($"<text x=\"{width - 26}\" y=\"39\" font-size=\"17\" text-anchor=\"end\">{SecurityElement.Escape(Caption())}</text>");
    }

    private void DrawPanel(int index, Pose pose, StripLayout layout)
    {
        StripPanel panel = layout[index];
        var painter = new Painter(panel.Width, panel.Height, k_TestFineness);
        var picture = new List<float3>();
        for (int k = 0; k < m_Surfaces.Count; k++)
            m_Surfaces[k].Paint(painter, Array.ConvertAll(pose.Places[k], panel.Place), pose.Normals[k], picture, m_Shading);

        Line($"<g transform=\"translate({panel.Left} {panel.Top})scale({1f / SvgPath.Fineness})\">");
        foreach (PaintedSheet sheet in painter.Sheets())
            DrawSheet(sheet, picture);
        Line($"</g>");
        DrawLabel(index / (double)(k_Columns * k_Rows), panel.Left + 0.5f * panel.Width, panel.Top + panel.Height + 10f);
    }

    private void DrawLabel(double turns, float middle, float bottom)
    {
        const float k_Gap = 5f;
        double milliseconds = 1000.0 * turns / m_Flight.Wings[0].Frequency;
        Line($"<text x=\"{middle - k_Gap}\" y=\"{bottom}\" font-size=\"17\" text-anchor=\"end\">{360.0 * turns:0}°</text>");
        Line($"<text class=\"t\" x=\"{middle + k_Gap}\" y=\"{bottom}\" font-size=\"13\">{milliseconds:0.0} ms</text>");
    }

    private void DrawSheet(PaintedSheet sheet, List<float3> picture)
    {
        if (!sheet.Glass.IsSolid)
            Line($"<g opacity=\"{0.01 * (100 - sheet.Glass.Percent)}\">");
        foreach (PaintedLayer layer in sheet.Layers)
            DrawLayer(layer, picture);
        if (!sheet.Glass.IsSolid)
            Line($"</g>");
    }

    private void DrawLayer(PaintedLayer layer, List<float3> picture)
    {
        bool isLine = layer.Shape.IsLine;
        var path = new SvgPath();
        foreach (List<int> line in isLine ? OutlineTracer.Strokes(layer.Vertices) : OutlineTracer.Outlines(layer.Vertices))
            path.Add(line, picture, close: !isLine);
        if (path.IsEmpty)
            return;
        Line($"<path class=\"{(isLine ? 'l' : 'f')}\" color=\"#{layer.Shape.Colour:x6}\" d=\"{path}\"/>");
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
