using Alate.Flight;

namespace Alate.Cli;

/// <summary>Questions about numbers of an insect that are so far from real ones that their unit may be another one.</summary>
internal static class UnitDoubts
{
    /// <summary>Least flap and feather of a wing that beats, degrees from end to end.</summary>
    private const double k_LeastRange = 5;

    /// <summary>Least share of the wing's length that a distance on the insect has, and that a vein is wide.</summary>
    private const double k_LeastDistance = 2e-3, k_LeastVein = 1e-4, k_MostVein = 0.3;

    /// <summary>Most wing lengths that a place on the insect is from the middle of its thorax, or a part of its body is long.</summary>
    private const double k_MostDistance = 2;

    /// <summary>Most times its top speed that an insect is flown.</summary>
    private const double k_MostSpeed = 2;

    /// <summary>Largest phase of a harmonic in radians, and the largest that anyone writes in degrees.</summary>
    private const double k_RadianPhase = 2 * Math.PI, k_DegreePhase = 720;

    /// <summary>Largest difference of a phase from the number that was written, degrees.</summary>
    private const double k_Written = 1e-4;

    /// <summary>Densities between which there is neither a gas nor a liquid to fly in, and the least one, kg/m³.</summary>
    private const double k_Thin = 0.3, k_Dense = 2, k_Light = 600;

    private static readonly string[] s_Ranges = ["flapRangeDegrees", "featherRangeDegrees"];

    /// <summary>One question for each doubt, with the number and, of an insect file, its key.</summary>
    public static IEnumerable<string> Of(FlightPlan plan, IReadOnlyList<RecordedWing> wings)
    {
        if (AboutAngle("The pitch", plan.PitchDegrees, FlightNumbers.Pitch.Max) is string pitch)
            yield return pitch;
        double top = wings[0].Wing.Preset.Beat.maxSpeed;
        if (plan.Speed > k_MostSpeed * top)
        {
            yield return FormattableString.Invariant(
                $"The speed is {plan.Speed:0.###} m/s; the top speed of this insect is {top:0.###} m/s: is the unit m/s?");
        }

        double density = wings[0].Wing.Preset.Size.fluidDensity;
        if (density is < k_Thin or > k_Dense and < k_Light)
        {
            yield return FormattableString.Invariant(
                $"The fluid's density is {density:0.######} kg/m³; air has 1.2 and water 1000: is the unit kg/m³?");
        }

        double span = wings[0].Wing.Preset.Size.wingLength;
        foreach (BodyEllipsoid part in plan.Definition.FlightParts)
        {
            if (AboutDistance("A part of the body", part.centre, span) is string distance)
                yield return distance;
            double least = math.cmin(part.halfAxes), most = math.cmax(part.halfAxes);
            if (least < k_LeastDistance * span || most > k_MostDistance * span)
            {
                yield return FormattableString.Invariant($"A part of the body has half axes of {1e3 * least:G3} to {1e3 * most:G3} mm, ")
                    + FormattableString.Invariant($"beside wings of {1e3 * span:0.##} mm: is the unit mm?");
            }
        }

        if (AboutDistance("The middle of the feet", wings[0].Wing.Preset.Rest.feet, span) is string feet)
            yield return feet;
        foreach (RecordedWing wing in wings.Where(wing => !wing.Placement.IsLeft))
        {
            foreach (string doubt in Of(wing))
                yield return doubt;
        }
    }

    private static IEnumerable<string> Of(RecordedWing wing)
    {
        string name = wing.Wing.Name;
        WingPreset preset = wing.Wing.Preset;
        double length = preset.Size.wingLength;
        if (preset.Kinematics.prescribed)
        {
            foreach (string doubt in AboutMotion(name, preset.Kinematics, math.degrees((double)wing.Flap)))
                yield return doubt;
        }

        foreach ((string group, _, IReadOnlyList<PresetKey> keys) in InsectKeys.Groups)
        {
            foreach (PresetKey key in keys.Where(key => key.Shape is NumberShape && key.Name.EndsWith("Degrees", StringComparison.Ordinal)))
            {
                double value = double.Parse(FileValue.Of(key.Of(preset)).Text, CultureInfo.InvariantCulture);
                string subject = $"{group}.{key.Name} of the {name}";
                string doubt = s_Ranges.Contains(key.Name)
                    ? AboutRange(subject, value) : AboutAngle(subject, value, (double)((NumberShape)key.Shape).Most);
                if (doubt != null && !(preset.Kinematics.prescribed && group == InsectKeys.Beat))
                    yield return doubt;
            }
        }

        if (Array.Exists(wing.Wing.Skeleton.Chains, chain => chain.flexuralStiffness is { Length: > 0 })
            && AboutStiffness(name, wing.Stiffness.Whole, wing.Stiffness.Usual) is string stiffness)
        {
            yield return stiffness;
        }

        if (AboutDistance($"The hinge of the {name}", wing.Placement.Hinge, length) is string hinge)
            yield return hinge;
        float widest = wing.Wing.Skeleton.Chains.SelectMany(chain => chain.veinWidths ?? []).DefaultIfEmpty().Max();
        if (widest > 0 && (widest < k_LeastVein * 1e3 * length || widest > k_MostVein * 1e3 * length))
        {
            yield return FormattableString.Invariant(
                $"The widest vein of the {name} is {widest:G3} mm wide, on a wing of {1e3 * length:0.##} mm: is the unit mm?");
        }
    }

    // The file has one unit for angles and phases: others come from two papers.
    private static IEnumerable<string> AboutMotion(string name, PresetKinematics motion, double flap)
    {
        if (AboutRange($"The prescribed flap of the {name}", flap) is string range)
            yield return range;
        double feather = 2 * (motion.feather.harmonics ?? []).Select(harmonic => Math.Abs((double)harmonic.x)).DefaultIfEmpty().Max();
        if (AboutRange($"The prescribed feather of the {name}", feather) is string turned)
            yield return turned;
        double[] phases = new[] { motion.flap, motion.sweep, motion.feather, motion.tilt }
            .SelectMany(series => series.harmonics ?? []).Select(harmonic => (double)harmonic.y).Where(phase => phase != 0).ToArray();
        double largest = phases.Select(Math.Abs).DefaultIfEmpty().Max();
        // A single one may be 1.5°; those that are written with more digits are π over something.
        int digits = phases.Length > 1 ? 0 : 1;
        if (largest <= k_RadianPhase && phases.Any(phase => Math.Abs(phase - Math.Round(phase, digits)) > k_Written))
            yield return AskForRadians($"The largest prescribed phase of the {name}", largest);
        if (largest > k_DegreePhase)
        {
            yield return FormattableString.Invariant(
                $"The largest prescribed phase of the {name} is {largest:0.#}°: were degrees meant, where the file says radians?");
        }
    }

    /// <summary>Doubt about a flap or a feather; null for none.</summary>
    /// <param name="subject">What has it.</param>
    /// <param name="degrees">From end to end; 0 is a wing that is held.</param>
    public static string AboutRange(string subject, double degrees) =>
        degrees is > 0 and < k_LeastRange ? AskForRadians(subject, degrees) : null;

    /// <summary>Doubt about another angle; null for none. An angle in degrees is seldom below π and not whole.</summary>
    /// <param name="subject">What has it.</param>
    /// <param name="degrees">The angle.</param>
    /// <param name="most">The largest that is allowed, degrees: one in radians would be below.</param>
    public static string AboutAngle(string subject, double degrees, double most) =>
        degrees != Math.Round(degrees) && Math.Abs(math.degrees(degrees)) < 1.001 * most ? AskForRadians(subject, degrees) : null;

    /// <summary>Doubt about a measured stiffness; null for none.</summary>
    /// <param name="name">Name of the wing.</param>
    /// <param name="stiffness">Of all its chains, N m².</param>
    /// <param name="usual">Measured on wings of its length, N m².</param>
    public static string AboutStiffness(string name, double stiffness, double usual) =>
        stiffness > GroupBound.MostStiffness * usual || stiffness * GroupBound.MostStiffness < usual
            ? FormattableString.Invariant(
                $"The {name} has an EI of {stiffness:0.0e-0} N m², {stiffness / usual:G2} of what Combes and Daniel 2003 ")
                + "measured on wings of its length: is the unit N m²?"
            : null;

    /// <summary>Doubt about a place on the insect; null for none.</summary>
    /// <param name="subject">What is there.</param>
    /// <param name="place">From the middle of the thorax, metres; that middle itself is none.</param>
    /// <param name="length">Length of the wing, metres.</param>
    public static string AboutDistance(string subject, float3 place, double length)
    {
        double distance = math.length(place);
        return distance > 0 && (distance < k_LeastDistance * length || distance > k_MostDistance * length)
            ? FormattableString.Invariant(
                $"{subject} is {1e3 * distance:G3} mm from the middle of the thorax, beside wings of {1e3 * length:0.##} mm: ")
                + (distance < length ? "were metres meant?" : "is the unit mm?")
            : null;
    }

    private static string AskForRadians(string subject, double degrees) =>
        FormattableString.Invariant($"{subject} is {degrees:0.####}°: were radians meant? ")
        + FormattableString.Invariant($"{degrees:0.####} rad are {math.degrees(degrees):0.#}°.");
}
