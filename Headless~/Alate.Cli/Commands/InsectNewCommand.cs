using System.CommandLine;
using Alate.Authoring;

namespace Alate.Cli;

/// <summary><c>insect new DIR</c>: makes an insect file with meshes, skeletons and textures from pictures or meshes of its wings.</summary>
internal static class InsectNewCommand
{
    /// <summary>Insect of the catalogue that one wing is like where nobody says, and that two are like.</summary>
    private const string k_One = "monarch";

    /// <inheritdoc cref="k_One"/>
    internal const string LikeOfTwo = "swallowtail";

    private const double k_Turn = 2 * Math.PI;

    private static readonly Quantity s_Length = new(
        "length", "mm", 0.5m, 1000m, ("mm", 1m), ("cm", 10m), ("m", 1000m), ("µm", 0.001m), ("um", 0.001m), ("in", 25.4m));

    private static readonly Quantity s_Unit = s_Length with { Least = 0.001m };

    private static readonly Quantity s_Mass = new(
        "mass", "mg", 0.01m, 10_000_000m, ("mg", 1m), ("g", 1000m), ("kg", 1_000_000m), ("µg", 0.001m), ("ug", 0.001m));

    private static readonly Quantity s_Frequency = new(
        "frequency", "Hz", 0.1m, 1000m, ("Hz", 1m), ("/s", 1m), ("/min", 1m / 60), ("kHz", 1000m), ("rad/s", (decimal)(1 / k_Turn)))
    {
        IsUnitKnown = true,
    };

    public static Command Create(TextWriter output)
    {
        var folder = new Argument<string>("DIR") { Description = "Where the files go; its name is that of the insect." };
        var wings = new Option<string[]>("--wing")
        {
            HelpName = "FILE",
            Description = "A PNG or JPEG of the wing, or of the fore and of the hind wing, each on plain or transparent ground; or its "
                + "mesh, OBJ or GLB, with the picture of its material.",
            AllowMultipleArgumentsPerToken = true,
            Arity = new ArgumentArity(1, 2),
        };
        var hinges = new Option<string[]>("--hinge")
        {
            HelpName = "X,Y",
            Description = "Where each wing turns, pixels from its picture's top left corner, or X,Y,Z in the space of its mesh; 'auto' for "
                + "one that is to be found. [default: where veins meet, else guessed]",
            AllowMultipleArgumentsPerToken = true,
            Arity = new ArgumentArity(1, 2),
        };
        var sides = new Option<string[]>("--leading")
        {
            HelpName = "SIDE",
            Description = $"The leading edge's side of each picture: {string.Join(", ", WingSource.Sides.Keys)} or auto. [default: up]",
            AllowMultipleArgumentsPerToken = true,
            Arity = new ArgumentArity(1, 2),
        };
        Option<int?> triangles = Numbers.OptionalCount(
            "--triangles", "N", WingTracingSettings.MinTriangles, WingFiles.MostTriangles,
            "Triangles of the mesh that is made of a picture; a mesh of more is written with fewer. [default: 1000 of a picture, all of a "
            + "mesh]");
        var lengths = new Option<string[]>("--length")
        {
            HelpName = "LENGTH",
            Description = "Length of the wing from hinge to tip, of the hind wing behind it, with units, such as 50mm 42mm. "
                + "[default of the hind wing: as --like's]",
            AllowMultipleArgumentsPerToken = true,
            Arity = new ArgumentArity(1, 2),
        };
        var mass = new Option<string>("--mass") { HelpName = "MASS", Description = "Mass of the insect with its unit, such as 1.6g." };
        var frequency = new Option<string>("--frequency")
        {
            HelpName = "FREQUENCY",
            Description = "Beats: 25Hz, 25/s or 1500/min; a number alone is in hertz.",
        };
        var like = new Option<string>("--like")
        {
            HelpName = "NAME",
            Description = $"Insect of the catalogue that has body and motion: {string.Join(", ", InsectCatalogue.Names)}. "
                + $"[default: {k_One}, of two wings {LikeOfTwo}]",
        };
        var body = new Option<string>("--body")
        {
            HelpName = "BODY",
            Description = "Mesh of the body, OBJ with X to the right, Y up, Z ahead, or GLB, from the middle of the thorax. [default: as "
                + "--like's]",
        };
        var unit = new Option<string>("--body-unit")
        {
            HelpName = "LENGTH",
            Description = "Length of one unit of that mesh, such as 1mm or 1m. [default of a GLB: 1m]",
        };
        var name = new Option<string>("--name") { HelpName = "NAME", Description = "Name of the insect. [default: that of DIR]" };
        var command = new Command("new", "Makes an insect file, with meshes, skeletons and textures, from pictures or meshes of its wings.")
        {
            folder, wings, hinges, sides, triangles, lengths, mass, frequency, like, body, unit, name,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            string path = parsed.GetValue(folder);
            string[] files = parsed.GetValue(wings) ?? [], far = parsed.GetValue(lengths) ?? [];
            if (files.Length == 0)
                throw new UserException("Which wing? --wing takes a picture or a mesh of it, or of the fore and of the hind wing.");
            if (far.Length == 0)
                throw new UserException("How long is the wing? --length, from hinge to tip with its unit, such as 50mm.");
            if (far.Length > files.Length)
                throw new UserException($"--length takes one length for each wing: {files.Length}, not {far.Length}.");
            InsectDefinition known = KnownSpecies.FindInCatalogue(parsed.GetValue(like) ?? (files.Length == 1 ? k_One : LikeOfTwo));
            if (known.Wings.Count < files.Length)
            {
                throw new UserException($"The {known.Name} has one kind of wing, so that two wings need another --like: "
                    + $"{string.Join(", ", InsectCatalogue.All.Where(insect => insect.Wings.Count > 1).Select(insect => insect.Name))}.");
            }

            decimal milligrams = s_Mass.Read("--mass", parsed.GetValue(mass)
                ?? throw new UserException("How heavy is the insect? --mass, with its unit, such as 1.6g."));
            decimal hertz = s_Frequency.Read("--frequency", parsed.GetValue(frequency)
                ?? throw new UserException("How often does it beat? --frequency, such as 25Hz."));
            List<decimal> millimetres = [.. far.Select(length => s_Length.Read("--length", length))];
            bool isGiven = millimetres.Count == files.Length;
            if (!isGiven)
                millimetres.Add(NewInsect.LengthBehind(known, millimetres[0]));
            var insect = new NewInsect(NameOf(parsed.GetValue(name), path), known, milligrams, hertz)
            {
                BodyMesh = BodyOf(parsed.GetValue(body), parsed.GetValue(unit)),
            };
            WingSource[] sources = WingSource.Read(
                files, parsed.GetValue(hinges) ?? [], parsed.GetValue(sides) ?? [], parsed.GetValue(triangles));
            Make(insect, sources, millimetres, isGiven, path, output);
            return 0;
        });
        return command;
    }

    private static void Make(NewInsect insect, WingSource[] files, List<decimal> lengths, bool isGiven, string path, TextWriter output)
    {
        insect = WithWings(insect, files, lengths, isGiven);
        using var folder = OutputFolder.Prepare(path, [.. insect.Files]);
        insect.Write(folder);
        folder.Commit();
        for (int k = 0; k < files.Length; k++)
        {
            output.WriteLine(FormattableString.Invariant($"{insect.Like.Wings[k].Name}, {lengths[k]:0.##} mm: ")
                + insect.Wings[k].Wing.Summary + (k == 0 ? "" : FormattableString.Invariant(
                    $" It points as far back as the {insect.Like.DisplayName}'s: {insect.Wings[k].Length:0.##} mm across the body.")));
        }

        string file = Path.Combine(path, insect.File);
        output.WriteLine($"Wrote {insect.File} and its wings into {path}; the .svg files show what was found.");
        if (files.Any(wing => wing.Hinge == null))
            output.WriteLine("Where the circle in one of them is not at the base of the wing, --hinge says the place, a wing each.");
        output.WriteLine($"  fly {file}\n  species {file} --check");
    }

    /// <summary>Gives an insect the wings that are found in files.</summary>
    /// <param name="insect">All but its wings.</param>
    /// <param name="files">Pictures or meshes of them, from front to back.</param>
    /// <param name="lengths">Lengths of them, millimetres.</param>
    /// <param name="isGiven">True where the last length is from hinge to tip, false where it is across the body.</param>
    /// <exception cref="UserException">A file shows no wing, or the numbers make no insect.</exception>
    internal static NewInsect WithWings(NewInsect insect, WingSource[] files, List<decimal> lengths, bool isGiven)
    {
        List<(FoundWing Wing, decimal Length)> wings = [.. files.Zip(lengths, (file, length) => (file.Find(), length))];
        if (files.Length > 1)
        {
            double across = WingTurn.TurnLike(wings[1].Wing, insect.Like.Wings[1]);
            // A length that nobody gave is across the body already.
            if (isGiven)
                wings[1] = (wings[1].Wing, (decimal)Math.Round((double)wings[1].Length * across, 2));
        }

        insect = insect with { Wings = wings };
        insect.Check();
        return insect;
    }

    private static (string File, decimal Unit)? BodyOf(string file, string unit)
    {
        if (file == null)
        {
            return unit == null
                ? null
                : throw new UserException("--body-unit is the length of a unit of the mesh of --body, which is missing.");
        }

        return (file, s_Unit.Read("--body-unit", unit ?? (GlbMesh.IsNamed(file) ? "1m" : null)
            ?? throw new UserException("How long is a unit of the body's mesh? --body-unit, with its unit, such as 1mm.")));
    }

    private static string NameOf(string given, string path)
    {
        string typed = given ?? Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(path)));
        string name = string.Concat(typed.ToLowerInvariant().Select(letter => letter is ' ' or '_' or '.' ? '-' : letter));
        bool fits = name.Length is > 0 and <= 40 && char.IsAsciiLetterLower(name[0])
            && name.All(letter => char.IsAsciiLetterLower(letter) || char.IsAsciiDigit(letter) || letter == '-');
        return fits ? name : throw new UserException(
            $"{Quote.Of(typed)} is no name of an insect: it has lower-case letters, digits and hyphens, and begins with a letter. "
            + "--name says one.");
    }

    private const string k_Examples =
        "Examples:\n"
        + "  insect new mymoth --wing wing.png --length 50mm --mass 1.6g --frequency 25Hz\n"
        + "  insect new mymoth --wing fore.png hind.jpg --length 5cm 3.8cm --mass 1600mg --frequency 1500/min --like fishfly\n"
        + "  insect new mymoth --wing fore.png hind.jpg --hinge auto 412,96 --length 5cm 3.8cm --mass 1.6g --frequency 25Hz\n"
        + "  insect new mywasp --wing fore.obj hind.obj --length 14mm --mass 90mg --frequency 110Hz --like dragonfly --body body.obj "
        + "--body-unit 1cm\n\n"
        + "Writes into DIR:\n"
        + "  NAME.insect.json                  the insect, for every command that takes a SPECIES\n"
        + "  wing.obj, wing.mtl, wing.png      mesh, material and texture of the wing; of two: fore and hind. An OBJ stays as it is\n"
        + "  wing.json                         its skeleton\n"
        + "  wing.svg                          what was found, drawn on the picture; of a mesh its outline and chains\n"
        + "  body.obj                          the mesh of --body\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
