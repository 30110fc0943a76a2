using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Alate.Tests.Shaders;

/// <summary>Text of a ShaderLab file, taken apart into what is compiled.</summary>
internal sealed class ShaderFile
{
    private readonly string m_Text;

    public ShaderFile(string text)
    {
        m_Text = Regex.Replace(text, @"//[^\n]*", "");
    }

    /// <summary>SubShaders in order; Unity takes the first whose requirements are met.</summary>
    public IReadOnlyList<SubShader> SubShaders => [.. Blocks(m_Text, "SubShader").Select(block => new SubShader(block))];

    /// <summary>Finds what stands between the braces after each mention of a word.</summary>
    private static IEnumerable<string> Blocks(string text, string word)
    {
        foreach (Match start in Regex.Matches(text, $@"^\s*{word}\s*\{{", RegexOptions.Multiline))
        {
            int depth = 1, end = start.Index + start.Length;
            for (; depth > 0; end++)
                depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
            yield return text[(start.Index + start.Length)..(end - 1)];
        }
    }

    /// <summary>SubShader with the version of URP that it asks for and its passes.</summary>
    internal sealed class SubShader
    {
        private const string k_Universal = "com.unity.render-pipelines.universal";

        public SubShader(string text)
        {
            Match required = Regex.Match(text, $"\"{Regex.Escape(k_Universal)}\"\\s*:\\s*\"([^\"]+)\"");
            Universal = required.Success ? required.Groups[1].Value : null;
            string included = string.Concat(
                Regex.Matches(text, @"(?:HLSL|CG)INCLUDE\b(.*?)END(?:HLSL|CG)\b", RegexOptions.Singleline).Select(m => m.Groups[1].Value));
            Tags = Blocks(text, "Tags").FirstOrDefault() ?? "";
            Passes = [.. Blocks(text, "Pass").Select(pass => new Pass(pass, included))];
        }

        /// <summary>Range of versions of URP; null asks for none, as the built-in pipeline does.</summary>
        public string Universal { get; }

        /// <summary>Text of its tags.</summary>
        public string Tags { get; }

        public IReadOnlyList<Pass> Passes { get; }

        /// <summary>Tells whether a version is in the range: "14.0.0" and newer, or "[14.0.0,17.1.0)".</summary>
        public bool Takes(Version version)
        {
            if (Universal == null)
                return false;
            Match range = Regex.Match(Universal, @"^([\[(])([\d.]+),([\d.]+)([\])])$");
            if (!range.Success)
                return version >= Version.Parse(Universal);
            Version least = Version.Parse(range.Groups[2].Value), most = Version.Parse(range.Groups[3].Value);
            bool isAbove = range.Groups[1].Value == "[" ? version >= least : version > least;
            return isAbove && (range.Groups[4].Value == "]" ? version <= most : version < most);
        }
    }

    /// <summary>Pass with the program that is compiled for it.</summary>
    internal sealed class Pass
    {
        public Pass(string text, string included)
        {
            Name = Regex.Match(text, "Name \"(\\w+)\"").Groups[1].Value;
            LightMode = Regex.Match(text, "\"LightMode\" = \"(\\w+)\"").Groups[1].Value;
            Program = included + Regex.Match(text, @"(?:HLSL|CG)PROGRAM\b(.*?)END(?:HLSL|CG)\b", RegexOptions.Singleline).Groups[1].Value;
        }

        public string Name { get; }

        public string LightMode { get; }

        /// <summary>Code with its pragmas, after the included blocks of its SubShader.</summary>
        public string Program { get; }

        /// <summary>Name of a stage's function, from the pragma "vertex" or "fragment".</summary>
        public string EntryOf(string stage) => Regex.Match(Program, $@"#pragma {stage} (\w+)").Groups[1].Value;
    }
}
