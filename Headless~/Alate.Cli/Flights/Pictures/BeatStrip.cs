namespace Alate.Cli;

/// <summary>strip.png: twelve phases of a beat, all wings and the body, from one side.</summary>
internal static class BeatStrip
{
    private const int k_Columns = 4, k_Rows = 3;

    /// <summary>The whole picture.</summary>
    public static byte[] Draw(FlightRecord flight) => Compose(flight, out _).Write(isSmall: true);

    /// <summary>The picture before it is painted.</summary>
    public static PixelPage Compose(FlightRecord flight, out StripLayout layout)
    {
        var page = new PixelPage();
        PhotoScene scene = FlightPhoto.Scene(flight);
        var poses = new List<Pose>();
        for (int k = 0; k < k_Columns * k_Rows; k++)
            poses.Add(scene.PoseAt(k / (double)(k_Columns * k_Rows)));
        layout = new StripLayout(poses, k_Columns);
        page.Text(26f, 40f, 24f, flight.Insect.DisplayName, look: "b");
        page.Text(layout.Width - 26f, 39f, 17f, Caption(flight), "end");
        for (int k = 0; k < poses.Count; k++)
        {
            page.Add(scene, poses[k], layout[k]);
            Label(page, flight, k / (double)poses.Count, layout[k].Left + 0.5f * layout[k].Width, layout[k].Top + layout[k].Height + 10f);
        }

        return page.End(layout.Width, layout.Height, Title(flight));
    }

    private static void Label(PixelPage page, FlightRecord flight, double turns, float middle, float bottom)
    {
        const float k_Gap = 5f;
        page.Text(middle - k_Gap, bottom, 17f, Text($"{360.0 * turns:0}°"), "end");
        page.Text(middle + k_Gap, bottom, 13f, Text($"{1000.0 * turns / flight.Wings[0].Frequency:0.0} ms"), look: "t");
    }

    private static string Title(FlightRecord flight) =>
        $"{flight.Insect.DisplayName}: twelve phases of a beat, seen from {flight.Plan.View.Words}";

    private static string Caption(FlightRecord flight) =>
        Text($"one beat, {1000.0 / flight.Wings[0].Frequency:0.#} ms at ")
        + Text($"{flight.Wings[0].Frequency:0.#} Hz, flying {flight.Plan.BodySpeed:0.##} m/s");

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
