using UnityEngine;

namespace Alate.Cli;

/// <summary>Frames of a film, all of one scale; of a beat on the spot the last goes on into the first.</summary>
internal sealed class Film
{
    private const float k_Inset = 14f, k_Label = 34f, k_FlattestOverWidth = 0.45f;

    private readonly FilmPlan m_Plan;
    private readonly List<FlightRecord> m_Flights;
    private readonly Func<int, FilmMoment> m_At;
    private readonly WakePhoto m_Wake;

    private Film(FilmPlan plan, List<FlightRecord> flights, Func<int, FilmMoment> at, WakePhoto wake = null)
    {
        m_Plan = plan;
        m_Flights = flights;
        m_At = at;
        m_Wake = wake;
    }

    public int Count => m_Plan.Beats * m_Plan.Frames;

    /// <summary>Pixels of a frame.</summary>
    public int2 Size { get; private set; }

    /// <summary>Flies what the film shows.</summary>
    /// <exception cref="UserException">The insect does not fly.</exception>
    public static Film Fly(FilmPlan plan)
    {
        if (plan.IsFree)
        {
            var stretch = FreeStretch.Fly(plan);
            return new Film(plan, [stretch.Beat], stretch.At);
        }

        var flights = plan.Columns.Select(column => TetheredFlight.Fly(plan.Flight with { Column = column })).ToList();
        return new Film(
            plan, flights, frame => new FilmMoment((double)frame % plan.Frames / plan.Frames, quaternion.identity, float3.zero, []),
            plan.HasWake ? Shed(flights[0], plan.Frames) : null);
    }

    // With a step at each frame.
    private static WakePhoto Shed(FlightRecord flight, int frames)
    {
        using var wake = WakeFlight.Smooth(flight, new WakePlan(), frames);
        return new WakePhoto(wake);
    }

    /// <summary>Paints every frame.</summary>
    /// <param name="done">Told the frames done.</param>
    public Color32[][] Draw(Action<int> done)
    {
        List<PhotoScene> scenes = m_Flights.ConvertAll(flight => FlightPhoto.Scene(flight, m_Plan.Flight.View));
        var frames = new List<List<(PhotoScene Scene, Pose Pose)>>();
        for (int frame = 0; frame < Count; frame++)
        {
            FilmMoment at = m_At(frame);
            PictureView view = m_Plan.Flight.View with { Aside = (float)(m_Plan.Flight.View.Aside + m_Plan.Turn * frame / Count) };
            frames.Add(scenes.ConvertAll(scene =>
            {
                PhotoScene seen = m_Wake == null ? scene.From(view) : m_Wake.AddTo(scene.From(view), at.Turns);
                return (seen, seen.PoseAt(at.Turns, at.Turn, at.Way, at.Trail));
            }));
        }

        List<StripPanel> panels = Panels(frames.SelectMany(frame => frame).Select(seen => seen.Pose.Bounds()).ToList());
        return Concurrently.Map(frames, SampleGrid.BytesOf(Size), frame =>
        {
            if (m_Plan.Backdrop is { } look)
                return Before(look, frame[0].Scene, frame[0].Pose, panels[0]);
            if (m_Plan.IsTransparent)
                return frame[0].Scene.Draw(frame[0].Pose, panels[0], PixelPage.Fineness, hasPaper: false);
            var page = new PixelPage();
            for (int k = 0; k < frame.Count; k++)
            {
                page.Add(frame[k].Scene, frame[k].Pose, panels[k]);
                if (frame.Count > 1)
                    page.Text(panels[k].Left + 0.5f * panels[k].Width, 24f, 15f, m_Plan.Columns[k].Title, "middle", "b");
            }

            return page.Draw(Size);
        }, done);
    }

    /// <summary>The film as an animated PNG file.</summary>
    public byte[] Animation(IReadOnlyList<Color32[]> frames)
    {
        FlightRecord flight = m_Flights[0];
        double slow = flight.Wings[0].Frequency * m_Plan.Frames / m_Plan.Rate;
        string title = FormattableString.Invariant(
            $"{flight.Insect.DisplayName}, {slow:0.#} times slower than it beats: {flight.Wings[0].Frequency:0.#} Hz");
        string[] texts = [title, .. m_Plan.Columns.Count > 1 ? m_Plan.Columns.Select(column => column.Title) : []];
        // The 255 colours of an indexed film would show as rings on a wall.
        return m_Plan.IsTransparent || m_Plan.Backdrop != null
            ? TrueColourPng.WriteFilm(Size.x, Size.y, frames, m_Plan.Rate, !m_Plan.IsFree, texts, m_Plan.IsTransparent)
            : IndexedPng.Write(Size.x, Size.y, frames, m_Plan.Rate, !m_Plan.IsFree, texts);
    }

    /// <summary>Sound of the last column, as long as the film.</summary>
    public float[] Sound() => BeatSound.Of(
        m_Flights[^1], m_Plan.IsSoundSlow ? (double)m_Plan.Rate / m_Plan.Frames : m_Flights[^1].Wings[0].Frequency,
        (double)Count / m_Plan.Rate);

    private Color32[] Before(BackdropLook look, PhotoScene scene, Pose pose, StripPanel panel)
    {
        var wall = new Backdrop(look, Size);
        wall.Shade(scene, pose, panel, PixelPage.Fineness, 0);
        wall.Lay(scene.Draw(pose, panel, PixelPage.Fineness, hasPaper: false), PhotoScene.SizeOf(panel, PixelPage.Fineness), 0);
        return wall.Pixels();
    }

    // One for each column, all of one scale.
    private List<StripPanel> Panels(List<(float2 Min, float2 Max)> bounds)
    {
        float2 min = bounds.Aggregate(bounds[0].Min, (least, one) => math.min(least, one.Min)),
            max = bounds.Aggregate(bounds[0].Max, (most, one) => math.max(most, one.Max));
        float top = m_Flights.Count > 1 ? k_Label : 0f, width = m_Plan.Width / PixelPage.Fineness / m_Flights.Count,
            scale = (width - 2f * k_Inset) / (max.x - min.x);
        float height = math.max((max.y - min.y) * scale + 2f * k_Inset, m_Flights.Count > 1 ? 0f : k_FlattestOverWidth * width);
        Size = new int2(m_Plan.Width, (int)math.ceil((top + height) * PixelPage.Fineness));
        return Enumerable.Range(0, m_Flights.Count)
            .Select(k => new StripPanel(k * width, top, width, height, scale, 0.5f * (min + max))).ToList();
    }
}
