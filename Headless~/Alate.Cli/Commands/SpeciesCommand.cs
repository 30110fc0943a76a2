using System.CommandLine;
using Spectre.Console;

namespace Alate.Cli;

/// <summary><c>species [NAME]</c>: lists the presets, or all numbers of one with their sources.</summary>
internal static class SpeciesCommand
{
    public static Command Create(TextWriter output)
    {
        var name = new Argument<string>("NAME")
        {
            Arity = ArgumentArity.ZeroOrOne,
            Description = $"One of them, with every number and its source: {KnownSpecies.Names}.",
        };
        var json = new Option<string>("--json")
        {
            HelpName = "FILE",
            Arity = ArgumentArity.ZeroOrOne,
            Description = "Also write the numbers and their sources as JSON to this file; to NAME.insect.json, the default with NAME, the "
                + "whole insect file.",
        };
        var schema = new Option<string>("--schema")
        {
            HelpName = "FILE",
            Description = "Also write the JSON Schema of insect files, by which editors check and complete them.",
        };
        var check = new Option<bool>("--check")
        {
            Description = "Of one: show its numbers beside those of real insects instead, in each variant, and ask where a unit may be "
                + "wrong.",
        };
        var command = new Command("species", "Lists the species with their numbers, variants and sources.") { name, json, schema, check };
        HelpExamples.Set(
            command, "Examples:\n  species\n  species firefly\n  species --json species.json\n  species monarch --json mine.insect.json\n"
            + "  species mine.insect.json --check");
        command.SetAction(parsed =>
        {
            string wanted = parsed.GetValue(name), file = parsed.GetValue(json);
            var sheets = (wanted == null ? InsectCatalogue.All : [KnownSpecies.Find(wanted)]).Select(SpeciesNumbers.Of).ToList();
            if (parsed.GetResult(json) is { Implicit: false })
                Write(file ?? (wanted == null ? null : sheets[0].Definition.Name + InsectFile.Ending), wanted, sheets);
            if (parsed.GetValue(schema) is string place)
                OutputFile.Write(place, stream => stream.Write(Encoding.UTF8.GetBytes(FileSchema.Insect.Write())));

            var terminal = new Terminal(output);
            if (parsed.GetValue(check))
                Check(wanted == null ? throw new UserException("--check needs the NAME of an insect.") : sheets[0].Definition, terminal);
            else if (wanted == null)
                terminal.ShowTexts("Species", List(sheets));
            else
                Show(sheets[0], terminal);
            return 0;
        });
        return command;
    }

    private static void Check(InsectDefinition insect, Terminal terminal)
    {
        foreach (InsectVariant variant in insect.Variants)
        {
            var plan = new FlightPlan { Definition = insect, Variant = variant, Speed = FlightPlan.CruiseOf(insect) };
            string title = KnownSpecies.Titled(insect.DisplayName, variant);
            terminal.ShowPlausibility(
                FormattableString.Invariant($"{title} beside real insects, at {plan.Speed:0.##} m/s:"), Plausibility.Of(plan));
        }

        terminal.Lines.WriteLine(MeasureBound.Note);
    }

    private static void Write(string file, string wanted, List<SpeciesNumbers> sheets)
    {
        if (file == null)
            throw new UserException("--json needs a FILE where no insect is named.");
        if (!file.EndsWith(InsectFile.Ending, StringComparison.OrdinalIgnoreCase))
            OutputFile.Write(file, stream => SpeciesJson.Write(sheets, stream));
        else if (wanted == null || KnownSpecies.IsFile(wanted))
            throw new UserException($"An insect file is written of one insect of the catalogue: species NAME --json {file}.");
        else
            OutputFile.Write(file, stream => stream.Write(Encoding.UTF8.GetBytes(InsectFileText.Write(sheets[0].Definition))));
    }

    private static IEnumerable<IReadOnlyList<string>> List(List<SpeciesNumbers> sheets)
    {
        yield return ["", "wings", "triangles", "length, mm", "Hz", "flap, °", "k_e", "variants"];
        foreach (SpeciesNumbers sheet in sheets)
        {
            WingNumbers main = sheet.Wings[0];
            yield return
            [
                sheet.Definition.Name, string.Join(", ", sheet.Wings.Select(wing => wing.Wing.Name)),
                Number(sheet.Definition.TriangleCount),
                Number(1000 * main["wing-length"]), Number(main["max-frequency"]), Number(main["flap-range"]), Number(main["elasticity"]),
                string.Join(", ", sheet.Definition.Variants).ToLowerInvariant(),
            ];
        }
    }

    private static void Show(SpeciesNumbers sheet, Terminal terminal)
    {
        foreach (WingNumbers wing in sheet.Wings)
        {
            terminal.ShowTable(
                $"{sheet.Definition.DisplayName}: {wing.Wing.Name}, {wing.Wing.TriangleCount} triangles on each side", Numbers(wing));
        }
        terminal.ShowTexts("Sources", Sources(sheet.Definition));
    }

    private static IEnumerable<IReadOnlyList<string>> Numbers(WingNumbers wing)
    {
        yield return ["", .. wing.Variants.Select(variant => variant.ToString().ToLowerInvariant())];
        for (int k = 0; k < WingNumbers.Parameters.Count; k++)
            yield return [WingNumbers.Parameters[k].Title, .. wing.Values.Select(values => Number(values[k]))];
    }

    private static IEnumerable<IReadOnlyList<string>> Sources(InsectDefinition definition)
    {
        yield return ["number", "variant", "value", "source"];
        foreach (InsectSource source in definition.Sources)
            yield return [source.Quantity, source.Variant.ToString().ToLowerInvariant(), source.Value, source.Source];
    }

    // Four digits after the point, or of what is smaller still.
    private static string Number(double value) =>
        value.ToString(value != 0 && Math.Abs(value) < 1e-3 ? "0.###e-0" : "0.####", CultureInfo.InvariantCulture);
}
