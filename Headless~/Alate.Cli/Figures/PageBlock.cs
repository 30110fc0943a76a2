using System;

namespace Alate.Cli.Figures;

/// <summary>Replaces what stands between two marks of a page.</summary>
internal static class PageBlock
{
    public const string Begin = "<!-- measured: written by the command figures -->\n", End = "<!-- end of measured -->";

    /// <summary>The page with another text between its marks.</summary>
    /// <exception cref="UserException">The marks are not there.</exception>
    public static string Replace(string page, string text, string name)
    {
        int from = page.IndexOf(Begin, StringComparison.Ordinal), to = page.IndexOf(End, StringComparison.Ordinal);
        if (from < 0 || to < from)
            throw new UserException($"'{name}' has no lines '{Begin.Trim()}' and '{End}' for the table to stand between.");
        return page[..(from + Begin.Length)] + text + page[to..];
    }
}
