namespace Alate.Cli;

/// <summary>
/// Groups of numbers of an insect that are alike on real insects of all sizes, for one kind of wing. Those of the whole insect stand with
/// its first wing, and are not a number with the others. What cannot be told is not a number either.
/// </summary>
/// <param name="Wing">Name of the wing.</param>
internal sealed record WingGroups(string Wing)
{
    /// <summary>Viscosities of air and of water at 20 °C, Pa·s, and a density between those of gases and liquids, kg/m³.</summary>
    private const double k_Air = 1.81e-5, k_Water = 1.0e-3, k_Liquid = 100;

    /// <summary>Square of the first root of cos x cosh x = −1: a clamped uniform beam.</summary>
    private const double k_FirstMode = 3.516;

    /// <summary>Weight over the area of all wings, N/m².</summary>
    public double WingLoading { get; private init; } = double.NaN;

    /// <summary>Mass of all wings over that of the insect, per cent.</summary>
    public double WingMassShare { get; private init; } = double.NaN;

    /// <summary>Mass without wings over the volume of the body's ellipsoids, kg/m³.</summary>
    public double BodyDensity { get; private init; } = double.NaN;

    /// <summary>Flap from end to end, degrees.</summary>
    public double Flap { get; private init; }

    /// <summary>Mean speed of the tip times the mean chord over the kinematic viscosity.</summary>
    public double Reynolds { get; private init; }

    /// <summary>Mean speed of the tip against the body, m/s.</summary>
    public double TipSpeed { get; private init; }

    /// <summary>π f c over the mean speed of the tip.</summary>
    public double ReducedFrequency { get; private init; }

    /// <summary>Frequency times the height that the tip beats through over the speed of flight; not a number in hover.</summary>
    public double Strouhal { get; private init; }

    /// <summary>EI of all chains over what was measured on wings of the length.</summary>
    public double StiffnessRatio { get; private init; }

    /// <summary>EI over GJ, of all chains.</summary>
    public double BendOverTwist { get; private init; }

    /// <summary>First frequency of a uniform beam of the wing's EI, mass and length, clamped at the hinge, over that of the beat.</summary>
    public double StructuralRatio { get; private init; }

    /// <summary>Distance of the hinge from the middle plane over the wing's length, per cent.</summary>
    public double HingeShare { get; private init; }

    /// <summary>Groups of each kind of wing.</summary>
    /// <param name="plan">Says speed, wind and the body.</param>
    /// <param name="wings">Right and left wing of each kind.</param>
    public static IReadOnlyList<WingGroups> Of(FlightPlan plan, IReadOnlyList<RecordedWing> wings)
    {
        var groups = wings.Where(wing => !wing.Placement.IsLeft).Select(wing => Of(plan, wing)).ToList();
        PresetSize main = wings[0].Wing.Preset.Size;
        double wingMass = wings.Sum(wing => (double)wing.Wing.Preset.Size.wingMass),
            volume = 4 * Math.PI / 3 * plan.Definition.FlightParts.Sum(part => (double)part.halfAxes.x * part.halfAxes.y * part.halfAxes.z);
        groups[0] = groups[0] with
        {
            WingLoading = main.insectMass * EarthGravity.Precise / wings.Sum(AreaOf),
            WingMassShare = 100 * wingMass / main.insectMass,
            BodyDensity = volume > 0 ? (main.insectMass - wingMass) / volume : double.NaN,
        };
        return groups;
    }

    private static WingGroups Of(FlightPlan plan, RecordedWing wing)
    {
        PresetSize size = wing.Wing.Preset.Size;
        double length = size.wingLength, chord = AreaOf(wing) / length, tip = 2 * wing.Flap * wing.Frequency * length,
            speed = math.length(plan.AirPastBody), viscosity = size.fluidDensity > k_Liquid ? k_Water : k_Air,
            mode = k_FirstMode / (2 * Math.PI) * Math.Sqrt(wing.Stiffness.Whole / (size.wingMass * length * length * length));
        return new WingGroups(wing.Wing.Name)
        {
            Flap = math.degrees((double)wing.Flap),
            TipSpeed = tip,
            Reynolds = size.fluidDensity * tip * chord / viscosity,
            ReducedFrequency = Math.PI * wing.Frequency * chord / tip,
            Strouhal = speed > 0 ? wing.Frequency * 2 * length * Math.Sin(0.5 * wing.Flap) / speed : double.NaN,
            StiffnessRatio = wing.Stiffness.Whole / wing.Stiffness.Usual,
            BendOverTwist = wing.Stiffness.Whole / wing.Stiffness.Torsional,
            StructuralRatio = mode / wing.Frequency,
            HingeShare = 100 * Math.Abs(wing.Placement.Hinge.x) / wing.Placement.Length,
        };
    }

    // Square metres, at rest.
    private static double AreaOf(RecordedWing wing)
    {
        double doubled = 0;
        for (int k = 0; k < wing.Triangles.Length; k += 3)
        {
            float3 a = wing.Rest[wing.Triangles[k]], b = wing.Rest[wing.Triangles[k + 1]], c = wing.Rest[wing.Triangles[k + 2]];
            doubled += math.length(math.cross(b - a, c - a));
        }

        double length = wing.Wing.Preset.Size.wingLength;
        return 0.5 * doubled * length * length;
    }
}
