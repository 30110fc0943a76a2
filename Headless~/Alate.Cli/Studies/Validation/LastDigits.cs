using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Bands that the last printed digits of a published flight leave open for its mean forces: each number is moved by half of its last
/// digit in blade elements apart from the model, and the effects of all are added as those of independent roundings.
/// </summary>
internal static class LastDigits
{
    /// <summary>Half of the last digit of angles and phases, degrees, of frequencies, Hz, and of masses over the mass.</summary>
    private const float k_Angle = 0.5f, k_Frequency = 0.05f;
    private const double k_Mass = 5e-6;

    /// <summary>Half of the width that holds 95 % of a normal distribution, in standard deviations.</summary>
    private const double k_Normal = 1.96;

    /// <summary>Half of the width of a band of 95 %: of lift and thrust over the weight.</summary>
    public static (double Lift, double Thrust) Of(MeasuredDragonfly flight)
    {
        IReadOnlyList<PresetKinematics> wings = DragonflyRun.Kinematics(flight);
        (double lift, double thrust) = Mean(flight, wings);
        double lifts = 0, thrusts = 0;
        foreach ((MeasuredDragonfly changed, IReadOnlyList<PresetKinematics> moved) in Changes(flight, wings))
        {
            (double up, double ahead) = Mean(changed, moved);
            // A rounding is even over its range: its variance is a third of the squared half of it.
            lifts += (up - lift) * (up - lift) / 3;
            thrusts += (ahead - thrust) * (ahead - thrust) / 3;
        }

        return (k_Normal * Math.Sqrt(lifts), k_Normal * Math.Sqrt(thrusts));
    }

    private static IEnumerable<(MeasuredDragonfly, IReadOnlyList<PresetKinematics>)> Changes(
        MeasuredDragonfly flight, IReadOnlyList<PresetKinematics> wings)
    {
        double speed = Math.Sqrt(flight.Speed * flight.Speed + flight.Climb * flight.Climb), way = Math.Atan2(flight.Climb, flight.Speed);
        yield return (At(flight, speed + flight.HalfSpeed, way), wings);
        yield return (At(flight, speed, way + Math.PI / 180 * flight.HalfAngle), wings);
        yield return (flight with { Mass = flight.Mass + k_Mass }, wings);
        yield return (flight, [.. wings.Select(wing => wing with { frequency = wing.frequency + k_Frequency })]);
        for (int k = 0; k < wings.Count; k++)
        {
            foreach (PresetKinematics moved in Moved(wings[k]))
                yield return (flight, k == 0 ? [moved, wings[1]] : [wings[0], moved]);
        }
    }

    private static MeasuredDragonfly At(MeasuredDragonfly flight, double speed, double way) =>
        flight with { Speed = speed * Math.Cos(way), Climb = speed * Math.Sin(way) };

    private static IEnumerable<PresetKinematics> Moved(PresetKinematics wing) =>
    [
        .. Moved(wing.flap).Select(series => wing with { flap = series }),
        .. Moved(wing.sweep).Select(series => wing with { sweep = series }),
        .. Moved(wing.feather).Select(series => wing with { feather = series }),
        .. Moved(wing.tilt).Select(series => wing with { tilt = series }),
    ];

    private static IEnumerable<AngleSeries> Moved(AngleSeries series)
    {
        Vector2[] harmonics = series.harmonics ?? [];
        yield return new AngleSeries(series.mean + k_Angle, harmonics);
        for (int k = 0; k < harmonics.Length; k++)
        {
            foreach (Vector2 change in new[] { new Vector2(k_Angle, 0f), new Vector2(0f, k_Angle) })
            {
                Vector2[] moved = [.. harmonics];
                moved[k] += change;
                yield return new AngleSeries(series.mean, moved);
            }
        }
    }

    private static (double Lift, double Thrust) Mean(MeasuredDragonfly flight, IReadOnlyList<PresetKinematics> wings)
    {
        List<BladeElements.Moment> beat = BladeElements.Curve(flight, BladeElements.Point.MidChord, ownDrag: true, wings: wings);
        return (beat.Average(moment => moment.Lift), beat.Average(moment => moment.Thrust));
    }
}
