using System.CommandLine;

namespace Alate.Cli;

/// <summary>
/// <c>compare SPECIES…</c>: the same insects as rigid wings, without a wave, by the full model and with another elasticity.
/// </summary>
internal static class CompareCommand
{
    private const string k_Table = "compare.csv";

    public static Command Create(TextWriter output)
    {
        var species = new Argument<string[]>("SPECIES")
        {
            Arity = ArgumentArity.OneOrMore,
            Description = $"The insects: {KnownSpecies.Names}.",
        };
        Option<double> elasticity = Numbers.Option(FlightNumbers.Elasticity with
        {
            Default = ComparisonColumn.OtherElasticity,
            Help = "Factor on the elasticity in the last column, {range}; below 1 is softer.",
        });
        Option<int?> phases = Numbers.OptionalCount(
            "--phases", "N", ComparisonPlan.MinPhases, ComparisonPlan.MaxPhases,
            $"Rows of the pictures, {ComparisonPlan.MinPhases} to {ComparisonPlan.MaxPhases}. [default: 4]");
        Option<InsectVariant?> variant = FlightOptions.Variant();
        Option<double?> speed = FlightOptions.Speed();
        Option<PictureView?> view = FlightOptions.View();
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/compare]" };
        var command = new Command(
            "compare", "Shows insects with parts of the model left out, side by side, and the differences in numbers.")
        {
            species, elasticity, phases, variant, speed, view, folder,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            var flights = new List<FlightPlan>();
            foreach (InsectDefinition definition in KnownSpecies.FindEach(parsed.GetValue(species)))
            {
                flights.Add(new FlightPlan
                {
                    Definition = definition,
                    Variant = parsed.GetValue(variant) ?? InsectVariant.Standard,
                    Speed = parsed.GetValue(speed) ?? FlightPlan.CruiseOf(definition),
                    View = parsed.GetValue(view) ?? PictureView.FrontLeft,
                });
            }

            double factor = parsed.GetValue(elasticity);
            flights.ForEach(flight => PlanRange.CheckElasticity(flight, factor));
            var plan = new ComparisonPlan(
                flights, ComparisonPlan.ColumnsWith((float)factor), parsed.GetValue(phases) ?? ComparisonPlan.DefaultPhases);
            Run(plan, parsed.GetValue(folder) ?? Path.Combine("out", "compare"), output);
            return 0;
        });
        return command;
    }

    private static void Run(ComparisonPlan plan, string path, TextWriter output)
    {
        string[] pictures = plan.Flights.Select(flight => flight.Species + ".png").ToArray();
        string[] files = [.. pictures, k_Table, FreeComparisonTable.File];
        using var folder = OutputFolder.Prepare(path, files);
        var terminal = new Terminal(output);
        List<Comparison> comparisons = null;
        terminal.ShowProgress(plan.Flights.Count * plan.Columns.Count, (done, stage) =>
        {
            comparisons = Comparison.Fly(plan, done);
            stage("drawing");
            for (int k = 0; k < comparisons.Count; k++)
            {
                byte[] picture = ComparisonPicture.Draw(comparisons[k]);
                folder.Write(pictures[k], stream => stream.Write(picture));
            }

            folder.Write(k_Table, stream => ComparisonTable.Write(comparisons, stream));
            folder.Write(FreeComparisonTable.File, stream => FreeComparisonTable.Write(comparisons, stream));
        });
        folder.Commit();
        foreach (Comparison comparison in comparisons)
        {
            for (int kind = 0; kind < comparison.Flights[0].Summary.Wings.Count; kind++)
                terminal.ShowBounded($"{comparison.Name}: {comparison.Flights[0].Summary.Wings[kind].Name}", Rows(comparison, kind));
            if (comparison.Free != null)
            {
                terminal.ShowTable(
                    $"{comparison.Held.Summary.Flight.Insect.DisplayName}: by its own wings", FreeComparisonTable.Lines(comparison));
            }
        }

        terminal.ShowFiles(path, files);
    }

    // The last column is the usual range. The larger of both cambers has one, so that it has a row of its own.
    private static IEnumerable<IReadOnlyList<string>> Rows(Comparison comparison, int kind)
    {
        yield return ["", .. comparison.Flights.Select(flight => flight.Column.Title), "usual"];
        foreach (WingMeasure measure in WingMeasure.All)
            yield return Row(measure.Title, measure.Of, MeasureBound.Find(measure.Key));
        foreach (MeasureBound bound in MeasureBound.All.Where(bound => WingMeasure.All.All(measure => measure.Key != bound.Key)))
            yield return Row(bound.Title, bound.Of, bound);
        yield return ["off the full model, mean, % of length",
            .. comparison.Flights.Select(flight => Number(flight.Distances[kind].MeanPct)), ""];
        yield return ["off the full model, most, % of length",
            .. comparison.Flights.Select(flight => Number(flight.Distances[kind].MaxPct)), ""];
        if (kind == 0)
            yield return ["lift over weight", .. comparison.Flights.Select(flight => Number(flight.Summary.LiftOverWeight)), ""];

        string[] Row(string title, Func<WingSummary, double> of, MeasureBound bound) =>
            [title, .. comparison.Flights.Select(flight => Cell(flight.Summary.Wings[kind], of, bound)),
                bound?.RangeOf(comparison.Plan.Variant) ?? ""];

        string Cell(WingSummary wing, Func<WingSummary, double> of, MeasureBound bound) =>
            bound?.Marked(Number(of(wing)), wing, comparison.Plan.Variant) ?? Number(of(wing));
    }

    // Rounded first, so that there is no minus nought.
    private static string Number(double value) => (Math.Round(value, 2) + 0.0).ToString("0.00", CultureInfo.InvariantCulture);

    private const string k_Examples =
        "Examples:\n"
        + "  compare monarch\n"
        + "  compare fishfly firefly --variant expressive --phases 6 --elasticity 4 --out stiffer\n\n"
        + "Columns: rigid wings as in earlier flight models, no deformation wave, the full model, and the full model with another "
        + "elasticity.\n\n"
        + "Writes into the output folder:\n"
        + "  SPECIES.png  for each species: the columns over rows of phases, and numbers below\n"
        + "  compare.csv  every measure of every column, and how far each column lies from the full model\n"
        + "  free-flight.csv  the flight on the spot beside one by the insect's own wings: bob, pitch, lift, power\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
