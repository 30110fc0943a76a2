using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>convergence [SPECIES…]</c>: error of the joints against the cost of a beat, for both schemes of time.</summary>
internal static class ConvergenceCommand
{
    private static readonly ChartReport s_Report = new("convergence.svg", "convergence.csv");

    public static Command Create(TextWriter output)
    {
        Argument<string[]> species = FlightOptions.AnySpecies();
        Option<InsectVariant?> variant = FlightOptions.Variant();
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/convergence]" };
        var command =
            new Command("convergence", "Measures how far wings are off at some substeps of a beat, and what these cost.") { species,
            variant, folder };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            InsectVariant shown = parsed.GetValue(variant) ?? InsectVariant.Standard;
            List<InsectDefinition> insects = KnownSpecies.FindAny(parsed.GetValue(species), shown);
            var plan = new ConvergencePlan(insects.ConvertAll(insect => FlightPlan.Cruise(insect, shown)));
            Run(plan, parsed.GetValue(folder) ?? Path.Combine("out", "convergence"), output);
            return 0;
        });
        return command;
    }

    private static void Run(ConvergencePlan plan, string path, TextWriter output)
    {
        var terminal = new Terminal(output);
        List<SpeciesConvergence> measured = s_Report.Make(
            terminal, path, plan.Flights.Count, done => SpeciesConvergence.Measure(plan, done), ConvergencePicture.Draw,
            ConvergenceTable.Write);
        foreach (SpeciesConvergence species in measured)
        {
            foreach (WingConvergence wing in species.Wings)
            {
                string name = $"{KnownSpecies.Titled(species.DisplayName, species.Plan.Variant)}: {wing.Name}";
                terminal.ShowTable(name, ConvergenceTable.Errors(wing));
                terminal.ShowTable($"{name}, converged numbers", ConvergenceTable.Values(wing));
            }
        }

        terminal.ShowFiles(path, s_Report.Picture, s_Report.Table);
    }

    private const string k_Examples =
        "Examples:\n"
        + "  convergence monarch fishfly\n"
        + "  convergence --variant expressive --out soft\n\n"
        + "The error is the distance of the joints from a flight of 480 substeps of the same scheme, root mean square over joints and a "
        + "settled beat, % of the\n"
        + "wing's length. The cost is the time of a beat over that of version 0.1: backward Euler, 24 substeps (expressive 48), 256 "
        + "patches. It depends on the machine.\n\n"
        + "Writes into the output folder:\n"
        + "  convergence.svg  error over cost, a chart for each species\n"
        + "  convergence.csv  both for each kind of wing, scheme and number of substeps\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
