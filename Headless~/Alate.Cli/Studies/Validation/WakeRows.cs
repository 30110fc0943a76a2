using System.Numerics;
using Alate.Wake;

namespace Alate.Cli;

/// <summary>
/// Comparisons of lattices that shed a wake with closed forms of thin wings, with a measured wing that revolves, and with the computed
/// loads of a fly that hovers.
/// </summary>
internal static class WakeRows
{
    private const double k_Height = 0.01, k_Pitch = Math.PI / 180, k_Share = 0.05, k_Degrees = 3, k_Measured = 0.12;
    private const string k_Ours = "ours: theory has no spread", k_Spread = "ours: the fit that was published has no spread",
        k_Digitised = "ours: the plots have no spread";
    private const string k_Theodorsen = "Theodorsen 1935, NACA Rep. 496", k_Garrick = "Garrick 1936, NACA Rep. 567",
        k_Wagner = "Wagner 1925, as R. T. Jones 1940, NACA Rep. 681, has it";
    private const string k_Yeo = "Yeo, Atkins and Shyy 2011, nine pressures, read by Urban 2020",
        k_Urban = "Urban 2020, report on Ptera Software, Washington University in St. Louis, openscholarship.wustl.edu/mems500/135";
    private const string k_Sun = "Sun and Tang 2002, J. Exp. Biol. 205:2413, Navier and Stokes's equations";
    private const string k_Dickinson = "Dickinson, Lehmann and Sane 1999, Science 284:1954, a model of a fly's wing in oil";

    /// <summary>Plates that heave and pitch in two dimensions: lift and thrust.</summary>
    public static IEnumerable<ValidationRow> Beating(Action done)
    {
        foreach (double k in new[] { 0.1, 0.3, 0.5 })
        {
            (Complex lift, double thrust) = Heave(k, 4, 24);
            (Complex fineLift, double fineThrust) = Heave(k, 8, 64);
            Complex theory = ThinWingTheory.Heaving(k, k_Height);
            string heaves = FormattableString.Invariant($"plate that heaves, k = {k}");
            foreach (ValidationRow row in Phasor(heaves, lift / theory, fineLift / theory))
                yield return row;
            double garrick = ThinWingTheory.Garrick(k, k_Height);
            yield return Near(
                heaves, "mean thrust over theory's", 1, k_Share, k_Garrick, thrust / garrick, fineThrust / garrick);
            Complex pitching = ThinWingTheory.Pitching(k, k_Pitch);
            foreach (ValidationRow row in Phasor(
                FormattableString.Invariant($"plate pitched about a quarter of its chord, k = {k}"), Pitch(k, 4, 24) / pitching,
                Pitch(k, 8, 64) / pitching))
            {
                yield return row;
            }
        }

        done();
    }

    /// <summary>A plate that starts suddenly in two dimensions.</summary>
    public static IEnumerable<ValidationRow> Starting(Action done)
    {
        foreach (double semichords in new[] { 1.0, 2, 4, 8, 16 })
        {
            yield return Near("plate that starts suddenly at 5°",
                FormattableString.Invariant($"lift coefficient after {semichords} semichords"), ThinWingTheory.Wagner(semichords), k_Share,
                k_Wagner, ThinWing.Started(semichords, 8, 16), ThinWing.Started(semichords, 16, 32));
        }

        done();
    }

    /// <summary>Steady plates: slope of the lift and induced drag, alone and near a ground.</summary>
    public static IEnumerable<ValidationRow> Steady(Action done)
    {
        const double k_Circle = Math.PI / 4, k_Ratio = 10, k_Glauert = 1.19;
        const string k_Surface = "lifting-surface theory, the limit of ever finer lattices";
        foreach ((float span, double slope) in new[] { (1f, 1.460), (2f, 2.474) })
        {
            yield return Near(
                FormattableString.Invariant($"rectangle, aspect ratio {span}"), "slope of the lift", slope, k_Share, k_Surface,
                ThinWing.Slope(ThinWing.Rectangle(span), span, 4, 10).Slope, ThinWing.Slope(ThinWing.Rectangle(span), span, 6, 14).Slope);
        }

        yield return Near("circle", "slope of the lift", 1.790, k_Share, k_Surface,
            ThinWing.Slope(ThinWing.Ellipse(1f), k_Circle, 4, 10).Slope, ThinWing.Slope(ThinWing.Ellipse(1f), k_Circle, 6, 14).Slope);
        float wide = (float)(k_Ratio * k_Circle);
        (double slope, double factor) coarse = ThinWing.Slope(ThinWing.Ellipse(wide), k_Circle * wide, 3, 14),
            ours = ThinWing.Slope(ThinWing.Ellipse(wide), k_Circle * wide, 4, 20);
        yield return Near("ellipse, aspect ratio 10", "slope of the lift", ThinWingTheory.Helmbold(k_Ratio), k_Share,
            "Helmbold 1942", coarse.slope, ours.slope);
        yield return Near("ellipse, aspect ratio 10", "factor of the induced drag", 1, k_Share, "lifting line, Prandtl 1918", coarse.factor,
            ours.factor);
        yield return Near("rectangle of strips, aspect ratio 8", "slope of the lift", 2 * Math.PI / (1 + 2 * k_Glauert / 8), k_Share,
            "lifting line, Glauert's series", Strips(12), Strips(20));
        foreach (double height in new[] { 0.125, 0.25 })
        {
            // Height over the span; the mirror image lies twice as far off.
            const float k_Span = 8f;
            double Share(int along)
            {
                var plate = ThinWing.Rectangle(k_Span);
                return ThinWing.Slope(plate, k_Span, 2, along).Factor
                    / ThinWing.Slope(plate, k_Span, 2, along, (float)(height * k_Span)).Factor;
            }

            yield return Near("rectangle above a ground, aspect ratio 8",
                FormattableString.Invariant($"induced drag over that in free air at {height} spans, lift alike"),
                1 - (1 - 1.32 * height) / (1.05 + 7.4 * height), k_Share, "Wieselsberger 1922, NACA TM 77", Share(10), Share(16));
        }

        done();
    }

    /// <summary>Two ellipses in formation: what the wake of the first lifts the second by.</summary>
    public static IEnumerable<ValidationRow> Formation(Action done)
    {
        const double k_Ratio = 10;
        const float k_Span = (float)(k_Ratio * Math.PI / 4), k_Behind = 1f;
        foreach (float aside in new[] { 1.25f, 1.5f })
        {
            yield return Near(
                FormattableString.Invariant($"two ellipses, aspect ratio 10, the second a span behind and {aside} spans aside"),
                "gain of the second's lift, %", 100 * (ThinWingTheory.Following(k_Ratio, aside, k_Behind) - 1), k_Share,
                "lifting lines, the second by reverse flow", 100 * (ThinWing.Following(k_Span, aside, k_Behind, 10) - 1),
                100 * (ThinWing.Following(k_Span, aside, k_Behind, 16) - 1));
        }

        done();
    }

    /// <summary>The wing by which the coefficients were measured.</summary>
    public static IEnumerable<ValidationRow> Revolving(Action done)
    {
        foreach (double degrees in new[] { 20.0, 40, 60 })
        {
            foreach ((string by, WakeMethod method) in new[]
            {
                ("strips, whose downwash is fitted to its lift up to 30°", WakeMethod.Strips),
                ("panels, whose suction is fitted to it", WakeMethod.Panels),
            })
            {
                (double lift, double drag) = Revolve(degrees, method, 24);
                (double fineLift, double fineDrag) = Revolve(degrees, method, 48);
                string record = FormattableString.Invariant($"wing that revolves at {degrees}°, {by}");
                yield return Measured(
                    record, "lift coefficient", RevolvingWing.MeasuredLift(degrees), k_Spread, k_Dickinson, lift, fineLift);
                yield return Measured(
                    record, "drag coefficient", RevolvingWing.MeasuredDrag(degrees), k_Spread, k_Dickinson, drag, fineDrag);
            }
        }

        done();
    }

    /// <summary>A wing that flaps in a stream, beside its pressures and beside another lattice.</summary>
    public static IEnumerable<ValidationRow> Flapping(Action done)
    {
        // Urban's 29.1 mN: five by eighteen panels of attached flow, a wake that does not move by itself, 224 steps in three beats.
        const double k_Other = 29.1;
        foreach ((string by, WakeMethod method, bool attached) in new[]
        {
            ("panels of attached flow", WakeMethod.Panels, true),
            ("panels, whose suction is fitted to a fly's wing", WakeMethod.Panels, false),
            ("strips", WakeMethod.Strips, false),
        })
        {
            (double rms, double error) = FlappingPlate.Fly(method, attached, 24);
            (double fineRms, double fineError) = FlappingPlate.Fly(method, attached, 48);
            string record = $"ornithopter's stiff wing in a stream, {by}";
            yield return Measured(record, "root mean square of the lift, mN", FlappingPlate.MeasuredRms, k_Digitised, k_Yeo, rms, fineRms);
            yield return new ValidationRow(
                record, "mean distance from the measured lift, mN", 0, k_Other, "measured: 0, from itself; Ptera Software 29.1",
                "no farther than Ptera Software", k_Urban, error, fineError)
            {
                Table = ValidationTable.Wakes,
            };
        }

        done();
    }

    /// <summary>A fruit fly that hovers, beside loads that Navier and Stokes's equations gave for the same motion.</summary>
    public static IEnumerable<ValidationRow> Hovering(Action done)
    {
        // The angle of attack at which the published lift is the weight, and the published mean drag over it.
        const double k_Attack = 37, k_Drag = 1.27;
        foreach ((string by, MeasuredDownwash downwash) in new[]
        {
            ("the measured downwash taken out as an angle", MeasuredDownwash.Angle),
            ("no measured downwash taken out", MeasuredDownwash.None),
        })
        {
            (double lift, double drag) = HoveringFly.Fly(k_Attack, new WakeSettings(), downwash: downwash);
            (double fineLift, double fineDrag) = HoveringFly.Fly(k_Attack, new WakeSettings { StepsPerBeat = 48 }, downwash: downwash);
            string record = FormattableString.Invariant($"fruit fly that hovers at {k_Attack}° to the air, strips, {by}");
            yield return Computed(record, "lift over weight", 1, lift, fineLift);
            yield return Computed(record, "mean drag over mean lift", k_Drag, drag, fineDrag);
        }

        done();
    }

    private static (double Lift, double Drag) Revolve(double degrees, WakeMethod method, int steps) =>
        RevolvingWing.Fly(degrees, new WakeSettings(method) { Keep = 4f, StepsPerBeat = steps });

    private static (Complex Lift, double Thrust) Heave(double k, int panels, int steps)
    {
        const double k_Rate = 2 * Math.PI;
        return ThinWing.Oscillate(
            k, panels, steps, t => (k_Height * Math.Cos(k_Rate * t), -k_Height * k_Rate * Math.Sin(k_Rate * t), 0.0, 0.0));
    }

    private static Complex Pitch(double k, int panels, int steps)
    {
        const double k_Rate = 2 * Math.PI;
        return ThinWing.Oscillate(
            k, panels, steps, t => (0.0, 0.0, k_Pitch * Math.Cos(k_Rate * t), -k_Pitch * k_Rate * Math.Sin(k_Rate * t))).Lift;
    }

    private static double Strips(int along)
    {
        const double k_Angle = 0.05;
        const float k_Span = 8f;
        var settings = new WakeSettings
        {
            SpanPanels = along,
            StepsPerBeat = 4,
            Keep = 30f,
            NearCore = 0.02f,
            FarCore = 0.02f,
            Stream = new float3(0f, 0f, -1f),
        };
        using var wake = new FreeWake(
            settings, [new WakeWing(ThinWing.Steady(k_Span, k_Angle)) { Coefficients = null, Downwash = MeasuredDownwash.None }]);
        for (int k = 0; k < 100; k++)
            wake.Step();
        return wake.Loads(0).Force.y / (0.5 * k_Span * k_Angle);
    }

    private static IEnumerable<ValidationRow> Phasor(string record, Complex ours, Complex fine)
    {
        yield return Near(record, "amplitude of the lift over theory's", 1, k_Share, k_Theodorsen, ours.Magnitude, fine.Magnitude);
        yield return new ValidationRow(record, "phase of the lift ahead of theory's, °", -k_Degrees, k_Degrees, "theory: 0", k_Ours,
            k_Theodorsen, 180 / Math.PI * ours.Phase, 180 / Math.PI * fine.Phase)
        {
            Table = ValidationTable.Wakes,
        };
    }

    private static ValidationRow Near(
        string record, string quantity, double value, double share, string source, double ours, double fine) =>
        Row(record, quantity, value, share, "theory", k_Ours, source, ours, fine);

    private static ValidationRow Computed(string record, string quantity, double value, double ours, double fine) =>
        Row(record, quantity, value, k_Measured, "computed", "ours: the computation has no spread", k_Sun, ours, fine);

    private static ValidationRow Measured(
        string record, string quantity, double value, string spread, string source, double ours, double fine) =>
        Row(record, quantity, value, k_Measured, "measured", spread, source, ours, fine);

    private static ValidationRow Row(string record, string quantity, double value, double share, string how, string spread, string source,
        double ours, double fine) =>
        new(record, quantity, (1 - share) * value, (1 + share) * value, FormattableString.Invariant($"{how}: {value:0.000}"), spread,
            source, ours, fine)
        {
            Table = ValidationTable.Wakes,
        };
}
