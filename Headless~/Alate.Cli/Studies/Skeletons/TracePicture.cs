using Alate.Authoring;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Cli;

/// <summary>The picture of a wing, pale, and over it what was traced in it, as SVG: outline, mesh, veins, chains and hinge.</summary>
internal sealed class TracePicture
{
    private const string k_Outline = "#0369a1", k_Mesh = "#334155", k_Vein = "#15803d", k_OnVein = "#c026d3", k_Fitted = "#dc2626";

    private readonly StringBuilder m_Svg = new();

    /// <summary>Pixels of a line of middle thickness.</summary>
    private readonly double m_Line;

    private TracePicture(double line)
    {
        m_Line = line;
    }

    /// <summary>The overlay.</summary>
    public static string Draw(PictureFile file, WingTrace trace)
    {
        WingPicture picture = file.Picture;
        var overlay = new TracePicture(Math.Max(picture.Width, picture.Height) / 500.0);
        double foot = 30.0 * overlay.m_Line;
        overlay.Append($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {picture.Width} {picture.Height + foot:0.##}\">\n");
        overlay.Append($"<rect width=\"{picture.Width}\" height=\"{picture.Height + foot:0.##}\" fill=\"#ffffff\"/>\n");
        overlay.Append($"<image width=\"{picture.Width}\" height=\"{picture.Height}\" opacity=\"0.4\" ");
        overlay.m_Svg.Append("href=\"data:image/png;base64,").Append(Convert.ToBase64String(file.Bytes)).Append("\"/>\n");
        overlay.DrawMesh(trace);
        overlay.DrawLine(trace.Outline, k_Outline, 1.0, true);
        foreach (Vector2[] vein in trace.Veins)
            overlay.DrawLine(vein, k_Vein, 1.2, false);
        for (int i = 0; i < trace.Skeleton.ChainCount; i++)
            overlay.DrawChain(trace, i);
        overlay.DrawDot(trace.Placement.ToPicture(trace.Skeleton.Hinge), 6.0, "none", "#0f172a");
        overlay.DrawLegend(picture, trace);
        overlay.m_Svg.Append("</svg>\n");
        return overlay.m_Svg.ToString();
    }

    // Each side once, whichever triangle comes first.
    private void DrawMesh(WingTrace trace)
    {
        Vector2[] places = Array.ConvertAll(trace.Surface.positions, trace.Placement.ToPicture);
        int[] corners = trace.Surface.triangles;
        var drawn = new MeshEdges();
        Append($"<path fill=\"none\" stroke=\"{k_Mesh}\" stroke-width=\"{0.25 * m_Line:0.##}\" d=\"");
        for (int k = 0; k < corners.Length; k++)
        {
            int a = corners[k], b = corners[TriangleLinks.Next(k)];
            if (drawn.Add(a, b))
                Append($"M{places[a].x:0.#} {places[a].y:0.#}L{places[b].x:0.#} {places[b].y:0.#}");
        }

        m_Svg.Append("\"/>\n");
    }

    private void DrawChain(WingTrace trace, int chain)
    {
        Vector2[] joints = Array.ConvertAll(trace.Skeleton.Chains[chain].joints, trace.Placement.ToPicture);
        string colour = trace.FollowsVein[chain] ? k_OnVein : k_Fitted;
        DrawLine(joints, colour, 1.5, false);
        foreach (Vector2 joint in joints)
            DrawDot(joint, 2.5, colour, "none");
    }

    private void DrawLine(Vector2[] points, string colour, double thickness, bool isClosed)
    {
        string places = string.Join(' ', points.Select(p => string.Create(CultureInfo.InvariantCulture, $"{p.x:0.#},{p.y:0.#}")));
        Append($"<poly{(isClosed ? "gon" : "line")} fill=\"none\" stroke=\"{colour}\"");
        Append($" stroke-width=\"{thickness * m_Line:0.##}\" points=\"{places}\"/>\n");
    }

    private void DrawDot(Vector2 at, double radius, string fill, string stroke)
    {
        Append($"<circle cx=\"{at.x:0.#}\" cy=\"{at.y:0.#}\" r=\"{radius * m_Line:0.##}\"");
        Append($" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"{m_Line:0.##}\"/>\n");
    }

    private void DrawLegend(WingPicture picture, WingTrace trace)
    {
        double size = 11.0 * m_Line, line = picture.Height + 13.0 * m_Line;
        Append($"<text x=\"{size:0.##}\" y=\"{line:0.##}\" font-family=\"Helvetica,Arial,sans-serif\"");
        Append($" font-size=\"{size:0.##}\" fill=\"#0f172a\">");
        Append($"{picture.Width} × {picture.Height} pixels, {trace.Surface.TriangleCount} triangles</text>\n");
        Append($"<text x=\"{size:0.##}\" y=\"{line + 13.0 * m_Line:0.##}\" font-family=\"Helvetica,Arial,sans-serif\"");
        Append($" font-size=\"{size:0.##}\">");
        Append($"<tspan fill=\"{k_Outline}\">outline</tspan>  <tspan fill=\"{k_Vein}\">veins: {trace.Veins.Count}</tspan>  ");
        Append($"<tspan fill=\"{k_OnVein}\">chains on veins: {trace.FollowsVein.Count(follows => follows)}</tspan>  ");
        Append($"<tspan fill=\"{k_Fitted}\">other chains: {trace.FollowsVein.Count(follows => !follows)}</tspan></text>\n");
    }

    private void Append(FormattableString text) => m_Svg.Append(text.ToString(CultureInfo.InvariantCulture));
}
