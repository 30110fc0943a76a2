using System.Collections.Generic;
using System.Linq;

namespace Alate.Tests.Cli;

/// <summary>Tables of the terminal, cell by cell; a row with one cell alone, or none in front, belongs to the one before.</summary>
internal static class TerminalTable
{
    /// <summary>Rows of the table behind a heading, the first of them its own heading.</summary>
    public static string[][] Behind(string output, string heading)
    {
        string[] lines = [.. output.ReplaceLineEndings("\n").Split('\n')];
        int start = System.Array.FindIndex(lines, line => line.StartsWith($"── {heading} ─"));
        var rows = new List<string[]>();
        bool isHeading = true;
        foreach (string line in lines.Skip(start + 1).TakeWhile(line => !line.StartsWith('╰')))
        {
            isHeading &= !line.StartsWith('├');
            if (!line.StartsWith('│'))
                continue;
            string[] cells = [.. line[1..^1].Split('│').Select(cell => cell.Trim())];
            bool goesOn = rows.Count > 0 && (isHeading || (rows.Count > 1
                && (cells[0].Length == 0 || cells.Skip(1).All(cell => cell.Length == 0))));
            if (goesOn)
                rows[^1] = [.. rows[^1].Zip(cells, (one, more) => $"{one} {more}".Trim())];
            else
                rows.Add(cells);
        }

        return [.. rows];
    }
}
