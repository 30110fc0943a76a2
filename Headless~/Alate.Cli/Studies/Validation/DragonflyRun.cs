namespace Alate.Cli;

/// <summary>A published flight flown with the wings of the catalogue's dragonfly at the published sizes, steady and settled.</summary>
internal sealed class DragonflyRun
{
    /// <summary>Of the air, kg/m³.</summary>
    private const double k_Density = 1.225;

    private DragonflyRun(MeasuredDragonfly measured, FlightRecord record)
    {
        Record = record;
        int count = record.Wings[0].Frames.Count;
        Lift = new double[count];
        Thrust = new double[count];
        Power = new double[count];
        Attack = record.Wings[0].Frames.Select(frame => 180 / Math.PI * frame.Attack).ToArray();
        for (int k = 0; k < count; k++)
        {
            foreach (RecordedWing wing in record.Wings)
            {
                PresetSize size = wing.Wing.Preset.Size;
                float3 force = size.wingMass * size.wingLength * wing.Placement.DirectionToBody(wing.Frames[k].AirForce);
                Lift[k] += force.y / measured.Weight;
                Thrust[k] += force.z / measured.Weight;
                Power[k] += size.wingMass * size.wingLength * size.wingLength * wing.Power(k) / measured.Mass;
            }
        }
    }

    public FlightRecord Record { get; }

    /// <summary>[frame] Vertical force of all wings over the weight.</summary>
    public double[] Lift { get; }

    /// <summary>[frame] Force ahead of all wings over the weight.</summary>
    public double[] Thrust { get; }

    /// <summary>[frame] Power that all wings give to the air, W/kg.</summary>
    public double[] Power { get; }

    /// <summary>[frame] Angle of attack about 0.75 of the fore wing's span, degrees.</summary>
    public double[] Attack { get; }

    /// <summary>Speed of the air that the wings draw along, m/s.</summary>
    public double Induced => math.length(Record.InducedVelocity);

    /// <summary>Flies.</summary>
    /// <param name="measured">The flight.</param>
    /// <param name="rigid">Whether the wings are stiff.</param>
    /// <param name="substeps">Of a beat.</param>
    /// <param name="wake">Factor of the induced flow; 0 for none.</param>
    /// <param name="addedMass">Whether the air that the wings carry along counts.</param>
    /// <param name="ownDrag">Whether the drag is that of a dragonfly's wing.</param>
    public static DragonflyRun Fly(
        MeasuredDragonfly measured, bool rigid, int substeps, double wake = 0, bool addedMass = false, bool ownDrag = false)
    {
        var plan = new FlightPlan
        {
            Species = "dragonfly",
            KinematicsFile = PathOf(measured),
            Speed = measured.Speed,
            Climb = measured.Climb,
            Induced = wake > 0 ? new InducedFlow(wake, k_Density) : null,
            AddedMass = addedMass,
            Coefficients = ownDrag ? CoefficientSet.Dragonfly : null,
            RecordsAir = true,
            Substeps = substeps,
            Patches = 256,
            Column = rigid ? ComparisonColumn.RigidWing : ComparisonColumn.FullModel,
        };
        var insect = Insect.Of(plan);
        InsectDefinition definition = plan.Definition;
        for (int k = 0; k < insect.Wings.Count; k++)
            Resize(insect.Wings[k].Preset, definition.Wings[k].Outline, measured, k);
        using var flight = new TetheredFlight(plan, insect);
        return new DragonflyRun(measured, flight.Run(_ => { }));
    }

    /// <summary>The file with a flight's kinematics.</summary>
    public static string PathOf(MeasuredDragonfly measured) =>
        Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics", measured.Name + ".json");

    /// <summary>The kinematics of a flight, fore and hind wing.</summary>
    public static IReadOnlyList<PresetKinematics> Kinematics(MeasuredDragonfly measured)
    {
        KinematicsFile file = TextFile.Read(PathOf(measured), KinematicsJson.Read);
        return [file.Wings["fore wing"], file.Wings["hind wing"]];
    }

    /// <summary>A curve of this flight at t/T = 0, 1/n, …</summary>
    public double[] Even(IReadOnlyList<double> curve, int count) => new BeatCurve(Record.Wings[0].Frames, curve).Even(count);

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
