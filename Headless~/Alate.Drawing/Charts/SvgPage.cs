using System.Globalization;
using System.Security;
using System.Text;

namespace Alate.Drawing;

/// <summary>A diagram or a chart as SVG on pale ground.</summary>
internal sealed class SvgPage
{
    private const string k_Style = "text{font-family:Helvetica,Arial,sans-serif;fill:#3d3a34}.t{fill:#6b6458}.b{font-weight:bold}";

    private readonly StringBuilder m_Content = new();

    /// <summary>The whole file.</summary>
    /// <param name="width">Units of the picture.</param>
    /// <param name="height">Units of the picture.</param>
    /// <param name="title">What it shows, for those who do not see it.</param>
    public string Finish(float width, float height, string title)
    {
        var page = new StringBuilder();
        page.Append(CultureInfo.InvariantCulture, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" ");
        page.Append(
            CultureInfo.InvariantCulture, $"width=\"{width}\" height=\"{height}\">\n<title>{SecurityElement.Escape(title)}</title>\n");
        page.Append($"<style>{k_Style}</style>\n");
        page.Append(CultureInfo.InvariantCulture, $"<rect width=\"{width}\" height=\"{height}\" rx=\"14\" fill=\"#f7f4ec\"/>\n");
        return page.Append(m_Content).Append("</svg>\n").ToString();
    }

    /// <summary>Adds a line of text.</summary>
    /// <param name="x">Where its anchor lies.</param>
    /// <param name="y">Its base line.</param>
    /// <param name="size">Height of the letters.</param>
    /// <param name="text">Any characters.</param>
    /// <param name="anchor">start, middle or end.</param>
    /// <param name="look">t for pale, b for bold, or nothing.</param>
    public void Text(float x, float y, float size, string text, string anchor = "start", string look = "")
    {
        Append($"<text x=\"{x:0.##}\" y=\"{y:0.##}\" font-size=\"{size:0.##}\"");
        if (anchor != "start")
            Append($" text-anchor=\"{anchor}\"");
        if (look.Length > 0)
            Append($" class=\"{look}\"");
        Append($">{SecurityElement.Escape(text)}</text>\n");
    }

    /// <summary>Adds a straight line.</summary>
    public void Line(float x1, float y1, float x2, float y2, string colour, float thickness = 1f)
    {
        Append($"<line x1=\"{x1:0.##}\" y1=\"{y1:0.##}\" x2=\"{x2:0.##}\" y2=\"{y2:0.##}\"");
        Append($" stroke=\"{colour}\" stroke-width=\"{thickness:0.##}\"/>\n");
    }

    /// <summary>Data of a path along points.</summary>
    public static string Path(IEnumerable<float2> points) => string.Concat(points.Select((point, k) =>
        string.Create(CultureInfo.InvariantCulture, $"{(k == 0 ? 'M' : 'L')}{point.x:0.#} {point.y:0.#}")));

    /// <summary>Adds what is SVG already.</summary>
    public void Add(string svg) => m_Content.Append(svg);

    /// <summary>Adds SVG whose numbers are written as they should be.</summary>
    public void Append(FormattableString svg) => m_Content.Append(svg.ToString(CultureInfo.InvariantCulture));
}
