using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli.Flights;
using Unity.Mathematics;

namespace Alate.Cli.Validation;

/// <summary>Comparisons with published flights of dragonflies.</summary>
internal static class DragonflyRows
{
    /// <summary>Substeps of the rows, and those of their limit.</summary>
    public const int Substeps = 240, FineSubsteps = 480;

    private const int k_Places = 50;
    private const double k_Bearing = 0.12, k_WithInflow = 0.40, k_WithWake = 0.30, k_Wake = 1.2, k_Correlation = 0.9;

    /// <summary>Weight support and thrust of the three flights.</summary>
    public static IEnumerable<ValidationRow> Flights(Action done)
    {
        for (int k = 0; k < MeasuredDragonfly.Flights.Count; k++)
        {
            MeasuredDragonfly flight = MeasuredDragonfly.Flights[k];
            double axis = BladeElements.Lift(flight, BladeElements.Point.Axis), middle = BladeElements.Lift(flight, BladeElements.Point.MidChord);
            string cause = FormattableString.Invariant(
                $"what the wing's pitching adds to the air it meets: blade elements apart from the model give {axis:0.00} with the stream met on the pitching axis and {middle:0.00} in the middle of the chord, where a stiff wing of uniform chord meets it; the coefficients were measured at steady angles");
            if (k == 0)
                cause += FormattableString.Invariant($"; with the fore wing's published twist, which is not prescribed here, {BladeElements.Lift(flight, BladeElements.Point.Axis, true):0.00} and {BladeElements.Lift(flight, BladeElements.Point.MidChord, true):0.00}");
            foreach ((bool rigid, double wake) in new[] { (true, 0.0), (true, 1.0), (false, 0.0) })
            {
                DragonflyRun ours = DragonflyRun.Fly(flight, rigid, Substeps, wake), fine = DragonflyRun.Fly(flight, rigid, FineSubsteps, wake);
                string wings = (rigid ? "rigid wings" : "flexible wings") + Inflow(fine, wake);
                yield return new ValidationRow(
                    $"dragonfly, flight {k + 1}, {wings}: lift over weight", 1 - k_Bearing, 1 + k_Bearing, "1 ± 0.12: steady flight", flight.Source,
                    ours.Lift.Average(), fine.Lift.Average(), wake > 0 ? Drawn(flight, fine) : rigid ? cause : "as with rigid wings");
                yield return new ValidationRow(
                    $"dragonfly, flight {k + 1}, {wings}: thrust over weight", 0, double.PositiveInfinity, "0 or more: the drag of the body", flight.Source,
                    ours.Thrust.Average(), fine.Thrust.Average(),
                    "the published pitch angles, typed from plots, and quasi-steady drag: the same kinematics by blade elements apart from the model have negative thrust too");
                done();
            }
        }
    }

    /// <summary>The tethered insect's vertical force.</summary>
    public static IEnumerable<ValidationRow> Tethered(Action done)
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        IReadOnlyList<double> measured = MeasuredDragonfly.TetheredForce;
        double mean = measured.Average(), peak = measured.Max();
        foreach ((double wake, bool addedMass) in new[] { (0, false), (1, false), (k_Wake, false), (1, true) })
        {
            string cause = wake > 0 ? "the downwash of momentum theory is even and steady" : "the wing meets air at rest; in hover it meets what it has set moving";
            double band = wake > 1 ? k_WithWake : k_WithInflow;
            DragonflyRun run = DragonflyRun.Fly(flight, true, Substeps, wake, addedMass), finer = DragonflyRun.Fly(flight, true, FineSubsteps, wake, addedMass);
            string name = "tethered dragonfly" + (wake > 0 ? Inflow(finer, wake) : ", no induced flow") + (addedMass ? ", added mass" : "");
            double[] ours = run.Even(run.Lift, k_Places), fine = finer.Even(finer.Lift, k_Places);
            yield return new ValidationRow(
                $"{name}: correlation of the vertical force", k_Correlation, 1, "0.9 or more with the computed curve", flight.Source,
                Correlation(ours, measured), Correlation(fine, measured), cause);
            yield return Near("mean", name, mean, band, flight.Source, ours.Average(), fine.Average(), cause);
            yield return Near("peak", name, peak, band, flight.Source, ours.Max(), fine.Max(), cause);
            done();
        }
    }

    /// <summary>Curves over the beat of the tethered insect, at t/T = 0, 0.02, …</summary>
    public static List<ValidationCurve> Curves()
    {
        MeasuredDragonfly flight = MeasuredDragonfly.Tethered;
        DragonflyRun still = DragonflyRun.Fly(flight, true, Substeps), rigid = DragonflyRun.Fly(flight, true, Substeps, 1), soft = DragonflyRun.Fly(flight, false, Substeps, 1);
        RecordedWing wing = soft.Record.Wings[0];
        List<BeatFrame> beat = wing.Beat;
        List<(double Lift, double Attack, double Power)> blades = BladeElements.Curve(flight, BladeElements.Point.MidChord, rigid.Record.InducedVelocity);
        double[] Shape(Func<BeatFrame, double> of) => soft.Even(beat.ConvertAll(frame => of(frame)), k_Places);
        double[] Blades(Func<(double Lift, double Attack, double Power), double> of) => Enumerable.Range(0, k_Places).Select(n => of(blades[n * blades.Count / k_Places])).ToArray();
        return
        [
            new("vertical-force", "vertical force / weight", [("no induced flow", still.Even(still.Lift, k_Places)), ("rigid", rigid.Even(rigid.Lift, k_Places)), ("flexible", soft.Even(soft.Lift, k_Places))], MeasuredDragonfly.TetheredForce.ToArray()),
            new("angle-of-attack", "angle of attack at 0.75 span, °", [("blade elements", Blades(moment => moment.Attack)), ("rigid", rigid.Even(rigid.Attack, k_Places)), ("flexible", soft.Even(soft.Attack, k_Places))], null),
            new("twist", "twist of the fore wing, °", [("flexible", Shape(frame => 180 / Math.PI * wing.Measurement.Twist(frame.Positions)))], null),
            new("camber", "camber of the fore wing, % chord", [("flexible", Shape(frame => 100 * wing.Measurement.Camber(frame.Positions)))], null),
            new("tip-bend", "bend of the fore wing's tip, °", [("flexible", Shape(frame => 180 / Math.PI * wing.Measurement.Bend(frame)))], null),
            new("power", "power, W/kg", [("blade elements", Blades(moment => moment.Power)), ("rigid", rigid.Even(rigid.Power, k_Places)), ("flexible", soft.Even(soft.Power, k_Places))], null),
        ];
    }

    /// <summary>Pearson's correlation.</summary>
    public static double Correlation(IReadOnlyList<double> a, IReadOnlyList<double> b)
    {
        double meanA = a.Average(), meanB = b.Average();
        double both = a.Zip(b, (x, y) => (x - meanA) * (y - meanB)).Sum();
        return both / Math.Sqrt(a.Sum(x => (x - meanA) * (x - meanA)) * b.Sum(y => (y - meanB) * (y - meanB)));
    }

    private static ValidationRow Near(string what, string name, double measured, double band, string source, double ours, double fine, string cause) => new(
        $"{name}: {what} of the vertical force over the weight", (1 - band) * measured, (1 + band) * measured,
        FormattableString.Invariant($"{measured:0.00} ± {100 * band:0} %"), source, ours, fine, cause);

    private static string Drawn(MeasuredDragonfly flight, DragonflyRun run)
    {
        float3 induced = run.Record.InducedVelocity;
        return FormattableString.Invariant(
            $"the downwash of momentum theory is even and steady; blade elements apart from the model in the same stream give {BladeElements.Lift(flight, BladeElements.Point.Axis, induced: induced):0.00} with the stream met on the pitching axis and {BladeElements.Lift(flight, BladeElements.Point.MidChord, induced: induced):0.00} in the middle of the chord; of the flights without an induced flow one is inside, two carry too much");
    }

    private static string Inflow(DragonflyRun run, double wake) => wake == 0 ? ""
        : wake == 1 ? FormattableString.Invariant($", induced flow of {run.Induced:0.00} m/s") : FormattableString.Invariant($", induced flow of {run.Induced:0.00} m/s, wake factor {wake}");
}
