using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>wind [SPECIES…]</c>: how much the mesh of wings stretches in wind from all sides, today and by version 0.1.</summary>
internal static class WindCommand
{
    private static readonly ChartReport s_Report = new("wind.svg", "wind.csv");

    public static Command Create(TextWriter output)
    {
        Argument<string[]> species = FlightOptions.AnySpecies();
        Option<double[]> speeds = Numbers.List(
            "--speeds", "V,V,...", WindPlan.MostSpeeds, WindPlan.MinSpeed, WindPlan.MaxSpeed,
            $"Speeds of the wind, metres per second, up to {WindPlan.MostSpeeds} of them, each "
            + $"{WindPlan.MinSpeed} to {WindPlan.MaxSpeed}. [default: {string.Join(',', WindPlan.DefaultSpeeds)}]");
        Option<InsectVariant?> variant = FlightOptions.Variant();
        var gusts =
            new Option<bool>("--gusts") { Description = "Two smooth gusts of a beat each and a sharp one, instead of a steady wind." };
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/wind]" };
        var command =
            new Command("wind", "Measures how much wings stretch in wind from 26 directions.") { species, speeds, variant, gusts, folder };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            InsectVariant shown = parsed.GetValue(variant) ?? InsectVariant.Standard;
            List<InsectDefinition> insects = KnownSpecies.FindAny(parsed.GetValue(species), shown);
            IReadOnlyList<double> winds = parsed.GetValue(speeds) is { Length: > 0 } given
                ? given.Order().Distinct().ToList()
                : WindPlan.DefaultSpeeds;
            var plan = new WindPlan(insects.ConvertAll(insect => FlightPlan.Cruise(insect, shown)), winds, parsed.GetValue(gusts));
            Run(plan, parsed.GetValue(folder) ?? Path.Combine("out", "wind"), output);
            return 0;
        });
        return command;
    }

    private static void Run(WindPlan plan, string path, TextWriter output)
    {
        var terminal = new Terminal(output);
        List<SpeciesWinds> measured = s_Report.Make(
            terminal, path, plan.Flights.Count, done => SpeciesWinds.Measure(plan, done),
            winds => WindPicture.Draw(winds, plan.InGusts), (winds, stream) => WindTable.Write(winds, plan.InGusts, stream));
        foreach (SpeciesWinds species in measured)
        {
            foreach (WingWinds wing in species.Wings)
                terminal.ShowTable($"{KnownSpecies.Titled(species.DisplayName, species.Plan.Variant)}: {wing.Name}", WindTable.Of(wing));
        }

        terminal.ShowFiles(path, s_Report.Picture, s_Report.Table);
    }

    private const string k_Examples =
        "Examples:\n"
        + "  wind firefly --gusts\n"
        + "  wind --speeds 0,3,10 --variant expressive --out soft\n\n"
        + "Each wing meets the wind on top of its level flight from the 26 neighbours of a cube's centre; species in water meet a tenth "
        + "of the speeds.\n"
        + "Version 0.1 is shown beside it: backward Euler, one-way coupling, wind as it is, 24 substeps (expressive 48), 256 patches.\n\n"
        + "Writes into the output folder:\n"
        + "  wind.svg  stretch over speed, a chart for each species\n"
        + "  wind.csv  largest stretch, 99th percentile, worst direction and tip bend in a head wind\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
