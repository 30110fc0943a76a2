using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Alate.Tests.Shaders;

/// <summary>
/// Makes HLSL of one type of real numbers: <c>half</c> is <c>float</c>, and functions that differ by that alone are one. For glslang, which
/// takes both types for the same and refuses the second function.
/// </summary>
internal static class OneFloatType
{
    private static readonly Regex s_Half = new(@"\b(?:half|min16float)([2-4](?:x[2-4])?)?\b");

    // Macros put many functions on one line: each begins a line, or follows the end of something.
    private static readonly Regex s_Function = new(
        @"(?:^|(?<=[};]))[ \t]*(?:(?:inline|static) )?[A-Za-z_]\w*[ \t]+([A-Za-z_]\w*)[ \t]*\(([^(){};]*)\)\s*\{", RegexOptions.Multiline);

    private static readonly Regex s_Direction = new(@"\b(?:in|out|inout|const|uniform)\b");

    /// <summary>Rewrites a preprocessed program.</summary>
    public static string Of(string program)
    {
        string text = s_Half.Replace(program, "float$1");
        var merged = new StringBuilder();
        var seen = new HashSet<string>();
        int at = 0;
        for (Match function = s_Function.Match(text); function.Success; function = s_Function.Match(text, at))
        {
            int end = EndOf(text, function.Index + function.Length - 1);
            merged.Append(text, at, function.Index - at);
            if (seen.Add(function.Groups[1].Value + "(" + Types(function.Groups[2].Value)))
                merged.Append(text, function.Index, end - function.Index);
            at = end;
        }

        return merged.Append(text, at, text.Length - at).ToString();
    }

    private static string Types(string parameters) => string.Join(",", s_Direction.Replace(parameters, " ").Split(',')
        .Select(parameter => parameter.Split(' ', System.StringSplitOptions.RemoveEmptyEntries).FirstOrDefault()));

    private static int EndOf(string text, int brace)
    {
        int depth = 0;
        for (int at = brace; at < text.Length; at++)
        {
            depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
            if (depth == 0)
                return at + 1;
        }

        return text.Length;
    }
}
