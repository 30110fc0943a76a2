using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Alate.Mutations.Sources;
using Alate.Mutations.Trials;

namespace Alate.Mutations;

/// <summary>Findings of a run, by room.</summary>
internal sealed class Report(IReadOnlyList<(string Room, Mutant Mutant, Verdict Verdict)> results)
{
    private const string k_Begin = "<!-- mutations: written by .ci/mutate --write -->", k_End = "<!-- end of mutations -->";

    /// <summary>Files with mutants that no test meets, those with most of them first: how many of how many, and their lines.</summary>
    public static string Unmet(IEnumerable<(string File, int Line, bool IsMet)> mutants)
    {
        var list = new StringBuilder();
        foreach (IGrouping<string, (string File, int Line, bool IsMet)> file in mutants.GroupBy(one => one.File)
            .Where(file => file.Any(one => !one.IsMet)).OrderByDescending(file => file.Count(one => !one.IsMet)))
        {
            IEnumerable<int> lines = file.Where(one => !one.IsMet).Select(one => one.Line).Distinct().Order();
            list.AppendLine($"{file.Count(one => !one.IsMet)} of {file.Count()}  {file.Key}:{string.Join(',', lines)}");
        }

        return list.ToString();
    }

    /// <summary>Table by room, as Markdown.</summary>
    public string Table()
    {
        var table = new StringBuilder("| room | mutants | found | by held numbers alone | survived | not reached | equivalent | score |\n");
        table.Append("|---|---|---|---|---|---|---|---|\n");
        foreach (IGrouping<string, (string Room, Mutant Mutant, Verdict Verdict)> room
            in results.GroupBy(result => result.Room).OrderBy(room => room.Key, StringComparer.Ordinal))
        {
            table.Append(Row(room.Key, room.Select(result => result.Verdict.Outcome).ToList()));
        }

        return table.Append(Row("all", results.Select(result => result.Verdict.Outcome).ToList())).ToString();
    }

    /// <summary>Mutants of one outcome, a block each.</summary>
    public string List(Outcome outcome)
    {
        var list = new StringBuilder();
        foreach ((string room, Mutant mutant, Verdict verdict) in results.Where(result => result.Verdict.Outcome == outcome))
        {
            list.AppendLine($"{mutant.File}:{mutant.Line}  [{room}]");
            list.AppendLine($"  {mutant.Title}");
            list.AppendLine($"  in: {mutant.Text}");
            if (verdict.How.Length > 0)
                list.AppendLine($"  because: {verdict.How}");
        }

        return list.ToString();
    }

    /// <summary>Puts the table between its marks in a page.</summary>
    public void Write(string page, string heading)
    {
        string text = File.ReadAllText(page);
        int begin = text.IndexOf(k_Begin, StringComparison.Ordinal), end = text.IndexOf(k_End, StringComparison.Ordinal);
        if (begin < 0 || end < begin)
            throw new InvalidOperationException($"{page} lacks the marks between which the table stands: {k_Begin} and {k_End}.");
        File.WriteAllText(page, $"{text[..(begin + k_Begin.Length)]}\n{heading}\n\n{Table()}{text[end..]}");
    }

    private static string Row(string room, List<Outcome> outcomes)
    {
        int Count(Outcome outcome) => outcomes.Count(one => one == outcome);
        int tried = outcomes.Count - Count(Outcome.Equivalent);
        int found = Count(Outcome.Found) + Count(Outcome.FoundByNumber);
        string score = tried == 0 ? "" : $"{100.0 * found / tried:0} %";
        return $"| {room} | {outcomes.Count} | {found} | {Count(Outcome.FoundByNumber)} | {Count(Outcome.Survived)} "
            + $"| {Count(Outcome.NotReached)} | {Count(Outcome.Equivalent)} | {score} |\n";
    }
}
