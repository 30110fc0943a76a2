using System.Numerics;
using Alate.Wake;

namespace Alate.Cli;

/// <summary>
/// Stiff plate that heaves and pitches in a lattice of panels or strips: span along x, its leading edge ahead, which is +z; chord 1 unless
/// it has a shape.
/// </summary>
internal sealed class ThinWing : IWingMotion
{
    private const double k_Degree = Math.PI / 180;

    /// <summary>Chords of a span that stands for an endless one; a lattice of one strip is a third narrower.</summary>
    private const float k_Endless = 10000f;
    private const double k_Width = k_Endless / 1.5;

    /// <summary>Beats of a motion that has come to rest, and degrees of steady plates.</summary>
    private const int k_Beats = 6, k_Settled = 60;
    private const double k_Slope = 2 * k_Degree;

    /// <summary>Span, chords.</summary>
    public float Span { get; init; } = 1f;

    /// <summary>Place of the root.</summary>
    public float Root { get; init; }

    /// <summary>Distance ahead, chords.</summary>
    public float Ahead { get; init; }

    /// <summary>Share of the chord, from the leading edge, about which it pitches.</summary>
    public double Pivot { get; init; }

    /// <summary>Chord over the share of the span, about the middle of the largest one; null for 1.</summary>
    public Func<float, double> Chord { get; init; }

    /// <summary>Height and its rate; pitch nose up, radians, and its rate; over beats.</summary>
    public Func<double, (double Height, double Rise, double Pitch, double Turn)> Move { get; init; }

    /// <summary>A rectangle at a pitch, radians.</summary>
    public static ThinWing Steady(float span, double pitch) =>
        new() { Span = span, Root = -0.5f * span, Move = _ => (0.0, 0.0, pitch, 0.0) };

    /// <summary>An ellipse of that span and a chord of 1 in its middle, at the pitch of <see cref="Slope"/>.</summary>
    public static ThinWing Ellipse(float span) => new()
    {
        Span = span,
        Root = -0.5f * span,
        Pivot = 0.5,
        Chord = share => Math.Sqrt(Math.Max(0.0, 1.0 - (2.0 * share - 1.0) * (2.0 * share - 1.0))),
        Move = _ => (0.0, 0.0, k_Slope, 0.0),
    };

    /// <summary>Lift and mean thrust of a strip of unit width over the density, of a plate in two dimensions that beats.</summary>
    /// <param name="reduced">Reduced frequency, ωc/2U.</param>
    /// <param name="panels">Along the chord.</param>
    /// <param name="steps">Of a beat.</param>
    /// <param name="move">Height and its rate, pitch and its rate, over beats.</param>
    public static (Complex Lift, double Thrust) Oscillate(double reduced, int panels, int steps,
        Func<double, (double Height, double Rise, double Pitch, double Turn)> move)
    {
        WakeSettings settings = Panels(panels, 1, steps, k_Beats, (float)(-Math.PI / reduced));
        settings.SuctionAlongChord = true;
        using var wake = new FreeWake(
            settings, [new WakeWing(new ThinWing { Span = k_Endless, Root = -0.5f * k_Endless, Pivot = 0.25, Move = move })]);
        Complex lift = 0.0;
        double thrust = 0.0;
        for (int k = 0; k < k_Beats * steps; k++)
        {
            double time = wake.Time;
            wake.Step();
            if (k < (k_Beats - 1) * steps)
                continue;
            float3 force = wake.Loads(0).Force;
            lift += 2.0 * force.y * Complex.Exp(-2.0 * Math.PI * Complex.ImaginaryOne * time) / steps;
            thrust += force.z / (double)steps;
        }

        return (lift / k_Width, thrust / k_Width);
    }

    /// <summary>Lift coefficient of a plate in two dimensions, at 5°, some semichords after a sudden start.</summary>
    /// <param name="semichords">Travelled.</param>
    /// <param name="panels">Along the chord.</param>
    /// <param name="steps">Of a chord travelled.</param>
    public static double Started(double semichords, int panels, int steps)
    {
        WakeSettings settings = Panels(panels, 1, steps, (float)(semichords / 2 + 1), -1f);
        settings.TurnedSuction = 0f;
        using var wake = new FreeWake(settings, [new WakeWing(Steady(k_Endless, 5 * k_Degree))]);
        int count = (int)Math.Round(semichords / 2 * steps) + 1;
        for (int k = 0; k < count; k++)
            wake.Step();
        return wake.Loads(0).Force.y / Math.Cos(5 * k_Degree) / (0.5 * k_Width);
    }

    /// <summary>
    /// Lift over the angle of a steady plate, of a coefficient on its whole area, and Oswald's factor of its induced drag.
    /// </summary>
    /// <param name="plate">At the pitch of this measure.</param>
    /// <param name="area">Squared chords.</param>
    /// <param name="across">Panels along the chord.</param>
    /// <param name="along">Panels along the span.</param>
    /// <param name="ground">Height above a ground, chords; null for none.</param>
    public static (double Slope, double Factor) Slope(ThinWing plate, double area, int across, int along, float? ground = null)
    {
        WakeSettings settings = Panels(across, along, 4, 20f, -1f);
        settings.SuctionAlongChord = true;
        settings.GroundHeight = ground ?? settings.GroundHeight;
        using var wake = new FreeWake(settings, [new WakeWing(plate)]);
        for (int k = 0; k < k_Settled; k++)
            wake.Step();
        double lift = wake.Loads(0).Force.y / (0.5 * area), drag = -wake.Loads(0).Force.z / (0.5 * area);
        return (lift / k_Slope, lift * lift * area / (Math.PI * plate.Span * plate.Span * drag));
    }

    /// <summary>
    /// Lift of an ellipse behind and beside another one, over that of an ellipse alone; both at the pitch of <see cref="Slope"/>.
    /// </summary>
    /// <param name="span">Of each, chords.</param>
    /// <param name="aside">Between their middles, spans.</param>
    /// <param name="behind">Spans.</param>
    /// <param name="along">Panels along the span.</param>
    public static double Following(float span, float aside, float behind, int along)
    {
        const int k_Steps = 4;
        double Lift(params ThinWing[] plates)
        {
            WakeSettings settings = Panels(2, along, k_Steps, (behind + 6f) * span, -1f);
            settings.SuctionAlongChord = true;
            using var wake = new FreeWake(settings, plates.Select(plate => new WakeWing(plate)).ToList());
            for (int k = 0; k < k_Steps * (behind + 6f) * span; k++)
                wake.Step();
            return wake.Loads(plates.Length - 1).Force.y;
        }

        var follower = new ThinWing
        {
            Span = span,
            Root = (aside - 0.5f) * span,
            Ahead = -behind * span,
            Pivot = 0.5,
            Chord = Ellipse(span).Chord,
            Move = Ellipse(span).Move,
        };
        return Lift(Ellipse(span), follower) / Lift(follower);
    }

    /// <summary>A rectangle at the pitch of <see cref="Slope"/>.</summary>
    public static ThinWing Rectangle(float span) => Steady(span, k_Slope);

    /// <inheritdoc/>
    public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
    {
        (double height, double rise, double pitch, double turn) = Move(beats);
        double cos = Math.Cos(pitch), sin = Math.Sin(pitch);
        for (int k = 0; k < places.Length; k++)
        {
            double chord = Chord == null ? 1.0 : Chord(places[k].y);
            double ahead = Pivot - (0.5 - 0.5 * chord + places[k].x * chord);
            points[k] = new float3(Root + places[k].y * Span, (float)(height + ahead * sin), Ahead + (float)(ahead * cos));
            velocities[k] = new float3(0f, (float)(rise + ahead * cos * turn), (float)(-ahead * sin * turn));
        }
    }

    private static WakeSettings Panels(int across, int along, int steps, float keep, float stream) => new(WakeMethod.Panels)
    {
        ChordPanels = across,
        SpanPanels = along,
        StepsPerBeat = steps,
        Keep = keep,
        Stream = new float3(0f, 0f, stream),
        NearCore = 0.02f,
        FarCore = 0.02f,
    };
}
