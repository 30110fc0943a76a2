using System.CommandLine;
using Alate.Flight;
using Alate.Wake;

namespace Alate.Cli;

/// <summary><c>trim SPECIES</c>: finds the beats and attitudes that carry an insect, prints and draws them, or makes its table.</summary>
internal static class TrimCommand
{
    private const string k_Picture = "trim.svg", k_Table = "trim.csv", k_Trims = ".trims";

    /// <summary>Columns of the table that the terminal shows: all but the residuals.</summary>
    private const int k_Shown = 11;

    /// <summary>Most speeds, and most climbs.</summary>
    private const int k_Most = 12;

    /// <summary>Fastest speed and climb, either way, metres per second.</summary>
    private const double k_Fastest = 20;

    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES") { Description = $"The insect: {KnownSpecies.Names}." };
        Option<double[]> speeds = Numbers.List("--speeds", "M/S,…", k_Most, -k_Fastest, k_Fastest,
            $"Speeds ahead, metres per second, up to {k_Most}, each -{k_Fastest} to {k_Fastest}. [default: 0,0.15,0.3,0.65,1,1.3]");
        Option<double[]> climbs = Numbers.List("--climbs", "M/S,…", k_Most, -k_Fastest, k_Fastest,
            $"Climbs, metres per second, up to {k_Most}, each -{k_Fastest} to {k_Fastest}. [default: -0.3,-0.15,0,0.3]");
        var bake = new Option<bool>("--bake")
        {
            Description = "Makes the table of the flight and writes it into the package's sources, or beside the insect file.",
        };
        var stillAir = new Option<bool>("--still-air")
        {
            Description = "The wings of each trim meet air at rest, not that of its own wake.",
        };
        var wideCores = new Option<bool>("--wide-cores")
        {
            Description = "A wake that is another one in each beat has vortex cores as wide as a chord, not the air of a trim beside it.",
        };
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/trim]" };
        var command = new Command("trim", "Finds the beat and the attitude that carry an insect at speeds and climbs.") { species, speeds,
            climbs, bake, stillAir, wideCores, folder };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            string named = parsed.GetValue(species);
            InsectDefinition insect = KnownSpecies.Find(named, InsectVariant.Flight);
            List<float> ahead = List(parsed.GetValue(speeds), TrimBake.DefaultSpeeds),
                up = List(parsed.GetValue(climbs), TrimBake.DefaultClimbs);
            using FlightModel model = CatalogueFlight.CreateModel(insect);
            TrimWake wake = WakeOf(parsed.GetValue(stillAir), parsed.GetValue(wideCores));
            if (parsed.GetValue(bake))
                Bake(insect, KnownSpecies.IsFile(named) ? named : null, model, ahead, up, wake, output);
            else
                Survey(insect, model, ahead, up, wake, parsed.GetValue(folder) ?? Path.Combine("out", "trim"), output);
            return 0;
        });
        return command;
    }

    // Into the package's sources, or beside the file of an insect.
    private static void Bake(
        InsectDefinition insect, string file, FlightModel model, List<float> speeds, List<float> climbs, TrimWake wake,
        TextWriter output)
    {
        var bake = new TrimBake(model) { Log = output.WriteLine, Wake = wake };
        using TrimTable table = bake.Bake(speeds, climbs)
            ?? throw new UserException($"The {insect.DisplayName} does not fly: {bake.Problem}");
        if (file != null)
        {
            string path = Path.Combine(Path.GetDirectoryName(file) ?? "", insect.Name + k_Trims);
            OutputFile.Write(path, stream => stream.Write(Encoding.UTF8.GetBytes(TrimTableText.Write(table, model.Key))));
            if (FlightReach.Missing(table) is { } missing)
                output.WriteLine($"{insect.DisplayName}: {missing}. A faster beat, longer wings or less mass carry more.");
            output.WriteLine($"{path}: give the insect file the line \"{InsectKeys.Trims}\": \"{Path.GetFileName(path)}\".");
            return;
        }

        string source = TrimSource.Write(insect, TrimTableText.Write(table, model.Key),
            Asked("--speeds", speeds, TrimBake.DefaultSpeeds) + Asked("--climbs", climbs, TrimBake.DefaultClimbs)
                + Asked(wake));
        OutputFile.Write(TrimSource.PathOf(insect), stream => stream.Write(Encoding.UTF8.GetBytes(source)));
        output.WriteLine(TrimSource.PathOf(insect));
    }

    private static void Survey(
        InsectDefinition insect, FlightModel model, List<float> speeds, List<float> climbs, TrimWake wake, string path,
        TextWriter output)
    {
        using var folder = OutputFolder.Prepare(path, k_Picture, k_Table);
        List<TrimRow> rows = TrimSurvey.Make(model, speeds, climbs, wake, output.WriteLine);
        if (!rows.Exists(row => row.Closes))
            throw new UserException($"The {insect.DisplayName} does not fly at any of these speeds and climbs. {rows[0].Problem}");
        output.WriteLine(
            $"{insect.DisplayName}: {1e6 * model.Mass:0.##} mg, wings {1e3 * model.Length:0.#} mm, beat {model.Frequency:0.##} Hz");
        output.WriteLine(string.Join("  ", TrimRow.Header.Take(k_Shown)));
        foreach (TrimRow row in rows)
            output.WriteLine(string.Join("  ", row.Cells().Take(k_Shown).Select(cell => cell.PadLeft(8))) + "  " + row.Problem);
        folder.Write(k_Picture, stream => stream.Write(Encoding.UTF8.GetBytes(TrimPicture.Draw(insect, rows))));
        folder.Write(
            k_Table, stream => CsvTable.Write(stream, rows.Select(row => (IReadOnlyList<string>)row.Cells()).Prepend(TrimRow.Header)));
        folder.Commit();
        output.WriteLine($"{Path.Combine(path, k_Picture)}, {Path.Combine(path, k_Table)}");
    }

    /// <summary>Option about wakes, as the source of a table tells it; empty for the default.</summary>
    internal static string Asked(TrimWake wake) => wake == null ? " --still-air" : wake.HasWideCores ? " --wide-cores" : "";

    private static TrimWake WakeOf(bool isStill, bool hasWideCores)
    {
        if (isStill && hasWideCores)
            throw new UserException("--wide-cores is about the wakes that --still-air leaves out: give one of them.");
        return isStill ? null : new TrimWake { HasWideCores = hasWideCores };
    }

    private static List<float> List(double[] given, IReadOnlyList<float> otherwise) =>
        given is { Length: > 0 } ? given.Select(value => (float)value).Distinct().Order().ToList() : otherwise.ToList();

    /// <summary>Option with values that are not the default's, as the source of a table tells it; empty for the default's.</summary>
    internal static string Asked(string option, List<float> values, IReadOnlyList<float> otherwise) =>
        values.SequenceEqual(otherwise)
        ? ""
        : $" {option} {string.Join(',', values.Select(value => value.ToString(CultureInfo.InvariantCulture)))}";

    private const string k_Examples =
        "Examples:\n"
        + "  trim monarch\n"
        + "  trim fishfly --speeds 0,0.5,1 --climbs 0\n\n"
        + "Of all beats that balance lift, thrust and pitching moment the nearest to the species' own, with the bob of the body "
        + "that they make, in the air of the wake that they leave.\n\n"
        + "Writes into the output folder:\n"
        + "  trim.svg  pitch, frequency, flap, tilt, sweep, bob and power over speed, a line a climb\n"
        + "  trim.csv  the same, with what is left of lift, thrust and moment over the weight, and what is missing where a point "
        + "does not close\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input, or where the insect flies at none (nothing is written then).\n";
}
