using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>sweep PARAMETER FROM TO</c>: flies a species at several values of one number.</summary>
internal static class SweepCommand
{
    private const string k_Picture = "sweep.png", k_Charts = "sweep.svg", k_Table = "sweep.csv";

    private static readonly (string Title, MeasureBound Bound)[] s_Numbers =
    [
        ("twist °", MeasureBound.Find("twist_pp_deg")), ("camber %", MeasureBound.Find("camber_pct")),
        ("tip bend °", MeasureBound.Find("tip_bend_max_deg")),
        ("lag °", MeasureBound.Find("lag_deg")), ("stretch %", MeasureBound.Find("edge_stretch_max_pct")),
    ];

    public static Command Create(TextWriter output)
    {
        var parameter = new Argument<string>("PARAMETER")
        {
            Description = $"The number to change: {string.Join(", ", FlownParameters.All.Select(known => known.Name))}.",
        };
        Argument<double> from = Numbers.Argument("FROM", "Its first value.");
        Argument<double> to = Numbers.Argument("TO", "Its last value; elasticity is a factor on the species'.");
        var species = new Option<string>("--species")
        {
            HelpName = "NAME",
            Description = "The insect; the paper's Fig. 14 shows a fishfly. [default: fishfly]",
        };
        Option<int?> steps = Numbers.OptionalCount(
            "--steps", "N", SweepPlan.MinSteps, SweepPlan.MaxSteps,
            $"Values, {SweepPlan.MinSteps} to {SweepPlan.MaxSteps}: evenly spaced, or by equal ratios where they span a factor of ten or "
            + "more. [default: 5]");
        Option<SweepWaves?> waves = Choice.Optional<SweepWaves>(
            "--wave", "With the deformation wave, without it, or both. [default: on]", new()
            {
                ["on"] = SweepWaves.On,
                ["off"] = SweepWaves.Off,
                ["both"] = SweepWaves.Both,
            });
        Option<int?> substeps = FlightOptions.Substeps();
        Option<InsectVariant?> variant = FlightOptions.Variant();
        Option<double?> speed = FlightOptions.Speed();
        Option<PictureView?> view = FlightOptions.View();
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/sweep-PARAMETER]" };
        var command = new Command("sweep", "Flies an insect at several values of one number: a picture and a table of its effect.")
        {
            parameter, from, to, species, steps, waves, substeps, variant, speed, view, folder,
        };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            FlownParameter known = FlownParameters.Find(parsed.GetValue(parameter));
            InsectDefinition definition = KnownSpecies.Find(parsed.GetValue(species) ?? "fishfly");
            var flight = new FlightPlan
            {
                Definition = definition,
                Variant = parsed.GetValue(variant) ?? InsectVariant.Standard,
                Substeps = parsed.GetValue(substeps),
                Speed = parsed.GetValue(speed) ?? FlightPlan.CruiseOf(definition),
                View = parsed.GetValue(view) ?? PictureView.FrontLeft,
            };
            PlanRange.Check(flight, known, "FROM", parsed.GetValue(from));
            PlanRange.Check(flight, known, "TO", parsed.GetValue(to));
            var plan = new SweepPlan(
                known, parsed.GetValue(from), parsed.GetValue(to), parsed.GetValue(steps) ?? SweepPlan.DefaultSteps, flight,
                parsed.GetValue(waves) ?? SweepWaves.On);
            Run(plan, parsed.GetValue(folder) ?? Path.Combine("out", "sweep-" + known.Name), output);
            return 0;
        });
        return command;
    }

    private static void Run(SweepPlan plan, string path, TextWriter output)
    {
        using var folder = OutputFolder.Prepare(path, k_Picture, k_Charts, k_Table);
        var terminal = new Terminal(output);
        Sweep sweep = null;
        terminal.ShowProgress(Sweep.Flights(plan), (done, stage) =>
        {
            sweep = Sweep.Fly(plan, done);
            stage("drawing");
            folder.Write(k_Picture, stream => stream.Write(SweepPicture.DrawPoses(sweep)));
            folder.Write(k_Charts, stream => stream.Write(Encoding.UTF8.GetBytes(SweepPicture.DrawCharts(sweep))));
            folder.Write(k_Table, stream => SweepTable.Write(sweep, stream));
        });
        folder.Commit();
        terminal.ShowBounded($"{sweep.Points[0].Summary.Flight.Insect.DisplayName}: {plan.Parameter.Title}", Rows(sweep), names: 3);
        terminal.ShowFiles(path, k_Picture, k_Charts, k_Table);
    }

    // The second row has the usual ranges. Other numbers stand in sweep.csv.
    private static IEnumerable<IReadOnlyList<string>> Rows(Sweep sweep)
    {
        InsectVariant variant = sweep.Points[0].Summary.Flight.Plan.Variant;
        yield return ["", "wave", "wing", .. s_Numbers.Select(number => number.Title), "load camber %", "lift / weight"];
        yield return ["usual", "", "", .. s_Numbers.Select(number => number.Bound.RangeOf(variant)), "", ""];
        foreach (SweepPoint point in sweep.Points)
        {
            for (int kind = 0; kind < point.Summary.Wings.Count; kind++)
            {
                WingSummary wing = point.Summary.Wings[kind];
                yield return
                [
                    LineChart.Label(point.Value), point.HasWave ? "on" : "off", wing.Name,
                    .. s_Numbers.Select(number => number.Bound.Cell(wing, variant)),
                    Number(point.LoadCamberPct[kind]),
                    kind == 0 ? point.Summary.LiftOverWeight.ToString("0.00", CultureInfo.InvariantCulture) : "",
                ];
            }
        }
    }

    private static string Number(double value) => value.ToString("0.0", CultureInfo.InvariantCulture);

    private const string k_Examples =
        "Examples:\n"
        + "  sweep elasticity 0.25 4 --wave both\n"
        + "  sweep chord-delay 0 1 --species monarch --steps 6\n"
        + "  sweep wind 0 3 --species painted-lichen-moth --variant expressive --out gusts\n\n"
        + "On an insect with two kinds of wings the first takes the value; the other is changed by the same factor, or the same\n"
        + "difference where the number may be negative.\n\n"
        + "Writes into the output folder:\n"
        + "  sweep.png  the insect at four phases for each value\n"
        + "  sweep.svg  curves of the measures\n"
        + "  sweep.csv  every measure for each value and kind of wing\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
