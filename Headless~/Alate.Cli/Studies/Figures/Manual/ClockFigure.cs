namespace Alate.Cli;

/// <summary>Frequency and amplitude of a monarch's beat over its speed and climb (Eq. 6, Eq. 7, Fig. 5), by the model.</summary>
internal static class ClockFigure
{
    private const double k_Fastest = 2.5;
    private const int k_Steps = 50;

    /// <summary>Draws three charts, SVG.</summary>
    public static string Draw()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        InsectWing wing = Insect.Of(plan).Wings[0];
        using var clock = new Clock(wing);
        var sheet = new ChartSheet("How hard a monarch beats", "Over its speed ahead, m/s. The clock takes speed and pitch at the top "
            + "of each stroke; nose up by more than 30° it has at least 0.85 of the largest.");
        WingParameters ours = plan.ParametersOf(wing.Preset), printed = ours;
        printed.frequencyFloor = printed.amplitudeFloor = 0f;
        (string Name, WingParameters Numbers, double Climb, string Colour, CurveLook Look)[] flights =
        [
            ("level", ours, 0, ManualFigures.Blue, CurveLook.Plain),
            ("climbing by 0.7 m/s", ours, 0.7, ManualFigures.Orange, CurveLook.Dashed),
            ("as printed, level", printed, 0, ManualFigures.Grey, CurveLook.Dotted),
        ];
        double[] speeds = [.. Enumerable.Range(0, k_Steps + 1).Select(k => k_Fastest * k / k_Steps)];
        BeatNow[][] beats = Array.ConvertAll(flights, flight => Array.ConvertAll(
            speeds, speed => clock.At(flight.Numbers, Math.Sqrt(speed * speed + flight.Climb * flight.Climb))));
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        foreach ((string name, _, _, string colour, CurveLook look) in flights)
            legend.Add(name, colour, look);
        (string Title, Func<BeatNow, double> Of)[] charts =
        [
            ("frequency, Hz", now => now.Frequency), ("amplitude of the flap, °", now => 180 / Math.PI * now.Amplitude.x),
            ("amplitude of the feather, °", now => 180 / Math.PI * now.Amplitude.z),
        ];
        var across = new ChartAxis(0, k_Fastest, false, [0, 0.5, 1, 1.5, 2, 2.5]);
        for (int k = 0; k < charts.Length; k++)
        {
            double[][] curves = Array.ConvertAll(beats, own => Array.ConvertAll(own, now => charts[k].Of(now)));
            PointChart chart = sheet.Chart(k, charts[k].Title, across, ChartAxis.Linear(curves.SelectMany(curve => curve)));
            for (int n = 0; n < curves.Length; n++)
            {
                chart.Draw(new PointCurve(
                    [.. speeds.Zip(curves[n], (speed, value) => new ChartPoint(speed, value))], flights[n].Colour, flights[n].Look));
            }
        }

        return sheet.Finish(charts.Length, "Frequency and amplitudes of a monarch's beat over speed and climb");
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
