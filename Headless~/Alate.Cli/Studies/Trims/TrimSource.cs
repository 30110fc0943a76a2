namespace Alate.Cli;

/// <summary>Writes a trim table into the package's sources.</summary>
internal static class TrimSource
{
    private const int k_Columns = 120, k_Line = 140;

    /// <summary>Path of an insect's table.</summary>
    public static string PathOf(InsectDefinition insect) =>
        Path.Combine(PackageRoot.Find(), "Runtime", "Catalogue", "Flight", "Tables", NameOf(insect) + ".cs");

    /// <summary>The source.</summary>
    /// <param name="insect">Of the table.</param>
    /// <param name="text">The table.</param>
    /// <param name="options">Of the command line, where other speeds and climbs than its own were asked for.</param>
    public static string Write(InsectDefinition insect, string text, string options)
    {
        var source = new StringBuilder();
        source.Append("namespace Alate.Catalogue\n{\n");
        string summary = $"Trim table of the {insect.DisplayName.ToLowerInvariant()}, made by the command line: "
            + $"trim {insect.Name} --bake{options}.", line = $"    /// <summary>{summary}</summary>\n";
        string lines = $"    /// <summary>\n    /// {summary}\n    /// </summary>\n".Replace(": trim ", ":\n    /// trim ");
        source.Append(line.Length <= k_Line + 1 ? line : lines);
        source.Append($"    internal static class {NameOf(insect)}\n    {{\n        public const string Text =\n");
        for (int at = 0; at < text.Length; at += k_Columns)
        {
            string part = text.Substring(at, Math.Min(k_Columns, text.Length - at));
            source.Append($"            \"{part}\"{(at + k_Columns < text.Length ? " +" : ";")}\n");
        }

        return source.Append("    }\n}\n").ToString();
    }

    private static string NameOf(InsectDefinition insect) =>
        string.Concat(insect.Name.Split('-').Select(word => char.ToUpperInvariant(word[0]) + word[1..])) + "Trims";
}
