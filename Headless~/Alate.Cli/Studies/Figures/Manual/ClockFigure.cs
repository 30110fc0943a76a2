namespace Alate.Cli;

/// <summary>Frequency and amplitude of a monarch's beat over its speed and climb (Eq. 6, Eq. 7, Fig. 5), by the model.</summary>
internal static class ClockFigure
{
    private const double k_Fastest = 2.5;
    private const int k_Steps = 50;

    private static readonly (string Name, double Climb, string Colour, CurveLook Look)[] s_Climbs =
    [
        ("level", 0, ManualFigures.Blue, CurveLook.Plain), ("climbing by 0.7 m/s", 0.7, ManualFigures.Orange, CurveLook.Dashed),
    ];

    /// <summary>Draws three charts, SVG.</summary>
    public static string Draw()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        InsectWing wing = Insect.Of(plan).Wings[0];
        using var clock = new Clock(wing);
        var sheet = new ChartSheet("How hard a monarch beats", "Over its speed ahead, m/s. The clock takes speed and pitch at the top "
            + "of each stroke; nose up by more than 30° it has at least 0.85 of the largest.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        foreach ((string name, _, string colour, CurveLook look) in s_Climbs)
            legend.Add(name, colour, look);
        legend.Add("as printed, level", ManualFigures.Grey, CurveLook.Dotted);
        WingParameters ours = plan.ParametersOf(wing.Preset), printed = ours;
        printed.frequencyFloor = printed.amplitudeFloor = 0f;
        var across = new ChartAxis(0, k_Fastest, false, [0, 0.5, 1, 1.5, 2, 2.5]);
        List<(string Title, Func<BeatNow, double> Of)> charts =
        [
            ("frequency, Hz", now => now.Frequency), ("amplitude of the flap, °", now => 180 / Math.PI * now.Amplitude.x),
            ("amplitude of the feather, °", now => 180 / Math.PI * now.Amplitude.z),
        ];
        for (int k = 0; k < charts.Count; k++)
        {
            List<List<ChartPoint>> curves = [.. s_Climbs.Select(climb => ManualFigures.Curve(k_Fastest, k_Steps,
                speed => charts[k].Of(clock.At(ours, Math.Sqrt(speed * speed + climb.Climb * climb.Climb)))))];
            List<ChartPoint> paper = ManualFigures.Curve(k_Fastest, k_Steps, speed => charts[k].Of(clock.At(printed, speed)));
            PointChart chart = sheet.Chart(k, charts[k].Title, across, ChartAxis.Linear(curves.Append(paper).SelectMany(curve => curve)
                .Select(point => point.Y)));
            for (int n = 0; n < curves.Count; n++)
                chart.Draw(new PointCurve(curves[n], s_Climbs[n].Colour, s_Climbs[n].Look));
            chart.Draw(new PointCurve(paper, ManualFigures.Grey, CurveLook.Dotted));
        }

        return sheet.Finish(charts.Count, "Frequency and amplitudes of a monarch's beat over speed and climb");
    }

    /// <summary>A beat as its clock has it.</summary>
    /// <param name="Frequency">Hertz.</param>
    /// <param name="Amplitude">Flap, sweep and feather, radians.</param>
    private readonly record struct BeatNow(float Frequency, float3 Amplitude);

    /// <summary>A wing that begins its beat at any speed.</summary>
    private sealed class Clock(InsectWing wing) : IDisposable
    {
        private readonly WingRig m_Rig = WingRig.Bake(
            wing.Skeleton, wing.Surface, new WingRigSettings { patchCount = WingRigSettings.CoarsePatches });

        public BeatNow At(in WingParameters parameters, double speed)
        {
            using var world = new WingWorld();
            WingReading reading = world.Read(world.Add(m_Rig, parameters, new WingSurroundings { speed = (float)speed }));
            return new BeatNow(reading.Frequency, reading.Amplitude);
        }

        public void Dispose() => m_Rig.Release();
    }
}
