using System.CommandLine;

namespace Alate.Cli;

/// <summary><c>validate</c>: the model beside measured and published flights.</summary>
internal static class ValidateCommand
{
    private const string k_Page = "validation.md", k_Json = "validation.json", k_Charts = "images/validation.svg", k_Name = "validate";

    /// <summary>Part of the front page.</summary>
    internal const string Part = "validation";

    private const int k_Stages = 43;

    public static Command Create(TextWriter output)
    {
        var data = new Option<string>("--data")
        {
            HelpName = "DIR",
            Description = "Measured curves of your own: CSV files of t/T and value, such as vertical-force.csv.",
        };
        var folder = new Option<string>("--out") { HelpName = "DIR", Description = "Where the files go. [default: out/validation]" };
        var front = new Option<string>("--readme")
        {
            HelpName = "FILE.md",
            Description = "A page whose part 'validation' gets the rows of the package's front page.",
        };
        const string k_About = "Compares the model with measured and published flights, its wakes and its structure with theory.";
        var command = new Command(k_Name, k_About) { data, folder, front };
        HelpExamples.Set(command, k_Examples);
        command.SetAction(parsed =>
        {
            Run(parsed.GetValue(data), parsed.GetValue(folder) ?? Path.Combine("out", "validation"), parsed.GetValue(front), output,
                () => DragonflyCurves.Make(DragonflyRows.Substeps), Parts);
            return 0;
        });
        return command;
    }

    /// <summary>Parts of the report in its order: the rows of each, which call back after each stage.</summary>
    private static IReadOnlyList<Func<Action, IEnumerable<ValidationRow>>> Parts { get; } =
    [
        done => DragonflyRows.Flights(Fineness.Report, done), done => DragonflyRows.Tethered(Fineness.Report, done),
        done => FreeRows.Butterfly("monarch", Fineness.Report, done), done => FreeRows.Butterfly("swallowtail", Fineness.Report, done),
        done => FreeRows.Moth(Fineness.Report, done), done => FreeRows.Firefly(Fineness.Report, done),
        done => ButterflyRows.Climbing(Fineness.Report, done), done => ButterflyRows.Held(Fineness.Report, done),
        done => StructureRows.Insects(Fineness.Report, done),
        done => DragonflyVariants.Flights(Fineness.Report, done), done => DragonflyVariants.Tethered(Fineness.Report, done),
        WakeRows.Beating, WakeRows.Starting, WakeRows.Steady, WakeRows.Formation, WakeRows.Revolving, WakeRows.Hovering, WakeRows.Flapping,
        done => StructureRows.Droops(Fineness.Report, done), done => StructureRows.Motions(Fineness.Report, done),
    ];

    /// <summary>Writes the report.</summary>
    /// <param name="data">Folder of measured curves; null for none.</param>
    /// <param name="path">Where the files go.</param>
    /// <param name="front">Page that gets the rows of the front page; null for none.</param>
    /// <param name="output">Told the files.</param>
    /// <param name="measure">Makes the curves.</param>
    /// <param name="parts">Make the rows.</param>
    internal static void Run(string data, string path, string front, TextWriter output, Func<List<ValidationCurve>> measure,
        IReadOnlyList<Func<Action, IEnumerable<ValidationRow>>> parts)
    {
        if (data != null && !Directory.Exists(data))
            throw new UserException($"Cannot read '{data}': there is no such folder.");
        string page = front == null ? null : TextFile.Read(front, reader => reader.ReadToEnd()).ReplaceLineEndings("\n");
        if (page != null)
            PageBlock.Replace(page, Part, "", k_Name);
        using OutputFolder around = front == null ? null : OutputFolder.Around(front, front);
        using var folder = OutputFolder.Prepare(path, k_Page, k_Json, k_Charts);
        var rows = new List<ValidationRow>();
        var terminal = new Terminal(output);
        List<ValidationCurve> curves = measure();
        if (data != null)
            curves = UserCurves.Read(data, curves);
        terminal.ShowProgress(k_Stages, (done, _) =>
        {
            int stage = 0;
            rows.AddRange(parts.SelectMany(part => part(() => done(++stage))));
            if (data != null)
                rows.AddRange(UserCurves.Rows(curves));
            Write(folder, k_Page, ValidationPage.Markdown(rows, curves, k_Charts));
            Write(folder, k_Json, ValidationJson.Write(rows, curves));
            Write(folder, k_Charts, ValidationCharts.Draw(curves));
            around?.Write(Path.GetFileName(front),
                stream => stream.Write(Encoding.UTF8.GetBytes(PageBlock.Replace(page, Part, ValidationPage.Selection(rows), k_Name))));
            done(k_Stages);
        });
        folder.Commit();
        around?.Commit();
        output.WriteLine($"{rows.Count(row => row.IsCounted && row.IsInside)} of {rows.Count(row => row.IsCounted)} counted rows agree.");
        terminal.ShowFiles(path, k_Page, k_Json, k_Charts);
    }

    private static void Write(OutputFolder folder, string name, string text) =>
        folder.Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text)));

    private const string k_Examples =
        "Examples:\n"
        + "  validate\n"
        + "  validate --data curves --out mine\n"
        + "  validate --out Documentation~ --readme README.md\n\n"
        + "Writes into the output folder:\n"
        + "  validation.md          best physics, a row for each comparison, what moves those outside\n"
        + "  validation.json        the same with the curves\n"
        + "  images/validation.svg  curves over the beat beside the measured ones\n\n"
        + "Exit code: 0 when all is written, 2 for bad usage or input (nothing is written then).\n";
}
