namespace Alate.Cli;

/// <summary>A measurement that is written as a chart and a table.</summary>
/// <param name="Picture">Name of the chart's file, SVG.</param>
/// <param name="Table">Name of the table's file, CSV.</param>
internal sealed record ChartReport(string Picture, string Table)
{
    /// <summary>Measures with a bar of progress and writes both files; writes neither where something fails.</summary>
    /// <param name="terminal">Shows the progress.</param>
    /// <param name="path">The folder.</param>
    /// <param name="count">How many steps the measurement has.</param>
    /// <param name="measure">Measures; calls back with the number of steps that are done.</param>
    /// <param name="draw">Makes the chart.</param>
    /// <param name="write">Writes the table.</param>
    public List<T> Make<T>(Terminal terminal, string path, int count, Func<Action<int>, List<T>> measure, Func<List<T>, string> draw,
        Action<List<T>, Stream> write)
    {
        using var folder = OutputFolder.Prepare(path, Picture, Table);
        List<T> measured = null;
        terminal.ShowProgress(count, (done, _) =>
        {
            measured = measure(done);
            folder.Write(Picture, stream => stream.Write(Encoding.UTF8.GetBytes(draw(measured))));
            folder.Write(Table, stream => write(measured, stream));
        });
        folder.Commit();
        return measured;
    }
}
