namespace Alate.Cli;

/// <summary>
/// Way of a free flight as its picture shows it: places with and without the bob of the beat, distances flown, and marks of time.
/// </summary>
internal sealed class FlownWay
{
    private const int k_MostPoints = 2400, k_MostMarks = 8, k_Shades = 32;

    private static readonly double[] s_Steps = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200];

    /// <summary>From the lowest to the highest place, sRGB.</summary>
    private static readonly float3[] s_Heights = [.. new[] { 0x2f5d9c, 0x1f9a8a, 0xe0a02b, 0xc8432f }.Select(Shading.Colour)];

    public FlownWay(FreeRecord flight)
    {
        IReadOnlyList<FreeMoment> moments = flight.Moments;
        Places = [.. moments.Select(at => at.Position)];
        Times = [.. moments.Select(at => at.Time)];
        double step = moments.Count > 1 ? (Times[^1] - Times[0]) / (moments.Count - 1) : 1.0;
        Means = MeansOf(Places, (int)Math.Round(0.5 / (moments[moments.Count / 2].Frequency * step)));
        Distances = new float[Places.Length];
        for (int k = 1; k < Places.Length; k++)
            Distances[k] = Distances[k - 1] + math.distance(Means[k].xz, Means[k - 1].xz);
        Points = [.. Enumerable.Range(0, Places.Length).Where(k => k % Stride == 0 || k == Places.Length - 1)];
        Lowest = Places.Min(place => place.y);
        Highest = Places.Max(place => place.y);
        double apart = s_Steps.FirstOrDefault(seconds => Times[^1] - Times[0] < (k_MostMarks + 1) * seconds, 3600);
        Marks = [.. Enumerable.Range(1, k_MostMarks).Select(k => k * apart).Where(time => time < Times[^1] - 0.25 * apart)
            .Select(time => (Array.FindIndex(Times, at => at >= time - 1e-6), time))];
    }

    /// <summary>[moment] Centre of mass, metres.</summary>
    public float3[] Places { get; }

    /// <summary>[moment] The same over a beat around, metres.</summary>
    public float3[] Means { get; }

    /// <summary>[moment] Seconds.</summary>
    public double[] Times { get; }

    /// <summary>[moment] Metres flown over the ground, without the bob.</summary>
    public float[] Distances { get; }

    /// <summary>Moments that are drawn: all, or some of many.</summary>
    public int[] Points { get; }

    /// <summary>Round times and their moments.</summary>
    public IReadOnlyList<(int Moment, double Time)> Marks { get; }

    /// <summary>Metres.</summary>
    public float Lowest { get; }

    /// <summary>Metres.</summary>
    public float Highest { get; }

    private int Stride => 1 + Places.Length / k_MostPoints;

    /// <summary>Place that is drawn of a moment: the bob too where every moment is drawn.</summary>
    public float3 Drawn(int moment) => Stride == 1 ? Places[moment] : Means[moment];

    /// <summary>Draws the way in the colours of its height.</summary>
    /// <param name="page">Where to.</param>
    /// <param name="onPage">Where a moment lies on the page.</param>
    /// <param name="thickness">Of the line.</param>
    public void Draw(PixelPage page, Func<int, float2> onPage, float thickness)
    {
        List<float2> stroke = [onPage(Points[0])];
        for (int k = 1; k < Points.Length; k++)
        {
            stroke.Add(onPage(Points[k]));
            if (k + 1 < Points.Length && Shade(Points[k + 1]) == Shade(Points[k]))
                continue;
            page.Stroke([.. stroke], ColourOf(Shade(Points[k]) / (float)k_Shades), thickness);
            stroke = [stroke[^1]];
        }
    }

    private int Shade(int moment) => (int)(k_Shades * (Means[moment].y - Lowest) / math.max(Highest - Lowest, 1e-6f));

    private static int ColourOf(float share)
    {
        float at = math.saturate(share) * (s_Heights.Length - 1);
        int stop = math.min((int)at, s_Heights.Length - 2);
        var colour = (int3)math.round(255f * math.lerp(s_Heights[stop], s_Heights[stop + 1], at - stop));
        return (colour.x << 16) | (colour.y << 8) | colour.z;
    }

    // Over as many places before as behind, fewer at the ends.
    private static float3[] MeansOf(float3[] places, int half)
    {
        var means = new float3[places.Length];
        for (int k = 0; k < places.Length; k++)
        {
            int reach = Math.Min(Math.Max(half, 0), Math.Min(k, places.Length - 1 - k));
            float3 sum = 0f;
            for (int other = k - reach; other <= k + reach; other++)
                sum += places[other];
            means[k] = sum / (2 * reach + 1);
        }

        return means;
    }
}
