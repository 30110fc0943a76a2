namespace Alate.Cli;

/// <summary>Trim curves over the speed, a line a climb; over the climb where there is one speed.</summary>
internal static class TrimPicture
{
    private static readonly string[] s_Colours = ["#0b5fa5", "#3d3a34", "#c2410c", "#5b7f2b", "#7a3b8f"];

    /// <summary>The picture.</summary>
    public static string Draw(InsectDefinition insect, IReadOnlyList<TrimRow> rows)
    {
        const float k_Width = 500f, k_Height = 280f;
        double[] speeds = rows.Select(row => row.Speed).Distinct().OrderBy(speed => speed).ToArray(),
            climbs = rows.Select(row => row.Climb).Distinct().OrderBy(climb => climb).ToArray();
        bool isOverClimb = speeds.Length == 1;
        double[] along = isOverClimb ? climbs : speeds, lines = isOverClimb ? speeds : climbs;
        var page = new SvgPage();
        page.Text(26f, 38f, 22f, $"{insect.DisplayName}: trim over {(isOverClimb ? "climb" : "speed")}", look: "b");
        page.Text(26f, 60f, 13f, along.Length == 1
            ? "One point has no curves; trim.csv has its numbers."
            : isOverClimb
                ? $"Climb, m/s, at {LineChart.Label(speeds[0])} m/s ahead."
                : $"Speed ahead, m/s. Lines: climb {string.Join(", ", climbs.Select(LineChart.Label))} m/s, from blue to red.", look: "t");
        (string Title, Func<TrimRow, double> Of)[] charts =
        [
            ("Pitch, °", row => row.Pitch), ("Frequency, Hz", row => row.Frequency), ("Flap from end to end, °", row => row.Flap),
            ("Tilt of the stroke, °", row => row.Tilt), ("Middle of the stroke ahead, °", row => row.Sweep),
            ("Bob of the pitch, ±°", row => row.PitchBob), ("Power to the air, mW", row => row.Power),
        ];
        for (int k = 0; k < charts.Length; k++)
        {
            var curves = new List<ChartCurve>();
            for (int line = 0; line < lines.Length; line++)
            {
                double other = lines[line];
                IEnumerable<double> values = along.Select(place =>
                {
                    (double speed, double climb) = isOverClimb ? (other, place) : (place, other);
                    return rows.FirstOrDefault(row => row.Speed == speed && row.Climb == climb && row.Closes) is { } row
                        ? charts[k].Of(row)
                        : double.NaN;
                });
                curves.Add(new ChartCurve(values.ToList(), s_Colours[line % s_Colours.Length], false));
            }

            if (along.Length > 1)
            {
                new LineChart(along, false, 12f + k % 2 * k_Width, 76f + k / 2 * k_Height, k_Width - 20f, k_Height)
                    .Draw(page, charts[k].Title, curves);
            }
        }

        return page.Finish(2f * k_Width + 12f, 88f + (charts.Length + 1) / 2 * k_Height, $"Trim curves of the {insect.DisplayName}");
    }
}
