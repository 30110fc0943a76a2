using System.CommandLine;
using Alate.Wake;

namespace Alate.Cli;

/// <summary>The options of <c>wake</c> besides those of the flight.</summary>
internal sealed class WakeOptions
{
    private readonly Option<WakeMethod?> m_Method = Choice.Optional<WakeMethod>(
        "--method", "Where the circulation comes from: the lift coefficients, or wings that no air crosses. [default: strips]", new()
        {
            ["strips"] = WakeMethod.Strips,
            ["panels"] = WakeMethod.Panels,
        });

    private readonly Option<MeasuredDownwash?> m_Downwash = Choice.Optional<MeasuredDownwash>(
        "--downwash", "The wake that the coefficients of strips hold and that is taken out of them. [default: angle]", new()
        {
            ["angle"] = MeasuredDownwash.Angle,
            ["revolving"] = MeasuredDownwash.RevolvingWing,
            ["none"] = MeasuredDownwash.None,
        });

    private readonly Option<int?> m_Beats = Numbers.OptionalCount(
        "--beats", "N", 1, 50, "Beats from rest; the last one is written. [default: 3]");

    private readonly Option<int?> m_Rounds = Numbers.OptionalCount(
        "--rounds", "N", 1, 20, "Flights, each with the air of the wakes before it replayed at the wings. [default: 1]");

    private readonly Option<int?> m_Steps = Numbers.OptionalCount("--steps", "N", 4, 1000, "Steps of a beat. [default: 24]");

    private readonly Option<int?> m_Across = Numbers.OptionalCount(
        "--chord-panels", "N", 1, 64, "Panels along the chord, with --method panels. [default: 4]");

    private readonly Option<int?> m_Along = Numbers.OptionalCount(
        "--span-panels", "N", 1, 256, "Panels or strips along the span. [default: 10]");

    private readonly Option<double?> m_Keep = Numbers.Optional(
        "--keep", "BEATS", 0.1, 50, "Age at which wake is dropped, beats. [default: 2]");

    private readonly Option<bool> m_WideCores = new("--wide-cores")
    {
        Description = "Vortex cores as wide as a chord: the wake of an insect that hovers is then the same in each beat.",
    };

    private readonly Option<double?> m_Ground = Numbers.Optional(
        "--ground", "M", 0.001, 1000, "Height of the thorax above a ground, metres. [default: no ground]");

    private readonly Option<double?> m_Plane = Numbers.Optional(
        "--plane", "M", 0, 1000, "Distance of the plane of plane.csv behind the thorax, metres. [default: the length of a wing]");

    private readonly Option<bool> m_Free =
        new("--free") { Description = "The variant flight, with the beat and the pitch that carry it at --speed and --climb." };

    private readonly Option<bool> m_NoPictures =
        new("--no-pictures") { Description = "Neither the plane, span.svg, wake.png nor wake.glb: for many runs one after the other." };

    public void AddTo(Command command)
    {
        Option[] all =
        [
            m_Free, m_Method, m_Downwash, m_Beats, m_Rounds, m_Steps, m_Across, m_Along, m_Keep, m_WideCores, m_Ground, m_Plane,
            m_NoPictures,
        ];
        foreach (Option option in all)
            command.Options.Add(option);
    }

    /// <summary>Returns true where the insect is to fly by its trim.</summary>
    public bool IsFree(ParseResult parsed) => parsed.GetValue(m_Free);

    /// <summary>Makes the plan that the user asked for.</summary>
    /// <exception cref="UserException">Options that exclude each other.</exception>
    public WakePlan Plan(ParseResult parsed)
    {
        WakeMethod method = parsed.GetValue(m_Method) ?? WakeMethod.Strips;
        if (method == WakeMethod.Strips && parsed.GetValue(m_Across) is > 1)
            throw new UserException("--chord-panels goes with --method panels: a strip has one ring.");
        if (method == WakeMethod.Panels && parsed.GetValue(m_Downwash) != null)
            throw new UserException("--downwash goes with --method strips: panels use no coefficients.");
        var usual = new WakePlan();
        return new WakePlan
        {
            Method = method,
            IsFree = IsFree(parsed),
            Downwash = parsed.GetValue(m_Downwash) ?? usual.Downwash,
            Beats = parsed.GetValue(m_Beats) ?? usual.Beats,
            Rounds = parsed.GetValue(m_Rounds) ?? usual.Rounds,
            StepsPerBeat = parsed.GetValue(m_Steps) ?? usual.StepsPerBeat,
            ChordPanels = parsed.GetValue(m_Across),
            SpanPanels = parsed.GetValue(m_Along) ?? usual.SpanPanels,
            Keep = parsed.GetValue(m_Keep) ?? usual.Keep,
            HasWideCores = parsed.GetValue(m_WideCores),
            Ground = parsed.GetValue(m_Ground),
            Plane = parsed.GetValue(m_Plane),
            IsDrawn = !parsed.GetValue(m_NoPictures),
        };
    }
}
