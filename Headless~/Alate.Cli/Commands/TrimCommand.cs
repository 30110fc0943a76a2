using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Catalogue;
using Alate.Cli.FreeFlights;
using Alate.Cli.Output;
using Alate.Flight;

namespace Alate.Cli.Commands;

/// <summary><c>trim SPECIES</c>: finds the beats and attitudes that carry an insect, prints and draws them, or makes its table.</summary>
internal static class TrimCommand
{
    private const string k_Picture = "trim.svg", k_Table = "trim.csv";

    public static Command Create(TextWriter output)
    {
        var species = new Argument<string>("SPECIES") { Description = $"The insect: {string.Join(", ", InsectCatalogue.Names)}." };
        var speeds = new Option<double[]>("--speeds") { HelpName = "M/S,…", CustomParser = result => Numbers(result.Tokens.Select(token => token.Value)), Description = "Speeds ahead, metres per second, up to 12. [default: 0,0.3,0.65,1,1.3]" };
        var climbs = new Option<double[]>("--climbs") { HelpName = "M/S,…", CustomParser = result => Numbers(result.Tokens.Select(token => token.Value)), Description = "Climbs, metres per second, up to 12. [default: -0.3,0,0.3]" };
        var bake = new Option<bool>("--bake") { Description = "Makes the table of the flight and writes it into the package's sources." };
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/trim]" };
        var command = new Command("trim", "Finds the beat and the attitude that carry an insect at speeds and climbs.") { species, speeds, climbs, bake, folder };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            InsectDefinition insect = FlightOptions.Find(parsed.GetValue(species), InsectVariant.Flight);
            List<float> ahead = List(parsed.GetValue(speeds), TrimBake.DefaultSpeeds), up = List(parsed.GetValue(climbs), TrimBake.DefaultClimbs);
            using FlightModel model = CatalogueFlight.CreateModel(insect);
            if (parsed.GetValue(bake))
                Bake(insect, model, ahead, up, output);
            else
                Survey(insect, model, ahead, up, parsed.GetValue(folder) ?? Path.Combine("out", "trim"), output);
            return 0;
        });
        return command;
    }

    private static void Bake(InsectDefinition insect, FlightModel model, List<float> speeds, List<float> climbs, TextWriter output)
    {
        var bake = new TrimBake(model) { Log = output.WriteLine };
        using TrimTable table = bake.Bake(speeds, climbs) ?? throw new UserException($"The {insect.DisplayName} does not fly: {bake.Problem}");
        File.WriteAllText(TrimSource.PathOf(insect), TrimSource.Write(insect, TrimTableText.Write(table, model.Key)));
        output.WriteLine(TrimSource.PathOf(insect));
    }

    private static void Survey(InsectDefinition insect, FlightModel model, List<float> speeds, List<float> climbs, string path, TextWriter output)
    {
        using OutputFolder folder = OutputFolder.Prepare(path, k_Picture, k_Table);
        List<TrimRow> rows = TrimSurvey.Make(model, speeds, climbs, output.WriteLine);
        if (!rows.Exists(row => row.Closes))
            throw new UserException($"The {insect.DisplayName} does not fly at any of these speeds and climbs.");
        output.WriteLine($"{insect.DisplayName}: {1e6 * model.Mass:0.##} mg, wings {1e3 * model.Length:0.#} mm, beat {model.Frequency:0.##} Hz");
        output.WriteLine(string.Join("  ", TrimRow.Header.Take(10)));
        foreach (TrimRow row in rows)
            output.WriteLine(string.Join("  ", row.Cells().Take(10).Select(cell => cell.PadLeft(8))) + "  " + row.Problem);
        folder.Write(k_Picture, stream => stream.Write(Encoding.UTF8.GetBytes(TrimPicture.Draw(insect, rows))));
        folder.Write(k_Table, stream => CsvTable.Write(stream, rows.Select(row => (IReadOnlyList<string>)row.Cells()).Prepend(TrimRow.Header)));
        folder.Commit();
        output.WriteLine($"{Path.Combine(path, k_Picture)}, {Path.Combine(path, k_Table)}");
    }

    private static double[] Numbers(IEnumerable<string> words) => words.SelectMany(word => word.Split(',')).Select(Number).ToArray();

    private static double Number(string word) =>
        double.TryParse(word, System.Globalization.NumberStyles.Float, System.Globalization.CultureInfo.InvariantCulture, out double value) && Math.Abs(value) <= 20
            ? value
            : throw new UserException($"'{word}' is no speed: a list of numbers from -20 to 20 with commas between them is needed.");

    private static List<float> List(double[] given, IReadOnlyList<float> otherwise)
    {
        List<float> list = given is { Length: > 0 } ? given.Select(value => (float)value).Distinct().Order().ToList() : otherwise.ToList();
        return list.Count <= 12 ? list : throw new UserException($"At most 12 speeds or climbs, not {list.Count}.");
    }

    private const string k_Examples =
        "Examples:\n"
        + "  trim monarch\n"
        + "  trim fishfly --speeds 0,0.5,1 --climbs 0\n\n"
        + "Of all beats that balance lift, thrust and pitching moment the nearest to the species' own, with the bob of the body that they make.\n\n"
        + "Writes into the output folder:\n"
        + "  trim.svg  pitch, frequency, flap, tilt, sweep and bob over speed, a line a climb\n"
        + "  trim.csv  the same, with what is left of lift, thrust and moment over the weight\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input, or where the insect flies at none (nothing is written then).\n";
}
