namespace Alate.Drawing;

/// <summary>A pen with a round tip on a picture of pixels.</summary>
internal static class Pen
{
    /// <summary>
    /// Pixels that a stroke covers, by their numbers, with the share of each, by the distance of its middle from the stroke.
    /// </summary>
    /// <param name="size">Pixels of the picture.</param>
    /// <param name="points">The stroke, pixels from the upper left.</param>
    /// <param name="pen">Half the width of the stroke, pixels.</param>
    public static Dictionary<int, float> Cover(int2 size, float2[] points, float pen)
    {
        var cover = new Dictionary<int, float>();
        for (int k = 0; k + 1 < points.Length; k++)
        {
            float2 from = points[k], to = points[k + 1], along = to - from;
            int2 low = math.max((int2)math.floor(math.min(from, to) - pen), 0),
                high = math.min((int2)math.ceil(math.max(from, to) + pen), size - 1);
            for (int y = low.y; y <= high.y; y++)
            {
                for (int x = low.x; x <= high.x; x++)
                {
                    float2 middle = new float2(x, y) + 0.5f;
                    float share = math.saturate(math.dot(middle - from, along) / math.max(math.lengthsq(along), 1e-12f));
                    float covered = math.saturate(pen + 0.5f - math.distance(middle, from + share * along));
                    if (covered > 0f)
                        cover[y * size.x + x] = math.max(cover.GetValueOrDefault(y * size.x + x), covered);
                }
            }
        }

        return cover;
    }
}
