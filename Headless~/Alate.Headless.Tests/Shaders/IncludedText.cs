using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Alate.Tests.Shaders;

/// <summary>Text of a program with all that it includes, without comments and pragmas, to see which keywords it asks for.</summary>
internal static class IncludedText
{
    public static string Of(string text, string folder, IReadOnlyList<string> includes)
    {
        var all = new StringBuilder();
        Add(text, folder, includes, all, new HashSet<string>());
        return all.ToString();
    }

    private static void Add(string text, string folder, IReadOnlyList<string> includes, StringBuilder all, HashSet<string> seen)
    {
        all.AppendLine(Regex.Replace(text, @"//[^\n]*|#pragma[^\n]*", ""));
        foreach (Match include in Regex.Matches(text, "#include(?:_with_pragmas)? \"([^\"]+)\""))
        {
            string found = includes.Prepend(folder).Select(root => Path.GetFullPath(Path.Combine(root, include.Groups[1].Value)))
                .FirstOrDefault(File.Exists)
                ?? throw new FileNotFoundException($"There is no stand-in for what the shader includes: {include.Groups[1].Value}");
            if (seen.Add(found))
                Add(File.ReadAllText(found), Path.GetDirectoryName(found), includes, all, seen);
        }
    }
}
