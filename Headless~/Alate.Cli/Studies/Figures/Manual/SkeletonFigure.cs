namespace Alate.Cli;

/// <summary>Skeletons on the right wings of all species, from above, each as large as its place.</summary>
internal static class SkeletonFigure
{
    private const int k_Columns = 4;
    private const float k_Width = 1000f, k_Top = 78f, k_Cell = 232f, k_CellHeight = 250f, k_Gap = 10f, k_Title = 24f;

    /// <summary>Draws the wings, SVG.</summary>
    public static string Draw()
    {
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, "Radial skeletons on the meshes", look: "b");
        page.Text(ChartSheet.Edge, 60f, 13f, "Right wings from above, leading edges up: chains of joints from the root to the margin. "
            + "The first chain is thick.", look: "t");
        for (int k = 0; k < InsectCatalogue.All.Count; k++)
        {
            var corner = new float2(ChartSheet.Edge + k % k_Columns * (k_Cell + k_Gap), k_Top + k / k_Columns * k_CellHeight);
            Draw(page, InsectCatalogue.All[k], corner);
        }

        int rows = (InsectCatalogue.All.Count + k_Columns - 1) / k_Columns;
        return page.Finish(k_Width, k_Top + rows * k_CellHeight + k_Gap, "Skeletons on the wings of all species");
    }

    private static void Draw(SvgPage page, InsectDefinition species, float2 corner)
    {
        var insect = Insect.Of(FlightPlan.Cruise(species, InsectVariant.Standard));
        List<PlanWing> wings = [.. insect.Wings.Select(PlanWing.Of)];
        Func<float2, float2> shown = PlanWing.Fit(wings, corner + new float2(0.5f * k_Cell, k_Title + 0.5f * (k_CellHeight - k_Title)),
            new float2(k_Cell, k_CellHeight - k_Title) - 2f * k_Gap);
        page.Text(corner.x, corner.y + 14f, 14f, species.DisplayName, look: "b");
        for (int kind = 0; kind < wings.Count; kind++)
            Draw(page, wings[kind], ChartSheet.Colours[kind], shown);
    }

    private static void Draw(SvgPage page, PlanWing wing, string colour, Func<float2, float2> shown)
    {
        foreach (List<float2> loop in wing.Margins)
            page.Append($"<path d=\"{SvgPage.Path(loop.Select(shown))}Z\" fill=\"{colour}\" fill-opacity=\"0.1\" stroke=\"#8a8272\"/>\n");
        for (int chain = 0; chain < wing.Chains.Count; chain++)
        {
            string thickness = chain == 0 ? "2.4" : "1.3";
            string path = SvgPage.Path(wing.Chains[chain].Select(shown));
            page.Append($"<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{thickness}\"/>\n");
        }

        foreach (float2 joint in wing.Chains.SelectMany(chain => chain))
        {
            float2 place = shown(joint);
            page.Append($"<circle cx=\"{place.x:0.#}\" cy=\"{place.y:0.#}\" r=\"2.6\" fill=\"{colour}\"/>\n");
        }
    }
}
