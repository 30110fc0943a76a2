using System.CommandLine;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary>The options of <c>bake</c>.</summary>
internal sealed class BakeOptions
{
    private const int k_MostTriangles = 1000000;
    private const double k_LeastBeats = 0.01, k_MostBeats = 1000, k_MostFps = 1000;

    private static readonly string[] s_Clips = [.. BakeMotion.Names, .. PlayedClips.Names];

    private readonly Argument<string> m_Species = new("SPECIES")
    {
        Arity = ArgumentArity.ZeroOrOne,
        Description = $"The insect: {KnownSpecies.Names}. Not with --mesh.",
    };

    private readonly Option<string> m_Clips = new("--clips")
    {
        HelpName = "NAMES",
        DefaultValueFactory = _ => "cruise",
        Description = $"What to bake, joined by commas: {string.Join(", ", s_Clips)}.",
    };

    private readonly Option<BakeFormat?> m_Format = Choice.Optional<BakeFormat>("--format", "What to write. [default: openvat]", new()
    {
        ["openvat"] = BakeFormat.OpenVat,
        ["gltf-skin"] = BakeFormat.GltfSkin,
        ["gltf-morph"] = BakeFormat.GltfMorph,
        ["usd"] = BakeFormat.Usd,
    });

    private readonly Option<int?> m_Frames = Numbers.OptionalCount(
        "--frames", "N", BakeSettings.MinFrames, BakeSettings.MaxFrames,
        $"Frames of a loop, {BakeSettings.MinFrames} to {BakeSettings.MaxFrames}. [default: {BakeSettings.DefaultFrames}]");

    private readonly Option<double?> m_Beats = Numbers.Optional(
        "--beats-per-second", "N", k_LeastBeats, k_MostBeats,
        "Slows or hastens what is written: loops a second. [default: the insect's own]");

    private readonly Option<double?> m_Fps = Numbers.Optional(
        "--fps", "N", 1, k_MostFps, "With --beats-per-second: frames a second, in place of --frames; a loop ends on a whole one.");

    private readonly Option<int?> m_Triangles = Numbers.OptionalCount(
        "--triangles", "N", SmallerBake.MinTriangles, k_MostTriangles,
        $"Most triangles of the mesh, {SmallerBake.MinTriangles} to {k_MostTriangles}. [default: all]");

    private readonly Option<BakeNormals?> m_Normals = Choice.Optional<BakeNormals>(
        "--normals", "Normals in a texture of their own, or in the lower half. [default: separate]", new()
        {
            ["separate"] = BakeNormals.Separate,
            ["packed"] = BakeNormals.Packed,
        });

    private readonly Option<int?> m_Size = Numbers.OptionalCount(
        "--max-size", "N", BakeLayout.MinMaxSize, BakeLayout.MaxMaxSize,
        $"Longest side of a texture, pixels, {BakeLayout.MinMaxSize} to "
        + $"{BakeLayout.MaxMaxSize}. [default: {BakeLayout.DefaultMaxSize}]");

    private readonly Option<InsectVariant?> m_Variant = FlightOptions.Variant();

    private readonly Option<string> m_Mesh = new("--mesh")
    {
        HelpName = "FILE.obj",
        Description = "A wing of your own, at rest. Needs --skeleton and --species.",
    };

    private readonly Option<string> m_Skeleton =
        new("--skeleton") { HelpName = "FILE.json", Description = "The skeleton of that wing, in the mesh's space." };

    private readonly Option<string> m_Preset = new("--species")
    {
        HelpName = "PRESET",
        Description = "The species whose size, beat and stiffness that wing takes.",
    };

    private readonly Option<string> m_Out =
        new("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/bake-SPECIES]" };

    public void AddTo(Command command)
    {
        command.Arguments.Add(m_Species);
        foreach (Option option in (Option[])
        [
            m_Clips, m_Format, m_Frames, m_Beats, m_Fps, m_Triangles, m_Normals, m_Size, m_Variant, m_Mesh, m_Skeleton, m_Preset, m_Out,
        ])
        {
            command.Options.Add(option);
        }
    }

    /// <summary>The bake that is asked for.</summary>
    /// <exception cref="UserException">There is no such insect or clip, or options do not go together.</exception>
    public BakePlan Plan(ParseResult parsed)
    {
        InsectVariant variant = parsed.GetValue(m_Variant) ?? InsectVariant.Standard;
        string mesh = parsed.GetValue(m_Mesh);
        InsectDefinition species = KnownSpecies.Find(Species(parsed, mesh), variant);
        List<string> clips = Clips(parsed.GetValue(m_Clips));
        CheckPlayed(clips.Find(PlayedClips.Names.Contains), variant, parsed.GetValue(m_Format), mesh);
        string name = mesh == null ? species.Name : Path.GetFileNameWithoutExtension(mesh);
        return new BakePlan
        {
            Species = species,
            Variant = variant,
            Motions = [.. clips.Where(clip => !PlayedClips.Names.Contains(clip)).Select(BakeMotion.Find)],
            Played = [.. clips.Where(PlayedClips.Names.Contains)],
            Format = parsed.GetValue(m_Format) ?? BakeFormat.OpenVat,
            Frames = Frames(parsed.GetValue(m_Frames), parsed.GetValue(m_Fps), parsed.GetValue(m_Beats)),
            BeatsPerSecond = parsed.GetValue(m_Beats),
            Triangles = parsed.GetValue(m_Triangles),
            Normals = parsed.GetValue(m_Normals) ?? BakeNormals.Separate,
            MaxSize = parsed.GetValue(m_Size) ?? BakeLayout.DefaultMaxSize,
            MeshFile = mesh,
            SkeletonFile = parsed.GetValue(m_Skeleton),
            Folder = parsed.GetValue(m_Out) ?? Path.Combine("out", "bake-" + name),
        };
    }

    private string Species(ParseResult parsed, string mesh)
    {
        string species = parsed.GetValue(m_Species), preset = parsed.GetValue(m_Preset);
        if ((mesh == null) != (parsed.GetValue(m_Skeleton) == null))
            throw new UserException("A wing of your own needs both --mesh and --skeleton.");
        if (mesh == null && preset != null)
            throw new UserException("--species goes with --mesh and --skeleton; name a species of the catalogue as 'bake SPECIES'.");
        if (mesh != null && species != null)
            throw new UserException("With --mesh the species is named by --species, not as an argument.");
        string known = string.Join(", ", InsectCatalogue.Names);
        return species ?? preset
            ?? throw new UserException(mesh == null ? $"Which species? Known: {known}." : $"--mesh needs --species. Known: {known}.");
    }

    private static int Frames(int? frames, double? fps, double? beats)
    {
        if (fps == null)
            return frames ?? BakeSettings.DefaultFrames;
        if (frames != null)
            throw new UserException("--fps says how many frames a loop has: leave --frames away.");
        return beats == null
            ? throw new UserException("--fps goes with --beats-per-second, so that a loop ends on a whole frame.")
            : BakePlan.FramesOf(fps.Value, beats.Value);
    }

    private static List<string> Clips(string names)
    {
        List<string> named = [];
        foreach (string name in names.Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries))
        {
            string known = Array.Find(s_Clips, clip => clip.Equals(name, StringComparison.OrdinalIgnoreCase))
                ?? throw new UserException($"There is no clip '{name}'. Known: {string.Join(", ", s_Clips)}.");
            if (named.Contains(known))
                throw new UserException($"Clip '{known}' is asked for twice.");
            named.Add(known);
        }

        return named.Count > 0 ? named : throw new UserException($"No clip is asked for. Known: {string.Join(", ", s_Clips)}.");
    }

    private static void CheckPlayed(string clip, InsectVariant variant, BakeFormat? format, string mesh)
    {
        if (clip == null)
            return;
        if (mesh != null || variant != InsectVariant.Flight)
        {
            throw new UserException(
                $"Clip '{clip}' is played by an insect that flies by its own wings: add --variant flight, and no --mesh.");
        }

        if (format is not (BakeFormat.GltfSkin or BakeFormat.Usd))
        {
            throw new UserException(
                $"Clip '{clip}' goes from one place to another: add --format gltf-skin or --format usd, whose joints move.");
        }
    }
}
