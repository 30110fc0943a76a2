namespace Alate.Cli;

/// <summary>A way from above, ahead up: coloured by its height, with start, end, direction and times, and a few insects along it.</summary>
internal sealed class PathMap
{
    private const int k_Ink = 0x3d3a34, k_Insects = 3;

    /// <summary>Room for insects and words around the way, and reach of an insect, units of the page.</summary>
    private const float k_Inset = 56f, k_Reach = 44f;

    private readonly FreeRecord m_Flight;
    private readonly FlownWay m_Way;
    private readonly float2 m_Corner, m_Size, m_Middle;
    private readonly float m_Scale, m_Reach;
    private readonly List<(float2 Min, float2 Max)> m_Taken = [];
    private readonly List<float2> m_Marked = [];

    /// <param name="flight">What was flown.</param>
    /// <param name="way">Its way.</param>
    /// <param name="corner">Upper left one, units of the page.</param>
    /// <param name="size">Units of the page.</param>
    public PathMap(FreeRecord flight, FlownWay way, float2 corner, float2 size)
    {
        (m_Flight, m_Way, m_Corner, m_Size) = (flight, way, corner, size);
        m_Reach = FlightPhoto.Reach(flight.Beat);
        float2 min = way.Places.Aggregate(new float2(float.PositiveInfinity), (least, place) => math.min(least, place.xz)),
            max = way.Places.Aggregate(new float2(float.NegativeInfinity), (most, place) => math.max(most, place.xz));
        float2 span = math.max(max - min, 2.5f * m_Reach);
        m_Scale = math.cmin((size - 2f * k_Inset) / span);
        m_Middle = 0.5f * (min + max);
        Factor = math.max(1f, k_Reach / (m_Scale * m_Reach));
    }

    /// <summary>Size of the drawn insects over that of their way.</summary>
    public float Factor { get; }

    /// <summary>Draws it.</summary>
    public void Draw(PixelPage page)
    {
        int[] middles = Middles();
        int[] flown = [.. Enumerable.Range(0, Math.Min(k_Insects, middles.Length))
            .Select(k => middles[(int)((k + 0.5f) / Math.Min(k_Insects, middles.Length) * middles.Length)])];
        DrawInsects(page, flown);
        m_Way.Draw(page, moment => OnPage(m_Way.Drawn(moment)), 2.4f);
        DrawEnds(page);
        if (IsLarger)
        {
            foreach ((int moment, double time) in m_Way.Marks)
                DrawMark(page, moment, time);
            foreach (int moment in middles.Except(flown))
                DrawArrow(page, moment);
        }

        ScaleBar.Draw(page, new float2(m_Corner.x, m_Corner.y + m_Size.y), m_Scale, m_Size.x);
    }

    // A way that an insect of its true size would cover has neither times nor directions.
    private bool IsLarger => Factor > 1f;

    // Between the marks of time: there insects or arrows have room.
    private int[] Middles()
    {
        if (!IsLarger)
            return [(m_Way.Places.Length - 1) / 2];
        int[] marks = [0, .. m_Way.Marks.Select(mark => mark.Moment), m_Way.Places.Length - 1];
        return [.. marks.Zip(marks.Skip(1), (before, behind) => (before + behind) / 2)];
    }

    private float2 OnPage(float3 place) =>
        m_Corner + 0.5f * m_Size + m_Scale * new float2(1f, -1f) * (place.xz - m_Middle);

    // But for those that would lie upon each other.
    private void DrawInsects(PixelPage page, int[] moments)
    {
        PhotoScene scene = FlightPhoto.Scene(m_Flight.Beat, PictureView.ByName["top"]);
        var drawn = new List<float2>();
        float reach = Factor * m_Scale * m_Reach, side = 2.6f * reach;
        foreach (int moment in moments)
        {
            FreeMoment at = m_Flight.Moments[moment];
            float2 place = OnPage(m_Flight.Thorax(at));
            if (drawn.Any(other => math.distance(other, place) < 2f * reach))
                continue;
            drawn.Add(place);
            if (IsLarger)
                m_Taken.Add((place - 0.5f * reach, place + 0.5f * reach));
            page.Add(scene, scene.PoseAt(at.Phase / (2.0 * Math.PI), at.Rotation, float3.zero),
                new StripPanel(place.x - 0.5f * side, place.y - 0.5f * side, side, side, Factor * m_Scale, float2.zero));
        }
    }

    private void DrawMark(PixelPage page, int moment, double time)
    {
        float2 place = OnPage(m_Way.Drawn(moment)), aside = Aside(moment);
        if (!HasRoom(place))
            return;
        page.Stroke([place - 5f * aside, place + 5f * aside], k_Ink, 1.4f);
        Label(page, place, aside, string.Create(CultureInfo.InvariantCulture, $"{time:0.##} s"));
    }

    // Where an insect lingers, its marks would be a heap.
    private bool HasRoom(float2 place)
    {
        const float k_Room = 16f;
        if (m_Marked.Any(other => math.distance(other, place) < k_Room))
            return false;
        m_Marked.Add(place);
        return true;
    }

    private void DrawArrow(PixelPage page, int moment)
    {
        float2 place = OnPage(m_Way.Drawn(moment)), aside = Aside(moment), ahead = new(aside.y, -aside.x), tip = place + 4f * ahead;
        if (!HasRoom(place))
            return;
        page.Stroke([tip - 8f * ahead + 5f * aside, tip, tip - 8f * ahead - 5f * aside], k_Ink, 1.4f);
    }

    // A ring where it starts, a square where it ends.
    private void DrawEnds(PixelPage page)
    {
        float2 start = OnPage(m_Way.Drawn(0)), end = OnPage(m_Way.Drawn(m_Way.Places.Length - 1));
        page.Ring(start, 6f, k_Ink, 1.6f);
        page.Stroke([end + new float2(-5f, -5f), end + new float2(5f, -5f), end + 5f, end + new float2(-5f, 5f), end - 5f], k_Ink, 1.6f);
        m_Marked.AddRange([start, end]);
        bool isOne = math.distance(start, end) < 40f;
        Label(page, start, Aside(0), isOne ? "start, end" : "start");
        if (!isOne)
            Label(page, end, Aside(m_Way.Places.Length - 1), "end");
    }

    // Beside the way, on the side and at the distance where nothing is yet.
    private void Label(PixelPage page, float2 place, float2 aside, string text)
    {
        const float k_Size = 13f;
        float width = Lettering.Width(text, k_Size);
        foreach (float away in new[] { 13f, -13f, 30f, -30f, 46f, -46f })
        {
            float2 beside = place + away * aside, direction = Math.Sign(away) * aside;
            float left = beside.x - (direction.x > 0.35f ? 0f : direction.x < -0.35f ? 1f : 0.5f) * width;
            float line = beside.y + (direction.y > 0.35f ? 0.72f : direction.y < -0.35f ? 0f : 0.36f) * k_Size;
            (float2 min, float2 max) = (new float2(left - 3f, line - k_Size), new float2(left + width + 3f, line + 4f));
            if (m_Taken.Any(other => math.all(min < other.Max) && math.all(max > other.Min)))
                continue;
            m_Taken.Add((min, max));
            page.Text(left, line, k_Size, text);
            return;
        }
    }

    // Unit vector to the right of the way.
    private float2 Aside(int moment)
    {
        int before = Math.Max(0, moment - 1), behind = Math.Min(m_Way.Means.Length - 1, moment + 1);
        float2 ahead = OnPage(m_Way.Means[behind]) - OnPage(m_Way.Means[before]);
        return math.normalizesafe(new float2(-ahead.y, ahead.x), new float2(1f, 0f));
    }
}
