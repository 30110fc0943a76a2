using Spectre.Console;

namespace Alate.Cli;

/// <summary>
/// Output on the terminal: a bar while work is done, tables in the end. Redirected output gets the table alone, without colours.
/// </summary>
internal sealed class Terminal
{
    private const int k_RedirectedWidth = 100;

    private readonly bool m_IsRedirected;

    public Terminal(TextWriter output)
    {
        m_IsRedirected = output != Console.Out || Console.IsOutputRedirected;
        Lines = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Out = new AnsiConsoleOutput(output),
            Ansi = m_IsRedirected ? AnsiSupport.No : AnsiSupport.Detect,
            ColorSystem = m_IsRedirected ? ColorSystemSupport.NoColors : ColorSystemSupport.Detect,
            Interactive = m_IsRedirected ? InteractionSupport.No : InteractionSupport.Detect,
        });
        if (m_IsRedirected)
            Lines.Profile.Width = k_RedirectedWidth;
    }

    /// <summary>Console for what no other member shows.</summary>
    public IAnsiConsole Lines { get; }

    /// <summary>Runs the work under a progress bar.</summary>
    /// <param name="steps">Substeps of the flight, or other steps of the work.</param>
    /// <param name="work">Told where to report steps done, and the name of what follows them.</param>
    public void ShowProgress(int steps, Action<Action<int>, Action<string>> work)
    {
        if (m_IsRedirected)
        {
            work(_ => { }, _ => { });
            return;
        }

        Lines.Progress().AutoClear(true).HideCompleted(false)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new SpinnerColumn())
            .Start(context =>
            {
                ProgressTask task = context.AddTask("flying", maxValue: steps);
                work(done => task.Value = done, stage => task.Description = stage);
            });
    }

    /// <summary>Shows a table: the first row is its head, the first column names, the others numbers.</summary>
    /// <param name="heading">Its heading.</param>
    /// <param name="rows">All of one length.</param>
    /// <param name="names">First columns that are not broken into lines.</param>
    public void ShowTable(string heading, IEnumerable<IReadOnlyList<string>> rows, int names = 0) =>
        ShowTable(heading, rows, Justify.Right, names);

    /// <summary>Shows a table of texts.</summary>
    public void ShowTexts(string heading, IEnumerable<IReadOnlyList<string>> rows) => ShowTable(heading, rows, Justify.Left, 1);

    private void ShowTable(string heading, IEnumerable<IReadOnlyList<string>> rows, Justify side, int names)
    {
        Lines.Write(new Rule($"[bold]{Markup.Escape(heading)}[/]").LeftJustified());
        Table table = null;
        foreach (IReadOnlyList<string> row in rows)
        {
            if (table != null)
            {
                table.AddRow(row.Select(Markup.Escape).ToArray());
                continue;
            }

            table = new Table().Border(TableBorder.Rounded).AddColumn(new TableColumn(Markup.Escape(row[0])) { NoWrap = names > 0 });
            for (int k = 1; k < row.Count; k++)
                table.AddColumn(new TableColumn(Markup.Escape(row[k])) { Alignment = side, NoWrap = k < names });
        }

        Lines.Write(table);
    }

    /// <summary>Says where the files are.</summary>
    public void ShowFiles(string folder, params string[] files)
    {
        TextWriter unwrapped = Lines.Profile.Out.Writer;
        unwrapped.WriteLine("Written:");
        foreach (string file in files)
            unwrapped.WriteLine("  " + Path.Combine(folder, file));
    }
}
