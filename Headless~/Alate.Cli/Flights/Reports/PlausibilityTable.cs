using Spectre.Console;

namespace Alate.Cli;

/// <summary>Table of an insect's numbers beside those of real ones on the terminal, with the questions about units.</summary>
internal static class PlausibilityTable
{
    /// <summary>Shows the table, the sources of what lies outside, and the questions.</summary>
    public static void ShowPlausibility(this Terminal terminal, string heading, Plausibility plausibility)
    {
        terminal.Lines.WriteLine(heading);
        Table table = new Table().Border(TableBorder.Rounded).AddColumn("number");
        foreach (WingGroups wing in plausibility.Wings)
            table.AddColumn(new TableColumn(plausibility.Wings.Count == 1 ? "" : Markup.Escape(wing.Wing)).RightAligned());
        table.AddColumn(new TableColumn("real insects").RightAligned());
        foreach (GroupBound bound in GroupBound.All)
        {
            if (plausibility.Wings.Any(wing => !double.IsNaN(bound.Of(wing))))
                table.AddRow([bound.Title, .. plausibility.Wings.Select(bound.Cell), bound.Range]);
        }

        terminal.Lines.Write(table);
        TextWriter unwrapped = terminal.Lines.Profile.Out.Writer;
        foreach (GroupBound bound in plausibility.Outside)
            unwrapped.WriteLine($"† {bound.Title} is outside {bound.Range} ({bound.Source}).");
        foreach (string doubt in plausibility.Doubts)
            unwrapped.WriteLine("? " + doubt);
    }
}
