namespace Alate.Cli;

/// <summary>Rows as a Markdown table; the first is its head.</summary>
internal static class MarkdownTable
{
    public static string Write(IEnumerable<IReadOnlyList<string>> rows)
    {
        var text = new StringBuilder();
        foreach (IReadOnlyList<string> row in rows)
        {
            bool isHead = text.Length == 0;
            Row(text, row.Select(cell => cell.Replace("|", "\\|")));
            if (isHead)
                Row(text, row.Select(_ => "---"));
        }

        return text.ToString();
    }

    private static void Row(StringBuilder text, IEnumerable<string> cells) => text.Append("| ").AppendJoin(" | ", cells).Append(" |\n");
}
