namespace Alate.Cli;

/// <summary>A part of a page that a command writes: what stands between two marks that name it.</summary>
internal static class PageBlock
{
    /// <summary>The mark before a part.</summary>
    public static string Begin(string part, string command = "figures") => $"<!-- {part}: written by the command {command} -->\n";

    /// <summary>The mark after a part.</summary>
    public static string End(string part) => $"<!-- end of {part} -->";

    /// <summary>The page with another text between the marks of a part.</summary>
    /// <param name="page">The whole page, lines ended by \n.</param>
    /// <param name="part">What its marks name.</param>
    /// <param name="text">Whole lines.</param>
    /// <param name="command">The command that writes the part.</param>
    /// <exception cref="UserException">The marks are not there.</exception>
    public static string Replace(string page, string part, string text, string command = "figures")
    {
        string begin = Begin(part, command), end = End(part);
        int from = page.IndexOf(begin, StringComparison.Ordinal), to = page.IndexOf(end, StringComparison.Ordinal);
        if (from < 0 || to < from)
            throw new UserException($"The page has no lines '{begin.Trim()}' and '{end}', between which that part could stand.");
        return page[..(from + begin.Length)] + text + page[to..];
    }
}
