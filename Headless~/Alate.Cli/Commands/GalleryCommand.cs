using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>gallery</c>: all species in flight in one picture.</summary>
internal static class GalleryCommand
{
    private const string k_File = "insects.png";
    private const int k_Width = 1230, k_SheetWidth = 1600, k_Narrowest = 90, k_Widest = 3000;

    public static Command Create(TextWriter output)
    {
        Option<int?> width = Numbers.OptionalCount(
            "--width", "N", k_Narrowest, k_Widest,
            $"Pixels from side to side, {k_Narrowest} to {k_Widest}. [default: {k_Width}, of a sheet {k_SheetWidth}]");
        Argument<string[]> species = FlightOptions.AnySpecies();
        var wake = new Option<bool>("--wake") { Description = "Shows the vortex rings that the wings leave, as 'wake' computes them." };
        var transparent = new Option<bool>("--transparent") { Description = "Nothing lies behind the insects, for a ground of your own." };
        Option<BackdropLook?> backdrop = FlightOptions.Backdrop("the insects");
        var sheets = new Option<bool>("--sheets")
        {
            Description = "A sheet for each insect instead, from all sides and from near by: sheet-NAME.png.",
        };
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the file goes. [default: out/gallery]" };
        var command = new Command("gallery", "Draws insects in flight in one picture.")
        {
            species, width, sheets, wake, transparent, backdrop, folder,
        };
        HelpExamples.Set(command,
            $"Examples:\n  gallery --out pictures\n  gallery monarch hawkmoth.insect.json\n  gallery dragonfly --sheets\n\n"
            + $"Writes into the output folder:\n  {k_File}, with --sheets a sheet-NAME.png for each insect");
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(transparent) && parsed.GetValue(backdrop) != null)
                throw new UserException("--transparent leaves nothing behind the insects; it does not go with --backdrop.");
            List<InsectDefinition> insects = parsed.GetValue(species) is { Length: > 0 } names
                ? KnownSpecies.FindAny(names, InsectVariant.Expressive)
                : null;
            string root = parsed.GetValue(folder) ?? Path.Combine("out", "gallery");
            if (parsed.GetValue(sheets))
            {
                if (parsed.GetValue(wake) || parsed.GetValue(transparent) || parsed.GetValue(backdrop) != null)
                    throw new UserException("--sheets shows insects on paper; it goes with none of --wake, --transparent, --backdrop.");
                return DrawSheets(insects ?? [.. InsectCatalogue.All], parsed.GetValue(width) ?? k_SheetWidth, root, output);
            }

            using var target = OutputFolder.Prepare(root, k_File);
            target.Write(k_File, stream => stream.Write(Gallery.Draw(
                parsed.GetValue(width) ?? k_Width, parsed.GetValue(wake), insects, !parsed.GetValue(transparent),
                parsed.GetValue(backdrop))));
            target.Commit();
            output.WriteLine($"Written: {Path.Combine(target.Root, k_File)}");
            return 0;
        });
        return command;
    }

    private static int DrawSheets(List<InsectDefinition> insects, int width, string root, TextWriter output)
    {
        string[] files = [.. insects.Select(insect => $"sheet-{insect.Name}.png")];
        using var target = OutputFolder.Prepare(root, files);
        for (int k = 0; k < files.Length; k++)
        {
            byte[] sheet = ContactSheet.Draw(insects[k], width, BakePhoto.AtRest(insects[k]));
            target.Write(files[k], stream => stream.Write(sheet));
        }

        target.Commit();
        foreach (string file in files)
            output.WriteLine($"Written: {Path.Combine(target.Root, file)}");
        return 0;
    }
}
