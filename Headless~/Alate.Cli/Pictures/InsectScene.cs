using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Alate.Cli.Flights;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>An insect that was flown, ready to be painted at any phase of its last beat: its surfaces, the camera and the light.</summary>
internal sealed class InsectScene
{
    /// <summary>Look of the margins of wings.</summary>
    public static readonly PaintedShape MarginLine = new(0x2A211C, true, false);

    private const float k_DistanceOverSpan = 5f;

    private readonly FlightRecord m_Flight;
    private readonly PictureDetail m_Detail;
    private readonly List<PictureSurface> m_Surfaces = [];
    private readonly PictureCamera m_Camera;
    private readonly Shading m_Shading;

    public InsectScene(FlightRecord flight, PictureDetail detail)
    {
        m_Flight = flight;
        m_Detail = detail;
        float reach = 0f;
        SurfaceMesh body = flight.Insect.Body;
        m_Surfaces.Add(new PictureSurface(
            0, Array.ConvertAll(body.positions, p => (float3)p), body.triangles, fine => WingPaint.Of(body.colours, fine, detail), detail, isThin: false));
        foreach (RecordedWing wing in flight.Wings)
        {
            m_Surfaces.Add(new PictureSurface(
                m_Surfaces.Count, wing.Rest, wing.Triangles, fine => WingPaint.Of(wing.Wing, fine, detail), detail, isThin: true));
            reach = math.max(reach, math.length(wing.Placement.Hinge) + wing.Placement.Length);
        }

        m_Camera = new PictureCamera(flight.Plan.View, k_DistanceOverSpan * reach);
        m_Shading = new Shading(m_Camera, detail);
    }

    /// <summary>The insect at a phase, 0 to 1 beats.</summary>
    public Pose PoseAt(double turns)
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

    /// <summary>The SVG of a pose in a panel.</summary>
    public string Draw(Pose pose, StripPanel panel)
    {
        var painter = new Painter(panel.Width, panel.Height, m_Detail.TestFineness);
        var picture = new List<float3>();
        for (int k = 0; k < m_Surfaces.Count; k++)
            m_Surfaces[k].Paint(painter, Array.ConvertAll(pose.Places[k], panel.Place), pose.Normals[k], picture, m_Shading);

        var svg = new StringBuilder();
        svg.Append(CultureInfo.InvariantCulture, $"<g transform=\"translate({panel.Left} {panel.Top})scale({1f / m_Detail.Fineness})\">\n");
        foreach (PaintedSheet sheet in painter.Sheets())
            DrawSheet(sheet, picture, svg);
        return svg.Append("</g>\n").ToString();
    }

    private void DrawSheet(PaintedSheet sheet, List<float3> picture, StringBuilder svg)
    {
        if (!sheet.Glass.IsSolid)
            svg.Append(CultureInfo.InvariantCulture, $"<g opacity=\"{0.01 * (100 - sheet.Glass.Percent)}\">\n");
        foreach (PaintedLayer layer in sheet.Layers)
            DrawLayer(layer, picture, svg);
        if (!sheet.Glass.IsSolid)
            svg.Append("</g>\n");
    }

    private void DrawLayer(PaintedLayer layer, List<float3> picture, StringBuilder svg)
    {
        bool isLine = layer.Shape.IsLine;
        var path = new SvgPath(m_Detail.Fineness, m_Detail.Slack);
        foreach (List<int> line in isLine ? OutlineTracer.Strokes(layer.Vertices) : OutlineTracer.Outlines(layer.Vertices))
            path.Add(line, picture, close: !isLine);
        if (!path.IsEmpty)
            svg.Append($"<path class=\"{(isLine ? 'l' : 'f')}\" color=\"#{layer.Shape.Colour:x6}\" d=\"{path}\"/>\n");
    }
}
