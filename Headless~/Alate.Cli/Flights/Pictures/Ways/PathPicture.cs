namespace Alate.Cli;

/// <summary>
/// path.png: a flight from above with times, start, end and direction, its height over the distance flown, and the bob of one beat. The
/// insects are drawn larger than the way by a factor that the reader is told.
/// </summary>
internal static class PathPicture
{
    private const float k_Width = 930f, k_Height = 800f, k_Edge = 26f;

    /// <summary>Factor from which on it is told that the picture shows the insect larger than its way.</summary>
    public const float Larger = 1.5f;

    /// <summary>The picture as a PNG file.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="factor">How many times larger than the way the insects are drawn.</param>
    public static byte[] Draw(FreeRecord flight, out float factor) => Compose(flight, out factor).Write();

    internal static PixelPage Compose(FreeRecord flight, out float factor)
    {
        var page = new PixelPage();
        var way = new FlownWay(flight);
        var map = new PathMap(flight, way, new float2(k_Edge, 76f), new float2(k_Width - 2f * k_Edge, 430f));
        map.Draw(page);
        factor = map.Factor;
        PathProfile.Draw(page, way, new float2(k_Edge + 50f, 556f), new float2(600f, 186f), FlightPhoto.Reach(flight.Beat));
        BeatBob.Draw(page, flight, way, new float2(k_Width - k_Edge - 190f, 556f), new float2(190f, 186f));
        string name = flight.Insect.DisplayName, told = Told(way, factor);
        page.Text(k_Edge, 38f, 22f, name, look: "b");
        page.Text(k_Edge, 58f, 13f, told, look: "t");
        return page.End(k_Width, k_Height, $"{name}: {told}");
    }

    private static string Told(FlownWay way, float factor)
    {
        string larger = factor < Larger ? "" : string.Create(
            CultureInfo.InvariantCulture, $"; insects drawn {factor:0.#} times as large as their way");
        return string.Create(CultureInfo.InvariantCulture,
            $"{way.Times[^1]:0.##} s by its own wings, {way.Distances[^1]:0.##} m flown, seen from above{larger}");
    }
}
