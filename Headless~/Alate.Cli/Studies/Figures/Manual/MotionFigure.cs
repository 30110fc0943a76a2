namespace Alate.Cli;

/// <summary>Flap, feather and sweep of a monarch's wing, each alone and all together, as the beat drives them.</summary>
internal static class MotionFigure
{
    private const int k_Shown = 8;
    private const float k_Width = 1000f, k_Top = 78f, k_Panel = 237f, k_PanelHeight = 286f, k_Scale = 138f, k_ChartHeight = 250f;

    private static readonly (string Name, float3 Of)[] s_Motions =
    [
        ("flap alone", new float3(1f, 0f, 0f)), ("feather alone", new float3(0f, 0f, 1f)),
        ("sweep alone", new float3(0f, 1f, 0f)), ("all together", 1f),
    ];

    private static readonly (string Name, string Colour, CurveLook Look)[] s_Angles =
    [
        ("flap", ManualFigures.Blue, CurveLook.Plain), ("sweep", ManualFigures.Grey, CurveLook.Dotted),
        ("feather", ManualFigures.Orange, CurveLook.Dashed),
    ];

    /// <summary>Draws poses and angles, SVG.</summary>
    public static string Draw()
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        var plan = FlightPlan.Cruise(monarch, InsectVariant.Standard);
        InsectWing wing = Insect.Of(plan).Wings[0];
        WingParameters all = plan.ParametersOf(wing.Preset);
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, "Three motions of a monarch's wing", look: "b");
        page.Text(ChartSheet.Edge, 60f, 13f, "Its right wing as the beat drives it, from ahead and a little above: eight moments of the "
            + "downstroke, the darker the later. Thick: the leading edge.", look: "t");
        for (int k = 0; k < s_Motions.Length; k++)
        {
            WingParameters shown = all;
            shown.amplitude *= s_Motions[k].Of;
            Poses(page, DrivenWing.Of(wing, shown), s_Motions[k].Name, ChartSheet.Edge + k * k_Panel);
        }

        Angles(page, all);
        return page.Finish(k_Width, k_Top + k_PanelHeight + k_ChartHeight + 40f, "Flap, feather and sweep of a monarch's wing");
    }

    private static void Poses(SvgPage page, DrivenWing wing, string name, float left)
    {
        page.Text(left, k_Top + 14f, 14f, name, look: "b");
        var root = new float2(left + 0.3f * k_Panel, k_Top + 0.54f * k_PanelHeight);
        for (int k = 0; k < k_Shown; k++)
        {
            float3[] places = wing.Places[k * DrivenWing.Moments / 2 / (k_Shown - 1) % DrivenWing.Moments];
            float2[] shown = Array.ConvertAll(places, place => root + k_Scale * Seen(place));
            string opacity = (0.18f + 0.82f * k / (k_Shown - 1)).ToString("0.##", CultureInfo.InvariantCulture);
            int last = (wing.Chains - 1) * wing.Joints;
            IEnumerable<float2> around = shown.Take(wing.Joints)
                .Concat(Enumerable.Range(1, wing.Chains - 1).Select(chain => shown[chain * wing.Joints + wing.Joints - 1]))
                .Concat(shown.Skip(last).Take(wing.Joints - 1).Reverse());
            page.Append($"<g stroke=\"{ManualFigures.Blue}\" stroke-opacity=\"{opacity}\">");
            page.Append($"<path d=\"{SvgPage.Path(around)}Z\" fill=\"{ManualFigures.Blue}\" fill-opacity=\"0.05\" stroke-width=\"0.8\"/>");
            page.Append($"<path d=\"{SvgPage.Path(shown.Take(wing.Joints))}\" fill=\"none\" stroke-width=\"2.4\"/></g>\n");
        }

        page.Append($"<circle cx=\"{root.x:0.#}\" cy=\"{root.y:0.#}\" r=\"3.4\" fill=\"{ChartSheet.Ink}\"/>\n");
    }

    // Eq. 1 at the root of the leading chain.
    private static void Angles(SvgPage page, WingParameters numbers)
    {
        List<ChartPoint>[] curves = [.. Enumerable.Range(0, 3).Select(axis => ManualFigures.Curve(1.0, 96, turns =>
            180 / Math.PI * numbers.amplitude[axis] * Math.Cos(2 * Math.PI * turns + numbers.phase[axis])))];
        float top = k_Top + k_PanelHeight;
        var legend = new ChartLegend(page, top + 8f);
        foreach ((string name, string colour, CurveLook look) in s_Angles)
            legend.Add(name, colour, look);
        var chart = new PointChart(page, "angles about the hinge, °, over the beat from the top of the stroke", new ChartAxis(0, 1, false,
            [0, 0.25, 0.5, 0.75, 1]), new ChartAxis(-60, 60, false, [-60, -30, 0, 30, 60]), 12f, top + 24f,
            new float2(k_Width - 26f, k_ChartHeight));
        for (int axis = 0; axis < 3; axis++)
            chart.Draw(new PointCurve(curves[axis], s_Angles[axis].Colour, s_Angles[axis].Look));
    }

    // From ahead, 25 degrees above and as many to the side.
    private static float2 Seen(float3 place)
    {
        math.sincos(math.radians(25f), out float sine, out float cosine);
        float across = cosine * place.x + sine * place.z, depth = cosine * place.z - sine * place.x;
        return new float2(across, -(cosine * place.y - sine * depth));
    }
}
