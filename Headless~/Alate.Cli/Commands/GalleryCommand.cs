using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>gallery</c>: all species in flight in one picture.</summary>
internal static class GalleryCommand
{
    private const string k_File = "insects.png";
    private const int k_Width = 1230, k_Narrowest = 90, k_Widest = 3000;

    public static Command Create(TextWriter output)
    {
        Option<int?> width = Numbers.OptionalCount(
            "--width", "N", k_Narrowest, k_Widest, $"Pixels from side to side, {k_Narrowest} to {k_Widest}. [default: {k_Width}]");
        Argument<string[]> species = FlightOptions.AnySpecies();
        var wake = new Option<bool>("--wake") { Description = "Shows the vortex rings that the wings leave, as 'wake' computes them." };
        var transparent = new Option<bool>("--transparent") { Description = "Nothing lies behind the insects, for a ground of your own." };
        Option<BackdropLook?> backdrop = FlightOptions.Backdrop("the insects");
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the file goes. [default: out/gallery]" };
        var command = new Command("gallery", "Draws insects in flight in one picture.")
        {
            species, width, wake, transparent, backdrop, folder,
        };
        HelpExamples.Set(command,
            $"Examples:\n  gallery --out pictures\n  gallery monarch hawkmoth.insect.json\n\nWrites into the output folder:\n  {k_File}");
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(transparent) && parsed.GetValue(backdrop) != null)
                throw new UserException("--transparent leaves nothing behind the insects; it does not go with --backdrop.");
            List<InsectDefinition> insects = parsed.GetValue(species) is { Length: > 0 } names
                ? KnownSpecies.FindAny(names, InsectVariant.Expressive)
                : null;
            using var target = OutputFolder.Prepare(parsed.GetValue(folder) ?? Path.Combine("out", "gallery"), k_File);
            target.Write(k_File, stream => stream.Write(Gallery.Draw(
                parsed.GetValue(width) ?? k_Width, parsed.GetValue(wake), insects, !parsed.GetValue(transparent),
                parsed.GetValue(backdrop))));
            target.Commit();
            output.WriteLine($"Written: {Path.Combine(target.Root, k_File)}");
            return 0;
        });
        return command;
    }
}
