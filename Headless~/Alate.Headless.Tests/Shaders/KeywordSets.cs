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
            [k_None, "DIRLIGHTMAP_COMBINED"], [k_None, "DYNAMICLIGHTMAP_ON"], [k_None, "SHADOWS_SHADOWMASK"],
            [k_None, "LIGHTMAP_SHADOW_MIXING"],
        ],
        ["fwdadd_fullshadows"] =
        [
            [
                "POINT", "DIRECTIONAL", "SPOT", "POINT_COOKIE", "DIRECTIONAL_COOKIE", "POINT SHADOWS_CUBE", "DIRECTIONAL SHADOWS_SCREEN",
                "SPOT SHADOWS_DEPTH",
                "POINT_COOKIE SHADOWS_CUBE", "DIRECTIONAL_COOKIE SHADOWS_SCREEN",
            ],
            [k_None, "SHADOWS_SOFT"], [k_None, "SHADOWS_SHADOWMASK"], [k_None, "LIGHTMAP_SHADOW_MIXING"],
        ],
    };

    /// <summary>
    /// Macros of every variant of a stage: keywords that are set, and for each that is declared the macro by which Unity says so.
    /// </summary>
    /// <param name="program">Code with its pragmas.</param>
    /// <param name="stage">"vertex" or "fragment".</param>
    /// <param name="mentioned">Code that is compiled, with all that it includes: keywords that it never mentions change nothing and are
    /// left out.</param>
    public static IEnumerable<string[]> Of(string program, string stage, string mentioned) =>
        Macros(program, stage, Product(program, stage, mentioned));

    /// <summary>Macros of so many variants of a stage that any two lines of the pragmas meet in every two of their keywords.</summary>
    /// <inheritdoc cref="Of"/>
    public static IEnumerable<string[]> PairsOf(string program, string stage, string mentioned) =>
        Covering(program, stage, mentioned, Pairs);

    /// <summary>Macros of variants of a stage that together set every keyword.</summary>
    /// <inheritdoc cref="Of"/>
    public static IEnumerable<string[]> EachOf(string program, string stage, string mentioned) =>
        Covering(program, stage, mentioned, set => set.Select((words, line) => (line, words)));

    private static IEnumerable<string[]> Covering<T>(string program, string stage, string mentioned, Func<string[], IEnumerable<T>> parts)
    {
        List<string[]> left = Product(program, stage, mentioned), taken = [];
        HashSet<T> met = [];
        while (true)
        {
            string[] best = left.MaxBy(set => parts(set).Count(part => !met.Contains(part)));
            if (taken.Count > 0 && parts(best).All(met.Contains))
                return Macros(program, stage, taken);
            taken.Add(best);
            met.UnionWith(parts(best));
        }
    }

    // One keyword, several or none of each choice.
    private static List<string[]> Product(string program, string stage, string mentioned)
    {
        List<string[]> sets = [[]];

        // The last is set by Unity where a headset draws both eyes at once.
        foreach (string[] choice in Choices(program, stage).Append([k_None, "UNITY_STEREO_INSTANCING_ENABLED"]))
        {
            string[] kept = [.. choice.Select(words => string.Join(" ", Words(words).Where(word => Mentions(mentioned, word)))).Distinct()];
            sets = [.. sets.SelectMany(set => kept.Select(words => set.Append(words).ToArray()))];
        }

        return sets;
    }

    private static IEnumerable<(int, string, int, string)> Pairs(string[] set)
    {
        for (int k = 0; k < set.Length; k++)
        {
            for (int other = 0; other < k; other++)
                yield return (other, set[other], k, set[k]);
        }
    }

    private static IEnumerable<string[]> Macros(string program, string stage, List<string[]> sets)
    {
        string[] declared = [.. Choices(program, stage).SelectMany(choice => choice).SelectMany(Words).Distinct()
            .Select(keyword => keyword + "_KEYWORD_DECLARED")];
        return sets.Select(set => set.SelectMany(Words).Concat(declared).ToArray());
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
