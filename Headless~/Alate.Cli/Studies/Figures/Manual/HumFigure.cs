namespace Alate.Cli;

/// <summary>Sound of three insects: its wave over two beats, and how strong its overtones are.</summary>
internal static class HumFigure
{
    private const int k_Overtones = 12, k_Points = 160;

    /// <summary>Level below the strongest overtone that is drawn as this, decibels.</summary>
    private const double k_Quietest = -60;

    private static readonly string[] s_Species = ["monarch", "firefly", "dragonfly"];

    /// <summary>Draws the charts, SVG.</summary>
    public static string Draw()
    {
        var sheet = new ChartSheet("The hum of three insects",
            "Above the sound's wave over two beats, below the overtones of the beat, decibels below the strongest.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        legend.Add("sound, 1 the loudest that a source plays", ManualFigures.Blue, CurveLook.Plain);
        legend.Add("overtone", ManualFigures.Orange, CurveLook.Discs);
        for (int k = 0; k < s_Species.Length; k++)
        {
            FlightRecord flight = TetheredFlight.Fly(FlightPlan.Cruise(InsectCatalogue.Find(s_Species[k]), InsectVariant.Standard));
            double frequency = flight.Wings[0].Frequency;
            double[] beats = TwoBeats(flight, frequency);
            string title = FormattableString.Invariant($"{flight.Insect.DisplayName}, {frequency:0.#} Hz");
            PointChart wave = sheet.Chart(k, title, new ChartAxis(0, 2, false, [0, 0.5, 1, 1.5, 2]),
                new ChartAxis(-0.8, 0.8, false, [-0.8, -0.4, 0, 0.4, 0.8]));
            wave.Draw(new PointCurve(ManualFigures.Curve(2, k_Points, at => beats[(int)(at / 2 * beats.Length) % beats.Length]),
                ManualFigures.Blue, CurveLook.Plain));
            PointChart overtones = sheet.Chart(k + s_Species.Length, "overtones, dB",
                new ChartAxis(0, k_Overtones, false, [0, 3, 6, 9, 12]), new ChartAxis(k_Quietest, 0, false, [-60, -40, -20, 0]));
            overtones.Draw(new PointCurve(Levels(beats), ManualFigures.Orange, CurveLook.Discs));
        }

        return sheet.Finish(2 * s_Species.Length, "Waves and overtones of the hum of monarch, firefly and dragonfly");
    }

    /// <summary>Levels of the overtones of a sound that lasts two beats, from the first one on.</summary>
    /// <param name="beats">[sample] The sound.</param>
    public static List<ChartPoint> Levels(double[] beats)
    {
        double[] power = new double[k_Overtones];
        for (int overtone = 1; overtone <= k_Overtones; overtone++)
        {
            double sine = 0, cosine = 0;
            for (int k = 0; k < beats.Length; k++)
            {
                double turn = 2 * Math.PI * 2 * overtone * k / beats.Length;
                sine += beats[k] * Math.Sin(turn);
                cosine += beats[k] * Math.Cos(turn);
            }

            power[overtone - 1] = sine * sine + cosine * cosine;
        }

        double most = Math.Max(power.Max(), double.Epsilon);
        return [.. power.Select((own, k) => new ChartPoint(
            k + 1, Math.Max(10 * Math.Log10(Math.Max(own, double.Epsilon) / most), k_Quietest)))];
    }

    // The last two whole beats of a second.
    private static double[] TwoBeats(FlightRecord flight, double frequency)
    {
        float[] sound = BeatSound.Of(flight, frequency, 1.0);
        int count = (int)Math.Round(2 * BeatSound.Rate / frequency);
        return Array.ConvertAll(sound[^count..], sample => (double)sample);
    }
}
