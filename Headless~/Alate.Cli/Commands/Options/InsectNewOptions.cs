using System.CommandLine;
using Alate.Authoring;

namespace Alate.Cli;

/// <summary>The options of <c>insect new</c>.</summary>
internal sealed class InsectNewOptions
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

    private readonly Argument<string> m_Folder = new("DIR") { Description = "Where the files go; its name is that of the insect." };

    private readonly Option<string[]> m_Wings = OneOrTwo(
        "--wing", "FILE", "A PNG or JPEG of the wing, or of the fore and of the hind wing, each on plain or transparent ground; or its "
        + "mesh, OBJ or GLB, with the picture of its material.");

    private readonly Option<string[]> m_Hinges = OneOrTwo(
        "--hinge", "X,Y", "Where each wing turns, pixels from its picture's top left corner, or X,Y,Z in the space of its mesh; 'auto' for "
        + "one that is to be found. [default: where veins meet, else guessed]");

    private readonly Option<string[]> m_Sides = OneOrTwo(
        "--leading", "SIDE",
        $"The leading edge's side of each picture: {string.Join(", ", WingSource.Sides.Keys)} or auto. [default: up]");

    private readonly Option<int?> m_Triangles = Numbers.OptionalCount(
        "--triangles", "N", WingTracingSettings.MinTriangles, WingFiles.MostTriangles,
        "Triangles of the mesh that is made of a picture; a mesh of more is written with fewer. [default: 1000 of a picture, all of a "
        + "mesh]");

    private readonly Option<string[]> m_Lengths = OneOrTwo(
        "--length", "LENGTH", "Length of the wing from hinge to tip, of the hind wing behind it, with units, such as 50mm 42mm. "
        + "[default of the hind wing: as --like's]");

    private readonly Option<string> m_Mass =
        new("--mass") { HelpName = "MASS", Description = "Mass of the insect with its unit, such as 1.6g." };

    private readonly Option<string> m_Frequency = new("--frequency")
    {
        HelpName = "FREQUENCY",
        Description = "Beats: 25Hz, 25/s or 1500/min; a number alone is in hertz.",
    };

    private readonly Option<string> m_Like = new("--like")
    {
        HelpName = "NAME",
        Description = $"Insect of the catalogue that has body and motion: {string.Join(", ", InsectCatalogue.Names)}. "
            + $"[default: {k_One}, of two wings {LikeOfTwo}]",
    };

    private readonly Option<string> m_Body = new("--body")
    {
        HelpName = "BODY",
        Description = "Mesh of the body, OBJ with X to the right, Y up, Z ahead, or GLB, from the middle of the thorax. [default: as "
            + "--like's]",
    };

    private readonly Option<string> m_Unit = new("--body-unit")
    {
        HelpName = "LENGTH",
        Description = "Length of one unit of that mesh, such as 1mm or 1m. [default of a GLB: 1m]",
    };

    private readonly Option<string> m_Name =
        new("--name") { HelpName = "NAME", Description = "Name of the insect. [default: that of DIR]" };

    public void AddTo(Command command)
    {
        command.Arguments.Add(m_Folder);
        foreach (Option option in (Option[])
            [m_Wings, m_Hinges, m_Sides, m_Triangles, m_Lengths, m_Mass, m_Frequency, m_Like, m_Body, m_Unit, m_Name])
        {
            command.Options.Add(option);
        }
    }

    /// <summary>Folder of the insect's files.</summary>
    public string Folder(ParseResult parsed) => parsed.GetValue(m_Folder);

    /// <summary>Reads the pictures or meshes of the wings, from front to back.</summary>
    /// <exception cref="UserException">A file cannot be read, or there are more hinges or sides than files.</exception>
    public WingSource[] Wings(ParseResult parsed) => WingSource.Read(
        Files(parsed), parsed.GetValue(m_Hinges) ?? [], parsed.GetValue(m_Sides) ?? [], parsed.GetValue(m_Triangles));

    /// <summary>The insect that is asked for, all but its wings, and their lengths.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="lengths">Lengths of the wings, millimetres.</param>
    /// <param name="isGiven">True where the last length is from hinge to tip, false where it is across the body.</param>
    /// <exception cref="UserException">Something is missing, or is not what it has to be.</exception>
    public NewInsect Insect(ParseResult parsed, out List<decimal> lengths, out bool isGiven)
    {
        string[] files = Files(parsed), far = parsed.GetValue(m_Lengths) ?? [];
        if (files.Length == 0)
            throw new UserException("Which wing? --wing takes a picture or a mesh of it, or of the fore and of the hind wing.");
        if (far.Length == 0)
            throw new UserException("How long is the wing? --length, from hinge to tip with its unit, such as 50mm.");
        if (far.Length > files.Length)
            throw new UserException($"--length takes one length for each wing: {files.Length}, not {far.Length}.");
        InsectDefinition known = Like(parsed, files.Length);
        decimal mass = s_Mass.Read("--mass", parsed.GetValue(m_Mass)
            ?? throw new UserException("How heavy is the insect? --mass, with its unit, such as 1.6g."));
        decimal frequency = s_Frequency.Read("--frequency", parsed.GetValue(m_Frequency)
            ?? throw new UserException("How often does it beat? --frequency, such as 25Hz."));
        lengths = [.. far.Select(length => s_Length.Read("--length", length))];
        isGiven = lengths.Count == files.Length;
        if (!isGiven)
            lengths.Add(NewInsect.LengthBehind(known, lengths[0]));
        return new NewInsect(NameOf(parsed.GetValue(m_Name), Folder(parsed)), known, mass, frequency)
        {
            BodyMesh = BodyOf(parsed.GetValue(m_Body), parsed.GetValue(m_Unit)),
        };
    }

    private string[] Files(ParseResult parsed) => parsed.GetValue(m_Wings) ?? [];

    private InsectDefinition Like(ParseResult parsed, int wings)
    {
        InsectDefinition known = KnownSpecies.FindInCatalogue(parsed.GetValue(m_Like) ?? (wings == 1 ? k_One : LikeOfTwo));
        return known.Wings.Count >= wings
            ? known
            : throw new UserException($"The {known.Name} has one kind of wing, so that two wings need another --like: "
                + $"{string.Join(", ", InsectCatalogue.All.Where(insect => insect.Wings.Count > 1).Select(insect => insect.Name))}.");
    }

    private static Option<string[]> OneOrTwo(string name, string value, string description) => new(name)
    {
        HelpName = value,
        Description = description,
        AllowMultipleArgumentsPerToken = true,
        Arity = new ArgumentArity(1, 2),
    };

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
}
