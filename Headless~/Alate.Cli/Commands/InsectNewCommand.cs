using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>insect new DIR</c>: makes an insect file with meshes, skeletons and textures from pictures or meshes of its wings.</summary>
internal static class InsectNewCommand
{
    public static Command Create(TextWriter output)
    {
        var options = new InsectNewOptions();
        var command = new Command(
            "new", "Makes an insect file, with meshes, skeletons and textures, from pictures or meshes of its wings.");
        options.AddTo(command);
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            NewInsect insect = options.Insect(parsed, out List<decimal> lengths, out bool isGiven);
            Make(insect, options.Wings(parsed), lengths, isGiven, options.Folder(parsed), output);
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
