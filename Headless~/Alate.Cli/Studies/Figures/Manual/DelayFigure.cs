namespace Alate.Cli;

/// <summary>Delays of the beat along the span and over the chord of a monarch's wing.</summary>
internal static class DelayFigure
{
    private const float k_Width = 1000f, k_Height = 400f, k_Top = 78f, k_Map = 470f, k_Chart = 500f;

    /// <summary>Draws a map of delays and the waves at five places, SVG.</summary>
    public static string Draw()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        InsectWing wing = Insect.Of(plan).Wings[0];
        WingParameters flap = plan.ParametersOf(wing.Preset);
        flap.amplitude *= new float3(1f, 0f, 0f);
        var driven = DrivenWing.Of(wing, flap);
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, "The deformation wave on a monarch's wing", look: "b");
        page.Text(ChartSheet.Edge, 60f, 13f, "Flap alone, as the beat drives it. Left: by how many degrees of the beat the bone up to "
            + "each joint is late. Right: how far bones flap.", look: "t");
        Map(page, wing, driven);
        Waves(page, driven);
        return page.Finish(k_Width, k_Height, "Delays and waves along span and chord of a monarch's wing");
    }

    /// <summary>Delay of a bone's flap behind that at the leading root, degrees of the beat.</summary>
    public static double Delay(DrivenWing wing, int chain, int bone)
    {
        double Phase(int at)
        {
            double sine = 0, cosine = 0;
            for (int moment = 0; moment < DrivenWing.Moments; moment++)
            {
                double turn = 2 * Math.PI * moment / DrivenWing.Moments;
                sine += wing.Flaps[moment][at] * Math.Sin(turn);
                cosine += wing.Flaps[moment][at] * Math.Cos(turn);
            }

            return Math.Atan2(sine, cosine);
        }

        return 180 / Math.PI * (Phase(chain * (wing.Joints - 1) + bone) - Phase(0));
    }

    private static void Map(SvgPage page, InsectWing wing, DrivenWing driven)
    {
        var seen = PlanWing.Of(wing);
        Func<float2, float2> shown = PlanWing.Fit([seen], new float2(0.5f * k_Map, k_Top + 0.5f * (k_Height - k_Top)),
            new float2(k_Map - 60f, k_Height - k_Top - 50f));
        foreach (List<float2> loop in seen.Margins)
        {
            page.Append($"<path d=\"{SvgPage.Path(loop.Select(shown))}Z\" fill=\"{ManualFigures.Blue}\" fill-opacity=\"0.08\" ");
            page.Append($"stroke=\"#8a8272\"/>\n");
        }
        for (int chain = 0; chain < driven.Chains; chain++)
        {
            page.Append($"<path d=\"{SvgPage.Path(seen.Chains[chain].Select(shown))}\" fill=\"none\" stroke=\"{ManualFigures.Blue}\"/>\n");
            for (int bone = 0; bone < driven.Joints - 1; bone++)
            {
                float2 at = shown(seen.Chains[chain][bone + 1]);
                page.Append($"<circle cx=\"{at.x:0.#}\" cy=\"{at.y:0.#}\" r=\"11\" fill=\"#f7f4ec\" stroke=\"{ManualFigures.Blue}\"/>\n");
                string delay = Math.Round(Delay(driven, chain, bone)).ToString("0", CultureInfo.InvariantCulture);
                page.Text(at.x, at.y + 4f, 11f, delay, "middle");
            }
        }
    }

    private static void Waves(SvgPage page, DrivenWing driven)
    {
        int tip = driven.Joints - 2, middle = driven.Chains / 2, last = driven.Chains - 1;
        (string Name, int Chain, int Bone, string Colour, CurveLook Look)[] bones =
        [
            ("leading, root", 0, 0, ManualFigures.Blue, CurveLook.Thin), ("leading, tip", 0, tip, ManualFigures.Blue, CurveLook.Plain),
            ("middle, tip", middle, tip, ManualFigures.Green, CurveLook.Dashed),
            ("trailing, tip", last, tip, ManualFigures.Orange, CurveLook.Dotted),
        ];
        List<ChartPoint>[] curves = [.. bones.Select(bone => Enumerable.Range(0, DrivenWing.Moments + 1).Select(k => new ChartPoint(
            (double)k / DrivenWing.Moments,
            180 / Math.PI * driven.Flaps[k % DrivenWing.Moments][bone.Chain * (driven.Joints - 1) + bone.Bone])).ToList())];
        var chart = new PointChart(page, "flap, °, over the beat", new ChartAxis(0, 1, false, [0, 0.25, 0.5, 0.75, 1]),
            ChartAxis.Linear(curves.SelectMany(curve => curve).Select(point => point.Y)), k_Map + 10f, k_Top, new float2(k_Chart, 264f));
        for (int k = 0; k < curves.Length; k++)
            chart.Draw(new PointCurve(curves[k], bones[k].Colour, bones[k].Look));
        for (int k = 0; k < bones.Length; k++)
        {
            float x = k_Map + 50f + k % 2 * 230f, y = k_Top + 284f + k / 2 * 22f;
            string look = PointChart.Stroke(bones[k].Look);
            page.Append($"<path d=\"M{x:0.#} {y:0.#}h28\" stroke=\"{bones[k].Colour}\" fill=\"none\" {look}/>\n");
            page.Text(x + 36f, y + 4f, 13f, bones[k].Name);
        }
    }
}
