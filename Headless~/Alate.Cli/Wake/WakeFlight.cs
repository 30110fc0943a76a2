using Alate.Wake;

namespace Alate.Cli;

/// <summary>Wake behind the recorded beat of a flight, in metres, seconds and newtons; axes of the body.</summary>
internal sealed class WakeFlight : IDisposable
{
    private readonly FreeWake m_Wake;
    private readonly double m_Density;

    /// <summary>Lays lattices on the wings; nothing has been shed yet.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="plan">The wake.</param>
    /// <param name="isShown">True to keep the rings and the air of the last beat, which takes memory and time.</param>
    /// <exception cref="UserException">A number of the plan is out of its range, or a wing has no area.</exception>
    public WakeFlight(FlightRecord flight, WakePlan plan, bool isShown = false)
    {
        Flight = flight;
        Plan = plan;
        Length = flight.Wings.Max(wing => wing.Wing.Preset.WingLength);
        Period = 1.0 / flight.Wings[0].Frequency;
        Plane = isShown ? new WakePlane(flight.Plan, plan.Plane ?? Length, Length, Period) : null;
        m_Density = plan.Density ?? flight.Wings[0].Wing.Preset.Size.fluidDensity;
        float3 air = flight.Plan.AirInBodyAxes;
        IsSymmetric = air.x == 0f;
        Wings = flight.Wings.Where(wing => !IsSymmetric || !wing.Placement.IsLeft).ToList();
        var settings = new WakeSettings(plan.Method)
        {
            SpanPanels = plan.SpanPanels,
            StepsPerBeat = plan.StepsPerBeat,
            Keep = (float)plan.Keep,
            Symmetric = IsSymmetric,
            Stream = air * (float)(Period / Length),
            Viscosity = (float)(WakeFluid.ViscosityOf((float)m_Density) * Period / (Length * Length)),
            Up = flight.Plan.UpOfBody,
        };
        settings.ChordPanels = plan.ChordPanels ?? settings.ChordPanels;
        if (plan.HasWideCores)
            settings.WidenCores();
        else
            settings.FarCore = (float)(plan.FarCore ?? settings.FarCore);
        settings.GroundHeight = plan.Ground is double height ? (float)(height / Length) : settings.GroundHeight;
        List<WakeWing> wings = Wings.ConvertAll(WingOf);
        if (plan.Ground is double ground && ground <= Below)
        {
            throw new UserException(string.Create(CultureInfo.InvariantCulture,
                $"--ground {ground}: the wings reach {Below:0.####} m below the thorax; allowed: above {Below:0.####} m."));
        }

        if (IsSymmetric && Across > k_MostAcross * Length)
        {
            throw new UserException(string.Create(CultureInfo.InvariantCulture,
                $"Right and left wings pass through each other, by up to {1000 * Across:0.#} mm each; a wake takes up to ")
                + string.Create(CultureInfo.InvariantCulture, $"{1000 * k_MostAcross * Length:0.#} mm."));
        }

        try
        {
            m_Wake = new FreeWake(settings, wings);
        }
        catch (ArgumentException problem)
        {
            throw new UserException(problem.Message);
        }
    }

    /// <summary>
    /// Steps of a beat, and radius of an old core in chords, with which a wake rolls up into smooth tubes; its loads are the same.
    /// </summary>
    private const int k_SmoothSteps = 40;
    private const double k_SmoothCore = 0.8;

    /// <summary>Most panels along the span, and oldest wake in beats, that are shown: files stay of some megabytes.</summary>
    private const int k_MostShown = 24;
    private const double k_OldestShown = 3.0;

    /// <summary>
    /// Shares of a wing's length by which right and left wings pass through each other where that is noted, and where no wake is computed:
    /// wings of the model do not feel each other.
    /// </summary>
    private const double k_Touch = 0.03, k_MostAcross = 0.1;

    public FlightRecord Flight { get; }
    public WakePlan Plan { get; }

    /// <summary>Metres of the wake's unit of length.</summary>
    public double Length { get; }

    /// <summary>Seconds of a beat.</summary>
    public double Period { get; }

    /// <summary>True where right wings alone are computed, as left ones are their mirror images.</summary>
    public bool IsSymmetric { get; }

    /// <summary>Metres below the middle of the thorax that the wings reach in the beat.</summary>
    public double Below { get; private set; }

    /// <summary>Metres beyond the middle plane that right wings reach, where left ones are their mirror images.</summary>
    public double Across { get; private set; }

    /// <summary>Lines on what the wake cannot be trusted with; none as a rule.</summary>
    public IEnumerable<string> Doubts()
    {
        if (IsSymmetric && Across > k_Touch * Length)
        {
            yield return string.Create(CultureInfo.InvariantCulture,
                $"Right and left wings pass through each other, by up to {1000 * Across:0.#} mm each; their air is not known then.");
        }

        if (m_Wake.Failures > 0)
            yield return $"In {m_Wake.Failures} of {m_Wake.StepCount} steps the wings found no circulation that fits.";
    }

    /// <summary>Wings with a lattice.</summary>
    public List<RecordedWing> Wings { get; }

    public FreeWake Wake => m_Wake;

    /// <summary>
    /// [step of the last beat] Sheets of all wings, of left ones too where right ones alone are computed; none where they are not shown.
    /// </summary>
    public List<List<ShapedSheet>> Shapes { get; } = [];

    /// <summary>Air behind the insect over the last beat; null where it is not shown.</summary>
    public WakePlane Plane { get; }

    /// <summary>Frees the memory.</summary>
    public void Dispose() => m_Wake.Dispose();

    /// <summary>Sheds the wake of a flight as pictures show it: in fine steps, with wide cores.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="plan">The wake, whose steps and cores are not taken.</param>
    /// <param name="frames">Moments of a beat that the steps must meet.</param>
    public static WakeFlight Smooth(FlightRecord flight, WakePlan plan, int frames = 1)
    {
        int steps = (k_SmoothSteps + frames - 1) / frames * frames;
        var smooth = new WakeFlight(flight, plan with
        {
            StepsPerBeat = steps,
            FarCore = k_SmoothCore,
            SpanPanels = Math.Min(plan.SpanPanels, k_MostShown),
            Keep = Math.Min(plan.Keep, k_OldestShown),
        }, isShown: true);
        smooth.Run(_ => { });
        return smooth;
    }

    /// <summary>Flies all beats, and returns the loads of the last one.</summary>
    /// <param name="progress">Told the steps done so far.</param>
    public List<WakeMoment> Run(Action<int> progress)
    {
        var moments = new List<WakeMoment>();
        int steps = Plan.Beats * Plan.StepsPerBeat;
        for (int k = 0; k < steps; k++)
        {
            double time = m_Wake.Time;
            m_Wake.Step();
            if (k >= steps - Plan.StepsPerBeat)
            {
                moments.Add(Moment(time - (Plan.Beats - 1)));
                if (Plane != null)
                {
                    Shapes.Add(Shape());
                    Plane.Add(m_Wake);
                }
            }

            progress(k + 1);
        }

        return moments;
    }

    private WakeMoment Moment(double turns)
    {
        double force = m_Density * Math.Pow(Length, 4) / (Period * Period), power = force * Length / Period, speed = Length / Period;
        return new WakeMoment(turns, Enumerable.Range(0, m_Wake.WingCount).Select(k =>
        {
            WakeLoads loads = m_Wake.Loads(k);
            return new WakeLoad((float)force * loads.Force, (float)(force * Length) * loads.Moment, power * loads.Power,
                (float)speed * loads.Inflow, Strips(k, force, speed));
        }).ToList(), IsSymmetric);
    }

    private WakeStrip[] Strips(int wing, double force, double speed)
    {
        // Lattices of panels end short of the tip: their strips are narrower than the wing's length over their number.
        double share = m_Wake.SectionCount > 1 ? m_Wake.Section(wing, 1).Span - m_Wake.Section(wing, 0).Span : 1.0;
        double width = share * Wings[wing].Wing.Preset.WingLength, side = Wings[wing].Placement.IsLeft ? 1 : -1;
        return [.. Enumerable.Range(0, m_Wake.SectionCount).Select(strip => m_Wake.Section(wing, strip)).Select(at => new WakeStrip(
            at.Span, side * speed * Length * at.Circulation, (float)(force / width) * at.Force, (float)speed * at.Inflow))];
    }

    private List<ShapedSheet> Shape()
    {
        List<ShapedSheet> sheets =
            [.. Wings.Select((wing, k) => ShapedSheet.Of(m_Wake.Sheet(k), Length, Period, wing.Placement.IsLeft))];
        return IsSymmetric ? [.. sheets, .. sheets.Select(sheet => sheet.Mirrored())] : sheets;
    }

    private WakeWing WingOf(RecordedWing wing)
    {
        int kind = Flight.Wings.ToList().IndexOf(wing) / 2;
        float chords = (float)(Plan.Chords?[kind] ?? 1.0);
        var grid = new SurfaceGrid(wing.Rest, wing.Triangles);
        float3[][] samples = wing.Frames.Select(frame => Places(wing, grid, frame, chords)).ToArray();
        float3 up = Flight.Plan.UpOfBody;
        Below = Math.Max(Below, -Length * samples.Min(places => places.Min(place => math.dot(place, up))));
        Across = Math.Max(Across, -Length * samples.Min(places => places.Min(place => place.x)));
        return new WakeWing(
            FourierMotion.Through(samples, grid.Across, grid.Along, wing.Frames[0].Phase / (2.0 * Math.PI)), wing.Parameters.options)
        {
            Downwash = Plan.Downwash,
        };
    }

    // Places of the grid in wake units, chords widened about their middles.
    private float3[] Places(RecordedWing wing, SurfaceGrid grid, RecordedFrame frame, float chords)
    {
        // The preset's length, which a flight of published sizes changes.
        WingMount mount = wing.Placement with { Length = wing.Wing.Preset.WingLength };
        float3[] places = Array.ConvertAll(grid.Evaluate(frame.Positions), place => mount.ToBody(place) / (float)Length);
        int last = (grid.Across - 1) * grid.Along;
        for (int k = 0; k < grid.Along && chords != 1f; k++)
        {
            float3 middle = 0.5f * (places[k] + places[last + k]);
            for (int i = 0; i < grid.Across; i++)
                places[i * grid.Along + k] = middle + chords * (places[i * grid.Along + k] - middle);
        }

        return places;
    }
}
