using Alate.Wake;

namespace Alate.Cli;

/// <summary>Free wake by strips behind wings that are told moment by moment; the worker's part of a live wake.</summary>
internal sealed class WakeStepper : IDisposable
{
    /// <summary>Age at which a row is dropped, beats, and radius of an old core, chords, with which the wake rolls up into tubes.</summary>
    private const float k_Keep = 1.5f, k_FarCore = 0.8f;

    private readonly int m_Beat, m_Panels;
    private readonly bool m_IsSymmetric;
    private readonly double m_Density;
    private readonly ModelOptions[] m_Options;
    private readonly FlownWing[] m_Motions;
    private FreeWake m_Wake;
    private bool m_Fails;

    /// <param name="wings">Wings that are computed.</param>
    /// <param name="beat">Steps of a beat.</param>
    /// <param name="panels">Strips along the span.</param>
    /// <param name="isSymmetric">True where the wings are right ones, and left ones their mirror images.</param>
    public WakeStepper(IReadOnlyList<RecordedWing> wings, int beat, int panels, bool isSymmetric)
    {
        (m_Beat, m_Panels, m_IsSymmetric) = (beat, panels, isSymmetric);
        Length = wings.Max(wing => wing.Placement.Length);
        m_Density = wings[0].Wing.Preset.Size.fluidDensity;
        m_Options = [.. wings.Select(wing => wing.Parameters.options)];
        m_Motions = [.. wings.Select(_ => new FlownWing(beat, WakeGrid.Edges, panels + 1))];
    }

    /// <summary>Metres of the wake's unit of length.</summary>
    public float Length { get; }

    /// <summary>The wake; null before its first step.</summary>
    public FreeWake Wake => m_Wake;

    /// <summary>Most rows of points of a sheet.</summary>
    public static int Rows(int beat) => (int)MathF.Ceiling(k_Keep * beat) + 1;

    /// <summary>Drops the wake: the next moments are those of another flight.</summary>
    public void Restart()
    {
        m_Wake?.Dispose();
        (m_Wake, m_Fails) = (null, false);
        foreach (FlownWing motion in m_Motions)
            motion.Restart();
    }

    /// <summary>Takes the next moment, and does its step.</summary>
    /// <param name="places">[wing · places + place] Axes of the body, metres.</param>
    /// <param name="pace">Beat and air.</param>
    /// <returns>False where it is too early for a step, or the wings cannot shed a wake.</returns>
    public bool Step(ReadOnlySpan<float3> places, in WakePace pace)
    {
        int stride = places.Length / m_Motions.Length;
        for (int wing = 0; wing < m_Motions.Length; wing++)
            m_Motions[wing].Move(places.Slice(wing * stride, stride), 1f / Length);
        if (!m_Motions[0].IsKnown || m_Fails)
            return false;
        try
        {
            m_Wake ??= Make(pace);
            m_Wake.Step();
        }
        catch (ArgumentException)
        {
            // A flight in which a wing has folded up to nothing, or is so slow that its air is beyond all bounds, goes on without a wake.
            m_Fails = true;
        }

        return !m_Fails;
    }

    public void Dispose() => Restart();

    private FreeWake Make(in WakePace pace)
    {
        float period = pace.Period;
        var settings = new WakeSettings
        {
            SpanPanels = m_Panels,
            StepsPerBeat = m_Beat,
            Keep = k_Keep,
            FarCore = k_FarCore,
            Symmetric = m_IsSymmetric,
            Stream = pace.Air * (period / Length),
            Viscosity = (float)(WakeFluid.ViscosityOf((float)m_Density) * period / (Length * Length)),
            OnOneThread = true,
        };
        return new FreeWake(settings, m_Motions.Select((motion, k) => new WakeWing(motion, m_Options[k])).ToList());
    }
}
