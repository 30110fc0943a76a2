namespace Alate.Cli;

/// <summary>
/// stretch.png: the wings at rest from above, in colours that say by how much the membrane stretches there in the beat, at most.
/// </summary>
internal static class StretchMap
{
    private const float k_Width = 760f, k_Header = 74f, k_Edge = 26f, k_RampWidth = 220f, k_RampHeight = 10f, k_Foot = 20f;

    /// <summary>Stretch of the last colour, and of all beyond.</summary>
    private const float k_Most = 0.08f;

    /// <summary>From none to <see cref="k_Most"/>, sRGB; the live view's.</summary>
    private static readonly float3[] s_Stops = [.. new[] { 0xc4d6e4, 0xf2c14e, 0xe4572e, 0x7b1e3a, 0x230a2b }.Select(Shading.Colour)];

    public static byte[] Draw(FlightRecord flight) => Compose(flight).Write();

    internal static PixelPage Compose(FlightRecord flight)
    {
        var largest = flight.Wings.ToDictionary(wing => wing, StretchField.Largest);
        PhotoScene scene = FlightPhoto.Scene(
            flight, PictureView.ByName["top"], (index, wing) => PhotoSurface.Thin(
                index, wing.Rest, wing.Triangles, Array.ConvertAll(largest[wing], stretch => new float4(stretch, 0f, 0f, 0f)),
                (stretch, _) => new float4(Shading.ToLinear(ColourOf(stretch.x / k_Most)), 1f)));
        Pose rest = scene.Rest();
        var layout = new StripLayout([rest], 1, 0f, k_Header, k_Width, 0f);
        var page = new PixelPage();
        page.Text(k_Edge, 38f, 22f, flight.Insect.DisplayName, look: "b");
        page.Text(k_Edge, 58f, 13f, "largest stretch of the membrane over a beat", look: "t");
        page.Text(k_Width - k_Edge, 37f, 13f, Worst(flight, largest), "end");
        page.Add(scene, rest, layout[0]);
        Ramp(page, k_Width - k_Edge - k_RampWidth, 50f);
        return page.End(k_Width, layout.Height + k_Foot, $"{flight.Insect.DisplayName}: {Worst(flight, largest)}");
    }

    // Which place of which wing: of the right one, as the left one is its mirror image but in a wind from aside.
    private static string Worst(FlightRecord flight, Dictionary<RecordedWing, float[]> largest)
    {
        RecordedWing wing = flight.Wings.MaxBy(one => largest[one].Max());
        int vertex = Array.IndexOf(largest[wing], largest[wing].Max());
        float span = wing.Rest.Min(place => place.x) is var low
            ? (wing.Rest[vertex].x - low) / (wing.Rest.Max(place => place.x) - low)
            : 0f;
        return string.Create(
            CultureInfo.InvariantCulture, $"{100f * largest[wing][vertex]:0.0} % on the {wing.Wing.Name} at {100f * span:0} % of its span");
    }

    private static void Ramp(PixelPage page, float left, float top)
    {
        const int k_Parts = 110;
        for (int k = 0; k < k_Parts; k++)
        {
            var colour = (int3)math.round(255f * ColourOf((k + 0.5f) / k_Parts));
            float x = left + (k + 0.5f) * k_RampWidth / k_Parts;
            page.Line(x, top, x, top + k_RampHeight, (colour.x << 16) | (colour.y << 8) | colour.z, k_RampWidth / k_Parts);
        }

        page.Text(left, top + 24f, 11f, "0 %", look: "t");
        page.Text(
            left + k_RampWidth, top + 24f, 11f, string.Create(CultureInfo.InvariantCulture, $"{100f * k_Most:0} % and more"), "end", "t");
    }

    private static float3 ColourOf(float share)
    {
        float at = math.saturate(share) * (s_Stops.Length - 1);
        int stop = math.min((int)at, s_Stops.Length - 2);
        return math.lerp(s_Stops[stop], s_Stops[stop + 1], at - stop);
    }
}
