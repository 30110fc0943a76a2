using System.CommandLine;
using Alate.Crowds;

namespace Alate.Cli;

/// <summary><c>bake SPECIES</c>: writes loops of an insect in formats that other programs read.</summary>
internal static class BakeCommand
{
    private const int k_MostTriangles = 1000000;
    private const double k_LeastBeats = 0.01, k_MostBeats = 1000, k_MostFps = 1000;

    private static readonly string[] s_Clips = [.. BakeMotion.Names, .. PlayedClips.Names];

    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"The insect: {KnownSpecies.Names}. Not with --mesh.",
        };
        var mesh = new Option<string>("--mesh")
        {
            HelpName = "FILE.obj",
            Description = "A wing of your own, at rest. Needs --skeleton and --species.",
        };
        var skeleton =
            new Option<string>("--skeleton") { HelpName = "FILE.json", Description = "The skeleton of that wing, in the mesh's space." };
        var preset = new Option<string>("--species")
        {
            HelpName = "PRESET",
            Description = "The species whose size, beat and stiffness that wing takes.",
        };
        var clips = new Option<string>("--clips")
        {
            HelpName = "NAMES",
            DefaultValueFactory = _ => "cruise",
            Description = $"What to bake, joined by commas: {string.Join(", ", s_Clips)}.",
        };
        Option<BakeFormat?> format = Choice.Optional<BakeFormat>("--format", "What to write. [default: openvat]", new()
        {
            ["openvat"] = BakeFormat.OpenVat,
            ["gltf-skin"] = BakeFormat.GltfSkin,
            ["gltf-morph"] = BakeFormat.GltfMorph,
            ["usd"] = BakeFormat.Usd,
        });
        Option<int?> frames = Numbers.OptionalCount(
            "--frames", "N", BakeSettings.MinFrames, BakeSettings.MaxFrames,
            $"Frames of a loop, {BakeSettings.MinFrames} to {BakeSettings.MaxFrames}. [default: {BakeSettings.DefaultFrames}]");
        Option<double?> beats = Numbers.Optional(
            "--beats-per-second", "N", k_LeastBeats, k_MostBeats,
            "Slows or hastens what is written: loops a second. [default: the insect's own]");
        Option<double?> fps = Numbers.Optional(
            "--fps", "N", 1, k_MostFps, "With --beats-per-second: frames a second, in place of --frames; a loop ends on a whole one.");
        Option<int?> triangles = Numbers.OptionalCount(
            "--triangles", "N", SmallerBake.MinTriangles, k_MostTriangles,
            $"Most triangles of the mesh, {SmallerBake.MinTriangles} to {k_MostTriangles}. [default: all]");
        Option<BakeNormals?> normals = Choice.Optional<BakeNormals>(
            "--normals", "Normals in a texture of their own, or in the lower half. [default: separate]", new()
            {
                ["separate"] = BakeNormals.Separate,
                ["packed"] = BakeNormals.Packed,
            });
        Option<int?> size = Numbers.OptionalCount(
            "--max-size", "N", BakeLayout.MinMaxSize, BakeLayout.MaxMaxSize,
            $"Longest side of a texture, pixels, {BakeLayout.MinMaxSize} to "
            + $"{BakeLayout.MaxMaxSize}. [default: {BakeLayout.DefaultMaxSize}]");
        Option<InsectVariant?> variant = FlightOptions.Variant();
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/bake-SPECIES]" };
        var command = new Command(
            "bake", "Bakes loops of an insect for other programs: OpenVAT textures, glTF with joints or shapes, or USD.")
        {
            species, clips, format, frames, beats, fps, triangles, normals, size, variant, mesh, skeleton, preset, folder,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            InsectVariant chosen = parsed.GetValue(variant) ?? InsectVariant.Standard;
            string meshFile = parsed.GetValue(mesh), skeletonFile = parsed.GetValue(skeleton);
            InsectDefinition definition = KnownSpecies.Find(
                NameOf(parsed.GetValue(species), parsed.GetValue(preset), meshFile, skeletonFile), chosen);
            List<string> named = Clips(parsed.GetValue(clips));
            CheckPlayed(named.Find(PlayedClips.Names.Contains), chosen, parsed.GetValue(format), meshFile);
            string name = meshFile == null ? definition.Name : Path.GetFileNameWithoutExtension(meshFile);
            BakeReport.Run(
                new BakePlan
                {
                    Species = definition,
                    Variant = chosen,
                    Motions = [.. named.Where(clip => !PlayedClips.Names.Contains(clip)).Select(BakeMotion.Find)],
                    Played = [.. named.Where(PlayedClips.Names.Contains)],
                    Format = parsed.GetValue(format) ?? BakeFormat.OpenVat,
                    Frames = Frames(parsed.GetValue(frames), parsed.GetValue(fps), parsed.GetValue(beats)),
                    BeatsPerSecond = parsed.GetValue(beats),
                    Triangles = parsed.GetValue(triangles),
                    Normals = parsed.GetValue(normals) ?? BakeNormals.Separate,
                    MaxSize = parsed.GetValue(size) ?? BakeLayout.DefaultMaxSize,
                    MeshFile = meshFile,
                    SkeletonFile = skeletonFile,
                    Folder = parsed.GetValue(folder) ?? Path.Combine("out", "bake-" + name),
                },
                output);
            return 0;
        });
        return command;
    }

    private static string NameOf(string species, string preset, string mesh, string skeleton)
    {
        if ((mesh == null) != (skeleton == null))
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

    private const string k_Examples =
        "Examples:\n"
        + "  bake monarch --clips cruise,hover,rest\n"
        + "  bake firefly --format gltf-skin --out blender\n"
        + "  bake swallowtail --clips cruise --format gltf-morph --frames 24\n"
        + "  bake monarch --format gltf-skin --fps 24 --beats-per-second 2\n"
        + "  bake dragonfly --format usd --clips cruise,hover\n"
        + "  bake monarch --variant flight --clips hover,climb,turn-left\n"
        + "  bake monarch --variant flight --format gltf-skin --clips cruise,land,take-off --fps 24 --beats-per-second 2\n"
        + "  bake --mesh wing.obj --skeleton wing.json --species firefly\n\n"
        + "Writes into the output folder:\n"
        + "  openvat     SPECIES_vat/ with SPECIES.png, SPECIES-vnrm.png, SPECIES-remap_info.json and SPECIES.glb\n"
        + "  gltf-skin   SPECIES-skin.glb, joints that turn and move the wings\n"
        + "  gltf-morph  SPECIES-morph.glb, a shape for each frame\n"
        + "  usd         SPECIES_usd/ with SPECIES.usda, joints as in gltf-skin, and its pictures\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
