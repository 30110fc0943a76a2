using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Alate.Tests.Shaders;

/// <summary>Keyword sets that Unity compiles a program with, from its multi_compile pragmas.</summary>
internal static class KeywordSets
{
    private const string k_None = "_";

    private static readonly Dictionary<string, string[][]> s_Shortcuts = new()
    {
        ["fog"] = [[k_None, "FOG_LINEAR", "FOG_EXP", "FOG_EXP2"]],
        ["instancing"] = [[k_None, "INSTANCING_ON"]],
        ["shadowcaster"] = [["SHADOWS_DEPTH", "SHADOWS_CUBE"]],
        ["fwdbase"] =
        [
            ["DIRECTIONAL"], [k_None, "SHADOWS_SCREEN"], [k_None, "LIGHTPROBE_SH"], [k_None, "VERTEXLIGHT_ON"], [k_None, "LIGHTMAP_ON"],
            [k_None, "DIRLIGHTMAP_COMBINED"], [k_None, "DYNAMICLIGHTMAP_ON"], [k_None, "SHADOWS_SHADOWMASK"], [k_None, "LIGHTMAP_SHADOW_MIXING"],
        ],
        ["fwdadd_fullshadows"] =
        [
            [
                "POINT", "DIRECTIONAL", "SPOT", "POINT_COOKIE", "DIRECTIONAL_COOKIE", "POINT SHADOWS_CUBE", "DIRECTIONAL SHADOWS_SCREEN", "SPOT SHADOWS_DEPTH",
                "POINT_COOKIE SHADOWS_CUBE", "DIRECTIONAL_COOKIE SHADOWS_SCREEN",
            ],
            [k_None, "SHADOWS_SOFT"], [k_None, "SHADOWS_SHADOWMASK"], [k_None, "LIGHTMAP_SHADOW_MIXING"],
        ],
    };

    /// <summary>Macros of every variant of a stage: keywords that are set, and for each that is declared the macro by which Unity says so.</summary>
    /// <param name="program">Code with its pragmas.</param>
    /// <param name="stage">"vertex" or "fragment".</param>
    /// <param name="mentioned">Code that is compiled, with all that it includes: keywords that it never mentions change nothing and are left out.</param>
    public static IEnumerable<string[]> Of(string program, string stage, string mentioned)
    {
        List<string[]> choices = [.. Choices(program, stage)];
        string[] declared = [.. choices.SelectMany(choice => choice).SelectMany(Words).Distinct().Select(keyword => keyword + "_KEYWORD_DECLARED")];

        // Set by Unity where a headset draws both eyes at once.
        choices.Add([k_None, "UNITY_STEREO_INSTANCING_ENABLED"]);
        IEnumerable<string[]> sets = [[]];
        foreach (string[] choice in choices)
        {
            string[] kept = [.. choice.Select(words => string.Join(" ", Words(words).Where(word => Mentions(mentioned, word)))).Distinct()];
            sets = [.. sets.SelectMany(set => kept.Select(words => set.Concat(Words(words)).ToArray()))];
        }

        return sets.Select(set => set.Concat(declared).ToArray());
    }

    private static IEnumerable<string[]> Choices(string program, string stage)
    {
        foreach (Match pragma in Regex.Matches(program, @"#pragma multi_compile(_\w+)?([^\n]*)"))
        {
            string suffix = Regex.Replace(pragma.Groups[1].Value.TrimStart('_'), "^local_?", "");
            string[] words = pragma.Groups[2].Value.Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (suffix is "" || suffix == stage)
            {
                yield return words;
            }
            else if (words.Length == 0)
            {
                // A shortcut that is not listed fails here, to be added.
                foreach (string[] choice in s_Shortcuts[suffix])
                    yield return choice;
            }
        }
    }

    private static IEnumerable<string> Words(string keywords) => keywords.Split(' ').Where(word => word.Trim('_').Length > 0);

    private static bool Mentions(string text, string word) => Regex.IsMatch(text, $@"\b{word}\b");
}
