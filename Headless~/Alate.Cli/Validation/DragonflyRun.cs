using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Flights;
using Alate.Cli.Input;
using Alate.Cli.Projects;
using Unity.Mathematics;

namespace Alate.Cli.Validation;

/// <summary>A published flight flown with the wings of the catalogue's dragonfly at the published sizes, steady and settled.</summary>
internal sealed class DragonflyRun
{
    private DragonflyRun(MeasuredDragonfly measured, FlightRecord record)
    {
        Record = record;
        int count = record.Wings[0].Frames.Count;
        Lift = new double[count];
        Thrust = new double[count];
        for (int k = 0; k < count; k++)
        {
            foreach (RecordedWing wing in record.Wings)
            {
                PresetSize size = wing.Wing.Preset.Size;
                float3 force = size.wingMass * size.wingLength * wing.Placement.DirectionToBody(wing.Frames[k].AirForce);
                Lift[k] += force.y / measured.Weight;
                Thrust[k] += force.z / measured.Weight;
            }
        }
    }

    public FlightRecord Record { get; }

    /// <summary>[frame] Vertical force of all wings over the weight.</summary>
    public double[] Lift { get; }

    /// <summary>[frame] Force ahead of all wings over the weight.</summary>
    public double[] Thrust { get; }

    /// <summary>Flies.</summary>
    /// <param name="measured">The flight.</param>
    /// <param name="rigid">Whether the wings are stiff.</param>
    /// <param name="substeps">Of a beat.</param>
    /// <param name="downwash">Speed of the air downwards, m/s.</param>
    public static DragonflyRun Fly(MeasuredDragonfly measured, bool rigid, int substeps, double downwash = 0)
    {
        var plan = new FlightPlan
        {
            Species = "dragonfly",
            KinematicsFile = PathOf(measured),
            Speed = measured.Speed,
            Climb = measured.Climb,
            Wind = [0, -downwash, 0],
            Substeps = substeps,
            Patches = 256,
            Column = rigid ? ComparisonColumn.RigidWing : ComparisonColumn.FullModel,
        };
        var insect = Insect.Of(plan);
        InsectDefinition definition = InsectCatalogue.Find(plan.Species);
        for (int k = 0; k < insect.Wings.Count; k++)
            Resize(insect.Wings[k].Preset, definition.Wings[k].Outline, measured, k);
        using var flight = new TetheredFlight(plan, insect);
        return new DragonflyRun(measured, flight.Run(_ => { }));
    }

    /// <summary>The file with a flight's kinematics.</summary>
    public static string PathOf(MeasuredDragonfly measured) => Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics", measured.Name + ".json");

    /// <summary>The kinematics of a flight, fore and hind wing.</summary>
    public static IReadOnlyList<PresetKinematics> Kinematics(MeasuredDragonfly measured)
    {
        KinematicsFile file = TextFile.Read(PathOf(measured), KinematicsJson.Read);
        return [file.Wings["fore wing"], file.Wings["hind wing"]];
    }

    /// <summary>A curve of this flight at t/T = 0, 1/n, …</summary>
    public double[] Even(IReadOnlyList<double> curve, int count)
    {
        List<RecordedFrame> frames = Record.Wings[0].Frames;
        (double Turn, double Value)[] points = frames.Select((frame, k) => (frame.Phase / (2 * Math.PI), curve[k])).OrderBy(point => point.Item1).ToArray();
        return Enumerable.Range(0, count).Select(n => At(points, (double)n / count)).ToArray();
    }

    private static double At((double Turn, double Value)[] points, double turn)
    {
        int after = Array.FindIndex(points, point => point.Turn >= turn);
        (double Turn, double Value) b = after < 0 ? (points[0].Turn + 1, points[0].Value) : points[after];
        (double Turn, double Value) a = after > 0 ? points[after - 1] : after < 0 ? points[^1] : (points[^1].Turn - 1, points[^1].Value);
        double share = b.Turn > a.Turn ? (turn - a.Turn) / (b.Turn - a.Turn) : 0;
        return a.Value + share * (b.Value - a.Value);
    }

    // The published length; the outline's area per squared length differs from the published one, and forces go with the area.
    private static void Resize(WingPreset preset, WingOutline outline, MeasuredDragonfly measured, int wing)
    {
        double ours = outline.Area * measured.Lengths[wing] * measured.Lengths[wing];
        preset.Size.wingLength = (float)measured.Lengths[wing];
        preset.Size.insectMass = (float)measured.Mass;
        preset.Size.fluidDensity *= (float)(measured.Areas[wing] / ours);
        preset.Stiffness.strongestWind = WingBounds.StrongestWind.Max;
    }
}
