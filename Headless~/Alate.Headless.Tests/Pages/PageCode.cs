using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;

namespace Alate.Tests.Play;

/// <summary>Code on pages of the manual.</summary>
internal static class PageCode
{
    /// <summary>The blocks of a language on a page, in order.</summary>
    public static string[] Of(string page, string language = "csharp") => Regex.Matches(
            File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", page)).ReplaceLineEndings("\n"),
            $"^```{language}\n(.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline)
        .Select(block => block.Groups[1].Value).ToArray();
}
