using System.CommandLine;

namespace Alate.Cli;

/// <summary>The options of <c>fly</c>.</summary>
internal sealed class FlyOptions
{
    private const int k_MostPatches = 1000000;

    private readonly Option<double?> m_Speed = FlightOptions.Speed();

    private readonly Option<double> m_Climb = Numbers.Option(FlightNumbers.Climb);

    private readonly Option<double> m_Pitch = Numbers.Option(FlightNumbers.Pitch);

    private readonly Option<double?> m_Seconds = Numbers.Optional(FlightNumbers.Seconds);

    private readonly Option<double[]> m_Wind = Numbers.Vector(FlightNumbers.Wind);

    private readonly Option<double?> m_Induced = Numbers.Switch(FlightNumbers.Induced);

    private readonly Option<bool> m_AddedMass =
        new("--added-mass") { Description = "The air that the wings carry along where they are accelerated across their surface." };

    private readonly Option<double?> m_Lag = Numbers.Optional(FlightNumbers.Lag);

    private readonly Option<double> m_Elasticity = Numbers.Option(FlightNumbers.Elasticity);

    private readonly Option<int?> m_Substeps = FlightOptions.Substeps();

    private readonly Option<string> m_Elements = new("--elements")
    {
        HelpName = "triangles|N",
        DefaultValueFactory = _ => WingRigSettings.Default.patchCount.ToString(),
        Description = "What meets the air: every triangle, or about N patches of them, 1 to 1000000.",
    };

    private readonly Option<CoefficientSet?> m_Coefficients = Choice.Optional<CoefficientSet>(
        "--coefficients", "Lift and drag against the angle of attack. [default: the preset's]", new()
        {
            ["dickinson"] = CoefficientSet.Dickinson1999,
            ["paper"] = CoefficientSet.Paper,
            ["flatplate"] = CoefficientSet.FlatPlate,
            ["dragonfly"] = CoefficientSet.Dragonfly,
        });

    private readonly Option<ModelReading?> m_Preset = Choice.Optional<ModelReading>(
        "--preset", "The paper's equations as printed, or as resolved. [default: physical]", new()
        {
            ["physical"] = ModelReading.Physical,
            ["paper"] = ModelReading.Paper,
        });

    private readonly Option<InsectVariant?> m_Variant = FlightOptions.Variant();

    private readonly Option<bool> m_NoWave = new("--no-wave") { Description = "No deformation wave: the whole wing is driven at once." };

    private readonly Option<bool> m_Rigid = new("--rigid") { Description = "A stiff wing for comparison: no wave and no bending." };

    private readonly Option<string[]> m_Mesh = Files(
        "--mesh", "FILE.obj", "A wing of your own, at rest; two for a fore and a hind wing. Needs --skeleton and --species.");

    private readonly Option<string[]> m_Skeleton = Files(
        "--skeleton", "FILE.json", "The skeleton of each of these wings, in its mesh's space.");

    private readonly Option<string[]> m_Texture = Files(
        "--texture", "FILE.png", "The picture on each of these wings. [default: that of the mesh's material]");

    private readonly Option<string> m_Species = new("--species")
    {
        HelpName = "PRESET",
        Description = "The species whose size, beat and stiffness that wing takes.",
    };

    private readonly Option<string> m_Kinematics = new("--kinematics")
    {
        HelpName = "FILE.json",
        Description = "A motion that is prescribed, as measured, for one wing or all, in place of the species' beat.",
    };

    private readonly Option<PictureView?> m_View = FlightOptions.View();

    private readonly Option<bool> m_NoPictures =
        new("--no-pictures") { Description = "Neither strip.png nor stretch.png, with --free no path.png: for many runs." };

    private readonly Option<string> m_Out = new("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/SPECIES]" };

    /// <summary>Adds the options of a flight whose beat alone counts: no time, no even wake, no pictures of its own.</summary>
    public void AddBeatTo(Command command)
    {
        Option[] others = [m_Seconds, m_Induced, m_Texture, m_NoPictures];
        foreach (Option option in All.Except(others))
            command.Options.Add(option);
    }

    public void AddTo(Command command)
    {
        foreach (Option option in All)
            command.Options.Add(option);
    }

    private Option[] All =>
    [
        m_Speed, m_Climb, m_Pitch, m_Seconds, m_Wind, m_Induced, m_AddedMass, m_Lag, m_Elasticity, m_Substeps, m_Elements,
        m_Coefficients, m_Preset,
        m_Variant, m_NoWave, m_Rigid, m_Mesh, m_Skeleton, m_Texture, m_Species, m_Kinematics, m_View, m_NoPictures, m_Out,
    ];

    /// <summary>Simulated time; null is the default.</summary>
    public double? Seconds(ParseResult parsed) => parsed.GetValue(m_Seconds);

    /// <summary>Checks the options of a free flight, which would change nothing in it.</summary>
    /// <exception cref="UserException">One is for flights on the spot alone.</exception>
    public void CheckFree(ParseResult parsed)
    {
        CheckFree(parsed, m_Seconds, m_NoPictures);
    }

    /// <summary>Checks the options of a flight by a trim, which has its own beat and pitch.</summary>
    /// <exception cref="UserException">One is for other flights alone.</exception>
    public void CheckTrimmed(ParseResult parsed) => CheckFree(parsed, m_Speed, m_Climb, m_Substeps, m_View);

    /// <summary>True where a speed is given.</summary>
    public bool HasSpeed(ParseResult parsed) => parsed.GetValue(m_Speed) != null;

    private void CheckFree(ParseResult parsed, params Option[] also)
    {
        Option[] both = [m_Variant, m_Out, .. also];
        Option given = All.Except(both).FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false });
        if (given != null)
            throw new UserException($"{given.Name} is for flights on the spot; it does not go with --free.");
        if (parsed.GetValue(m_Variant) is { } variant and not InsectVariant.Flight)
            throw new UserException($"--free flies with the variant flight; it does not go with --variant {KnownSpecies.Word(variant)}.");
    }

    /// <summary>Returns true where pictures are wanted.</summary>
    public bool IsDrawn(ParseResult parsed) => !parsed.GetValue(m_NoPictures);

    /// <summary>Option that names the folder of the files.</summary>
    public Option Out => m_Out;

    /// <summary>Folder of the files; null for the default.</summary>
    public string Folder(ParseResult parsed) => parsed.GetValue(m_Out);

    /// <summary>Makes the plan that the user asked for.</summary>
    /// <exception cref="UserException">Options that exclude or need each other.</exception>
    /// <param name="parsed">The command line.</param>
    /// <param name="species">What it names.</param>
    /// <param name="flown">The insect of a run that is flown again; null for that of the name.</param>
    public FlightPlan Plan(ParseResult parsed, string species, InsectDefinition flown = null)
    {
        string name = species ?? parsed.GetValue(m_Species);
        InsectDefinition named = flown ?? (KnownSpecies.IsFile(name) ? KnownSpecies.Find(name)
            : InsectCatalogue.TryFind(name, out InsectDefinition known) ? known : null);
        var plan = new FlightPlan
        {
            Definition = named,
            MeshFile = File(parsed, m_Mesh, 0),
            SkeletonFile = File(parsed, m_Skeleton, 0),
            TextureFile = File(parsed, m_Texture, 0),
            HindMeshFile = File(parsed, m_Mesh, 1),
            HindSkeletonFile = File(parsed, m_Skeleton, 1),
            HindTextureFile = File(parsed, m_Texture, 1),
            KinematicsFile = parsed.GetValue(m_Kinematics),
            Speed = parsed.GetValue(m_Speed)
                ?? (named == null ? 0 : FlightPlan.CruiseOf(named)),
            Variant = parsed.GetValue(m_Variant) ?? InsectVariant.Standard,
            Climb = parsed.GetValue(m_Climb),
            PitchDegrees = parsed.GetValue(m_Pitch),
            Seconds = parsed.GetValue(m_Seconds),
            Wind = parsed.GetValue(m_Wind) is { Length: 3 } wind ? wind : [0, 0, 0],
            Induced = parsed.GetValue(m_Induced) is double factor and > 0 ? new InducedFlow(factor) : null,
            AddedMass = parsed.GetValue(m_AddedMass),
            Lag = parsed.GetValue(m_Lag),
            Elasticity = parsed.GetValue(m_Elasticity),
            Substeps = parsed.GetValue(m_Substeps),
            Patches = Patches(parsed.GetValue(m_Elements)),
            Coefficients = parsed.GetValue(m_Coefficients),
            Preset = parsed.GetValue(m_Preset) ?? ModelReading.Physical,
            Column = parsed.GetValue(m_Rigid) ? ComparisonColumn.RigidWing
                : parsed.GetValue(m_NoWave) ? ComparisonColumn.NoWave : ComparisonColumn.FullModel,
            View = parsed.GetValue(m_View) ?? PictureView.FrontLeft,
            IsDrawn = IsDrawn(parsed),
            Folder = parsed.GetValue(m_Out),
        };
        plan = named == null ? plan with { Species = name } : plan;
        Check(plan, named, species, parsed.GetValue(m_Species));
        return plan;
    }

    /// <summary>Parses the number of patches that meet the air; 0 is every triangle.</summary>
    internal static int Patches(string text)
    {
        if (text.ToLowerInvariant() == "triangles")
            return 0;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int count) && count is >= 1 and <= k_MostPatches)
            return count;
        throw new UserException($"--elements takes 'triangles' or a number of patches from 1 to {k_MostPatches}, not {Quote.Of(text)}.");
    }

    private static Option<string[]> Files(string name, string unit, string description) =>
        new(name) { HelpName = unit, Description = description, AllowMultipleArgumentsPerToken = true, Arity = new ArgumentArity(1, 2) };

    private static string File(ParseResult parsed, Option<string[]> option, int index) =>
        parsed.GetValue(option)?.ElementAtOrDefault(index);

    private static void Check(FlightPlan plan, InsectDefinition named, string species, string preset)
    {
        string known = string.Join(", ", InsectCatalogue.Names);
        if ((plan.MeshFile == null) != (plan.SkeletonFile == null))
            throw new UserException("A wing of your own needs both --mesh and --skeleton.");
        if ((plan.HindMeshFile == null) != (plan.HindSkeletonFile == null))
            throw new UserException("Each --mesh needs a --skeleton.");
        if (plan.TextureFile != null && plan.MeshFile == null || plan.HindTextureFile != null && plan.HindMeshFile == null)
            throw new UserException("--texture goes with --mesh, one picture for each.");
        if (plan.HindMeshFile != null && named is { Wings.Count: < 2 })
            throw new UserException($"The {named.DisplayName} has one kind of wing, so that --mesh takes one file.");
        if (plan.MeshFile == null && preset != null)
            throw new UserException("--species goes with --mesh and --skeleton; name a species of the catalogue as 'fly SPECIES'.");
        if (plan.MeshFile != null && species != null)
            throw new UserException("With --mesh the species is named by --species, not as an argument.");
        if (plan.Species == null)
            throw new UserException(plan.MeshFile == null ? $"Which species? Known: {known}." : $"--mesh needs --species. Known: {known}.");
        if (plan.Lag != null && plan.Column != ComparisonColumn.FullModel)
            throw new UserException($"--lag and --{plan.Column.Name} exclude each other.");
    }
}
