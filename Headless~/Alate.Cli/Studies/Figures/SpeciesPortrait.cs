namespace Alate.Cli;

/// <summary>A species at three phases of its beat.</summary>
internal static class SpeciesPortrait
{
    private const float k_Panel = 320f, k_Top = 8f, k_Foot = 26f;

    private static readonly double[] s_Phases = [0.0, 0.3, 0.6];

    public static byte[] Draw(FlightRecord flight) => Compose(flight).Write();

    internal static PixelPage Compose(FlightRecord flight)
    {
        var page = new PixelPage();
        PhotoScene scene = FlightPhoto.Scene(flight);
        var layout = new StripLayout(s_Phases.Select(scene.PoseAt).ToList(), s_Phases.Length, 0f, k_Top, k_Panel, 0f);
        for (int k = 0; k < s_Phases.Length; k++)
        {
            page.Add(scene, scene.PoseAt(s_Phases[k]), layout[k]);
            page.Text((k + 0.5f) * k_Panel, layout.Height + 12f, 15f, $"{360.0 * s_Phases[k]:0}°", "middle", "t");
        }

        return page.End(layout.Width, layout.Height + k_Foot, $"{flight.Insect.DisplayName} at three phases of a beat");
    }
}
