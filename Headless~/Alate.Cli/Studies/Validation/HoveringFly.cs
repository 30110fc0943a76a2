using Alate.Wake;

namespace Alate.Cli;

/// <summary>
/// Right wing of a hovering fruit fly (Drosophila virilis; Weis-Fogh 1973) as Sun and Tang 2002 move it: it sweeps in a level plane, with
/// the same angle of attack in the middle of both half-strokes, and flips about the ends of them. Lengths are wing lengths.
/// </summary>
/// <param name="attack">Angle of attack between the flips, radians.</param>
/// <param name="flip">Time of a flip, beats.</param>
internal sealed class HoveringFly(double attack, double flip = HoveringFly.Flip) : IWingMotion
{
    /// <summary>Time of a flip, beats.</summary>
    public const double Flip = 0.36;

    /// <summary>Angle between the ends of a half-stroke, radians.</summary>
    private const double k_Stroke = 150 * Math.PI / 180, k_Rate = 2 * Math.PI;

    /// <summary>Metres, beats a second, squared metres of both wings, kilograms, and density of the air.</summary>
    private const double k_Length = 3.0e-3, k_Frequency = 240, k_Area = 5.8e-6, k_Mass = 2.0e-6, k_Density = 1.25;
    private const double k_Gravity = 9.81;

    /// <summary>Mean chord of a wing, wing lengths.</summary>
    private const double k_Chord = 0.5 * k_Area / (k_Length * k_Length);

    public void Evaluate(double beats, ReadOnlySpan<float2> places, Span<float3> points, Span<float3> velocities)
    {
        double swept = -0.5 * k_Stroke * Math.Cos(k_Rate * beats), sweep = 0.5 * k_Stroke * k_Rate * Math.Sin(k_Rate * beats);
        (double pitch, double turn) = Pitch(beats);
        float3 along = Level(Math.Cos(swept), Math.Sin(swept)), across = Level(-Math.Sin(swept), Math.Cos(swept)),
            up = new float3(0f, 1f, 0f);
        for (int k = 0; k < places.Length; k++)
        {
            float before = (float)((0.25 - places[k].x) * FlyPlanform.Chord(places[k].y, k_Chord)), far = places[k].y;
            float level = before * (float)Math.Cos(pitch), high = before * (float)Math.Sin(pitch);
            points[k] = far * along + level * across + high * up;
            velocities[k] = (float)sweep * (far * across - level * along) + (float)turn * (level * up - high * across);
        }
    }

    /// <summary>Lift over the weight, and mean drag over mean lift, in the beat after a number of beats.</summary>
    /// <param name="degrees">Angle of attack between the flips.</param>
    /// <param name="settings">Of the wake, but for those that follow from the fly.</param>
    /// <param name="beats">Until the one that counts.</param>
    /// <param name="flip">Time of a flip, beats.</param>
    /// <param name="downwash">Part of a wake that the coefficients hold.</param>
    public static (double Lift, double Drag) Fly(
        double degrees, WakeSettings settings, int beats = 4, double flip = Flip, MeasuredDownwash downwash = default)
    {
        settings.Symmetric = true;
        settings.Viscosity = (float)(WakeFluid.ViscosityOf((float)k_Density) / (k_Frequency * k_Length * k_Length));
        using var wake = new FreeWake(settings, [new WakeWing(new HoveringFly(degrees * Math.PI / 180, flip)) { Downwash = downwash }]);
        double lift = 0, drag = 0;
        for (int k = 0; k < (beats + 1) * settings.StepsPerBeat; k++)
        {
            double time = wake.Time, sweep = Math.Sin(k_Rate * time);
            wake.Step();
            if (k < beats * settings.StepsPerBeat)
                continue;
            // Level and across the span, against the sweep, which stands still between half-strokes.
            double swept = -0.5 * k_Stroke * Math.Cos(k_Rate * time);
            float3 force = wake.Loads(0).Force;
            lift += force.y;
            drag -= math.dot(force, Level(-Math.Sin(swept), Math.Cos(swept))) * (Math.Abs(sweep) < 1e-6 ? 0 : Math.Sign(sweep));
        }

        double newtons = 2 * k_Density * Math.Pow(k_Length, 4) * k_Frequency * k_Frequency / settings.StepsPerBeat;
        return (newtons * lift / (k_Mass * k_Gravity), drag / lift);
    }

    // Angle of the leading edge above the direction of the first half-stroke, and its rate: a flip's rate rises and falls as a cosine.
    private (double Pitch, double Turn) Pitch(double beats)
    {
        double phase = beats - Math.Floor(beats), wide = Math.PI - 2 * attack;
        double end = Math.Round(2 * phase) / 2, share = (phase - end) / flip + 0.5;
        bool isForward = phase < 0.5;
        if (share is <= 0 or >= 1)
            return (isForward ? attack : Math.PI - attack, 0);
        double done = share - Math.Sin(k_Rate * share) / k_Rate, rate = (1 - Math.Cos(k_Rate * share)) / flip;
        return end == 0.5 ? (attack + wide * done, wide * rate) : (Math.PI - attack - wide * done, -wide * rate);
    }

    private static float3 Level(double right, double ahead) => new((float)right, 0f, (float)ahead);
}
