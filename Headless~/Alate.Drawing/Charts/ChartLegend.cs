namespace Alate.Drawing;

/// <summary>Entries beside one another in lines: a mark and its meaning.</summary>
/// <param name="page">Where to.</param>
/// <param name="top">Middle of the first line.</param>
internal sealed class ChartLegend(SvgPage page, float top)
{
    private const float k_Line = 24f, k_Mark = 34f, k_Gap = 26f, k_Letter = 6.4f, k_Size = 13f;

    private float m_X = ChartSheet.Edge, m_Y = top;

    /// <summary>A curve of a look.</summary>
    public void Add(string text, string colour, CurveLook look)
    {
        page.Append($"<path d=\"M{m_X:0.#} {m_Y:0.#}h{k_Mark - 6f:0.#}\" stroke=\"{colour}\" fill=\"none\" {PointChart.Stroke(look)}/>\n");
        PointChart.Mark(page, new float2(m_X + 0.5f * (k_Mark - 6f), m_Y), colour, look);
        Say(text, k_Mark);
    }

    /// <summary>A ring.</summary>
    public void AddRing(string text, string colour)
    {
        page.Append($"<circle cx=\"{m_X + 8f:0.#}\" cy=\"{m_Y:0.#}\" r=\"6.5\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>\n");
        Say(text, 22f);
    }

    /// <summary>A cross.</summary>
    public void AddCross(string text, string colour)
    {
        PointChart.Cross(page, new float2(m_X + 6f, m_Y), colour);
        Say(text, 20f);
    }

    /// <summary>The colours of the kinds of wings that occur.</summary>
    /// <param name="wings">Kinds that the wing's species has, and which of them the wing is.</param>
    public void AddWings(IEnumerable<(int Kinds, int Kind)> wings)
    {
        bool hasSeveral = wings.Any(wing => wing.Kinds > 1);
        AddDisc(hasSeveral ? "fore wing, or the only one" : "wing", ChartSheet.Colours[0]);
        if (hasSeveral)
            AddDisc("hind wing", ChartSheet.Colours[1]);
    }

    /// <summary>A text without a mark.</summary>
    public void AddText(string text)
    {
        page.Text(m_X, m_Y + 4f, k_Size, text, look: "t");
        m_X += k_Letter * text.Length + k_Gap;
    }

    /// <summary>Goes on in the next line.</summary>
    public void NextLine()
    {
        m_X = ChartSheet.Edge;
        m_Y += k_Line;
    }

    private void AddDisc(string text, string colour)
    {
        page.Append($"<circle cx=\"{m_X + 6f:0.#}\" cy=\"{m_Y:0.#}\" r=\"5\" fill=\"{colour}\"/>\n");
        Say(text, 18f);
    }

    private void Say(string text, float mark)
    {
        page.Text(m_X + mark, m_Y + 4f, k_Size, text);
        m_X += mark + k_Letter * text.Length + k_Gap;
    }
}
