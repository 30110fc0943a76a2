using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Forces of a published flight by blade elements in double precision, apart from the wing model: strips of a stiff wing of uniform chord,
/// coefficients by Dickinson 1999, no flow along the span.
/// </summary>
internal static class BladeElements
{
    private const int k_Strips = 20, k_Moments = 200;
    private const double k_Density = 1.225, k_Step = 1e-5;

    /// <summary>
    /// Amplitude of the first harmonic of a twisted wing's pitch at the root, degrees, and the share of the span at which it is that of the
    /// series (flight 1).
    /// </summary>
    private const double k_RootPitch = 9, k_PitchedSpan = 0.75;

    /// <summary>
    /// Drag coefficient of a dragonfly's wing at 0, 5, … 90° of attack: Azuma and Watanabe 1988, digitised by J. Pecquet; mean of the
    /// stream from above and from below.
    /// </summary>
    private static readonly double[] s_OwnDrag = [0.094, 0.107, 0.145, 0.208, 0.293, 0.394, 0.521, 0.688, 0.892, 1.104, 1.331, 1.526, 1.704,
        1.839, 1.922, 1.961, 1.982, 1.995, 2.000];
    private const double k_DragStep = 5;

    /// <summary>A moment of the beat.</summary>
    /// <param name="Lift">Vertical force over the weight.</param>
    /// <param name="Thrust">Force ahead over the weight.</param>
    /// <param name="Attack">Angle of attack at 0.75 of the fore wing's span, degrees.</param>
    /// <param name="Power">Over the mass, W/kg.</param>
    internal readonly record struct Moment(double Lift, double Thrust, double Attack, double Power);

    /// <summary>Places at which the stream is met.</summary>
    internal enum Point
    {
        /// <summary>On the axis about which the wing is pitched.</summary>
        Axis,

        /// <summary>In the middle of the chord, behind the axis at the leading edge.</summary>
        MidChord,
    }

    /// <summary>Mean vertical force of all wings over the weight.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="point">Where the stream is met.</param>
    /// <param name="twisted">Whether the first harmonic of the fore wing's pitch falls to 9° at the root, as in flight 1.</param>
    /// <param name="induced">Velocity of the air that the wings draw along, m/s: right, up, ahead.</param>
    /// <param name="ownDrag">Whether the drag is that of a dragonfly's wing.</param>
    public static double Lift(
        MeasuredDragonfly flight, Point point, bool twisted = false, float3 induced = default, bool ownDrag = false) =>
        Curve(flight, point, induced, twisted, ownDrag).Average(moment => moment.Lift);

    /// <summary>Mean force ahead over the weight.</summary>
    /// <inheritdoc cref="Curve"/>
    public static double Thrust(MeasuredDragonfly flight, Point point, float3 induced = default, bool ownDrag = false) =>
        Curve(flight, point, induced, ownDrag: ownDrag).Average(moment => moment.Thrust);

    /// <summary>The beat.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="point">Where the stream is met.</param>
    /// <param name="induced">Velocity of the air that the wings draw along, m/s: right, up, ahead.</param>
    /// <param name="twisted">Whether the first harmonic of the fore wing's pitch falls to 9° at the root, as in flight 1.</param>
    /// <param name="ownDrag">Whether the drag is that of a dragonfly's wing.</param>
    /// <param name="wings">Motion of fore and hind wing; null for that of the flight.</param>
    public static List<Moment> Curve(
        MeasuredDragonfly flight, Point point, float3 induced = default, bool twisted = false, bool ownDrag = false,
        IReadOnlyList<PresetKinematics> wings = null)
    {
        wings ??= DragonflyRun.Kinematics(flight);
        var beat = new List<Moment>();
        for (int k = 0; k < k_Moments; k++)
        {
            double up = 0, ahead = 0, power = 0, attack = 0;
            for (int wing = 0; wing < 2; wing++)
            {
                for (int strip = 0; strip < k_Strips; strip++)
                {
                    double share = (strip + 0.5) / k_Strips, chord = flight.Areas[wing] / flight.Lengths[wing];
                    PresetKinematics motion = wings[wing];
                    if (twisted && wing == 0)
                        motion.feather = Twisted(motion.feather, share);
                    var place = new Place(motion, share * flight.Lengths[wing], point == Point.MidChord ? 0.5 * chord : 0);
                    double[] air = [0, -flight.Climb + induced.y, -flight.Speed + induced.z];
                    (double lift, double thrust, double work, double angle) = Strip(
                        place, (double)k / k_Moments, air, chord * flight.Lengths[wing] / k_Strips, ownDrag);
                    up += 2 * lift;
                    ahead += 2 * thrust;
                    power += 2 * work;
                    attack = wing == 0 && strip == (int)(0.75 * k_Strips) ? angle : attack;
                }
            }

            beat.Add(new Moment(up / flight.Weight, ahead / flight.Weight, attack, power / flight.Mass));
        }

        return beat;
    }

    private static (double Lift, double Thrust, double Work, double Attack) Strip(
        in Place place, double turns, double[] air, double area, bool ownDrag)
    {
        (double[] at, double[] span, double[] chord) = place.At(turns);
        double[] before = place.At(turns - k_Step).At, after = place.At(turns + k_Step).At;
        double rate = place.Motion.frequency / (2 * k_Step);
        double[] moved = Enumerable.Range(0, 3).Select(k => (after[k] - before[k]) * rate).ToArray();
        double[] stream = Enumerable.Range(0, 3).Select(k => air[k] - moved[k]).ToArray();
        double along = Dot(stream, span);
        stream = Enumerable.Range(0, 3).Select(k => stream[k] - along * span[k]).ToArray();
        double speed = Math.Sqrt(Dot(stream, stream));
        double[] normal =
            [span[1] * chord[2] - span[2] * chord[1], span[2] * chord[0] - span[0] * chord[2], span[0] * chord[1] - span[1] * chord[0]];
        double across = Dot(stream, normal), angle = Math.Atan2(Math.Abs(across), Math.Abs(Dot(stream, chord))) * 180 / Math.PI;
        double lift = 0.225 + 1.58 * Math.Sin((2.13 * angle - 7.20) * Math.PI / 180),
            drag = ownDrag ? OwnDrag(angle) : 1.92 - 1.55 * Math.Cos((2.04 * angle - 9.82) * Math.PI / 180);
        double[] lifting = Enumerable.Range(0, 3)
            .Select(k => Math.Sign(across) * (normal[k] - across / (speed * speed) * stream[k])).ToArray();
        double size = Math.Sqrt(Dot(lifting, lifting)), q = 0.5 * k_Density * area * speed * speed;
        double[] force = Enumerable.Range(0, 3)
            .Select(k => q * (drag * stream[k] / speed + (size > 1e-9 ? lift * lifting[k] / size : 0))).ToArray();
        return (force[1], force[2], -Dot(force, moved), angle);
    }

    internal static double OwnDrag(double angle)
    {
        int place = Math.Min((int)(angle / k_DragStep), s_OwnDrag.Length - 2);
        return s_OwnDrag[place] + (angle / k_DragStep - place) * (s_OwnDrag[place + 1] - s_OwnDrag[place]);
    }

    private static AngleSeries Twisted(AngleSeries series, double share)
    {
        Vector2[] harmonics = [.. series.harmonics];
        double whole = Math.Abs(harmonics[0].x), here = k_RootPitch + (whole - k_RootPitch) * share / k_PitchedSpan;
        harmonics[0].x *= (float)(here / whole);
        return new AngleSeries(series.mean, harmonics);
    }

    private static double Dot(double[] a, double[] b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

    // A place of a wing: distance along the span and behind the axis, metres; X out, Y up, Z ahead.
    private readonly record struct Place(PresetKinematics Motion, double Span, double Behind)
    {
        public (double[] At, double[] Span, double[] Chord) At(double turns)
        {
            double flap = Radians(Motion.flap, turns), cone = Radians(Motion.sweep, turns), pitch = -Radians(Motion.feather, turns),
                tilt = Radians(Motion.tilt, turns);
            double[] up = [0, Math.Cos(tilt), -Math.Sin(tilt)], ahead = [0, Math.Sin(tilt), Math.Cos(tilt)], outward = [1, 0, 0];
            double[] swung = Sum(outward, Math.Cos(flap), up, Math.Sin(flap)), raised = Sum(outward, -Math.Sin(flap), up, Math.Cos(flap));
            double[] span = Sum(swung, Math.Cos(cone), ahead, Math.Sin(cone)), conical = Sum(swung, -Math.Sin(cone), ahead, Math.Cos(cone));
            double[] chord = Sum(conical, Math.Cos(pitch), raised, Math.Sin(pitch));
            return (Sum(span, Span, chord, -Behind), span, chord);
        }

        private static double Radians(AngleSeries series, double turns)
        {
            double degrees = series.mean;
            for (int k = 0; k < (series.harmonics?.Length ?? 0); k++)
                degrees += series.harmonics[k].x * Math.Cos((k + 1) * 2 * Math.PI * turns + series.harmonics[k].y * Math.PI / 180);
            return degrees * Math.PI / 180;
        }

        private static double[] Sum(double[] a, double x, double[] b, double y) =>
            [a[0] * x + b[0] * y, a[1] * x + b[1] * y, a[2] * x + b[2] * y];
    }
}
