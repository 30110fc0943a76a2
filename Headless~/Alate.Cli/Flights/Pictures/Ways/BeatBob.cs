namespace Alate.Cli;

/// <summary>
/// Way of the body over one beat beside its mean flight, seen from its left: two harmonics of the beats in the flight's middle.
/// </summary>
internal static class BeatBob
{
    private const int k_Beats = 8, k_Harmonics = 2, k_Points = 73, k_Ink = 0x3d3a34, k_Line = 0x8a5a2b;

    /// <summary>Returns ahead and up from the mean flight, metres, from phase 0 to 1; nothing of a flight of less than two beats.</summary>
    public static float2[] Loop(FreeRecord flight, FlownWay way)
    {
        IReadOnlyList<FreeMoment> moments = flight.Moments;
        int middle = moments.Count / 2;
        double step = (way.Times[^1] - way.Times[0]) / Math.Max(1, moments.Count - 1), beat = 1.0 / moments[middle].Frequency;
        int half = Math.Min((int)Math.Round(0.5 * k_Beats * beat / step), middle - (int)Math.Ceiling(0.5 * beat / step));
        if (half * step < beat)
            return [];
        float3 nose = math.rotate(moments[middle].Rotation, new float3(0f, 0f, 1f));
        float2 ahead = math.normalizesafe(nose.xz, new float2(0f, 1f));
        FreeMoment[] taken = [.. moments.Skip(middle - half).Take(2 * half)];
        float2[] off = [.. taken.Select((_, k) => Off(middle - half + k))];
        return [.. Enumerable.Range(0, k_Points).Select(k => At(2.0 * Math.PI * k / (k_Points - 1)))];

        float2 Off(int moment)
        {
            float3 away = way.Places[moment] - way.Means[moment];
            return new float2(math.dot(away.xz, ahead), away.y);
        }

        float2 At(double phase)
        {
            float2 sum = 0f;
            for (int k = 0; k < taken.Length; k++)
            {
                for (int harmonic = 1; harmonic <= k_Harmonics; harmonic++)
                    sum += 2f / taken.Length * (float)Math.Cos(harmonic * (phase - taken[k].Phase)) * off[k];
            }

            return sum;
        }
    }

    /// <param name="page">Where to.</param>
    /// <param name="flight">What was flown.</param>
    /// <param name="way">Its way.</param>
    /// <param name="corner">Upper left one, units of the page.</param>
    /// <param name="size">Units of the page.</param>
    public static void Draw(PixelPage page, FreeRecord flight, FlownWay way, float2 corner, float2 size)
    {
        float2[] loop = Loop(flight, way);
        if (loop.Length == 0)
            return;
        float2 min = loop.Aggregate(math.min), max = loop.Aggregate(math.max), span = max - min;
        float scale = math.cmin(size * new float2(0.8f, 0.62f) / math.max(span, 1e-6f));

        // It looks to the left, as the side view of the insect does.
        float2[] drawn = Array.ConvertAll(
            loop, place => corner + size * new float2(0.5f, 0.5f) - scale * (place - 0.5f * (min + max)));
        page.Text(corner.x, corner.y - 14f, 13f, "One beat beside the mean flight", look: "t");
        page.Stroke(drawn, k_Line, 2f);
        page.Ring(drawn[0], 4f, k_Ink, 1.4f);
        page.Text(corner.x, corner.y + size.y, 12f, string.Create(
            CultureInfo.InvariantCulture, $"{1e3f * span.y:0.0} mm up and down, {1e3f * span.x:0.0} along"));
        page.Text(corner.x, corner.y + size.y + 18f, 12f, "ring: the downstroke begins", look: "t");
    }
}
