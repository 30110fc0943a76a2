using System;
using System.Collections.Generic;
using System.Globalization;

namespace Alate.Mutations;

/// <summary>Words of the command.</summary>
internal sealed class Options
{
    public const string Usage = """
        .ci/mutate [ROOM ...] [--seed N] [--count N] [--write] [--found] [--reach]
          ROOM     rooms whose names begin so, in any case: Geometry, Model, Model/Forces, Editor, Cli; all without one
          --seed   draws the same mutants again; without it a seed is drawn and printed
          --count  mutants in all, spread evenly over the outermost rooms, one an assembly; 300
          --write  puts the table into CONTRIBUTING.md
          --found  lists also what was found, and by which test
          --reach  tries none: lists by file how many of them no test meets
        """;

    public List<string> Rooms { get; } = [];

    public int Seed { get; private set; } = Random.Shared.Next(1, 1_000_000);

    public int Count { get; private set; } = 300;

    public bool Write { get; private set; }

    public bool Found { get; private set; }

    public bool Reach { get; private set; }

    /// <exception cref="FormatException">A word is none of the usage's.</exception>
    public static Options Parse(IReadOnlyList<string> words)
    {
        var options = new Options();
        for (int i = 0; i < words.Count; i++)
        {
            switch (words[i])
            {
                case "--seed":
                    options.Seed = Number(words, ++i);
                    break;
                case "--count":
                    options.Count = Number(words, ++i);
                    break;
                case "--write":
                    options.Write = true;
                    break;
                case "--found":
                    options.Found = true;
                    break;
                case "--reach":
                    options.Reach = true;
                    break;
                case var word when word.StartsWith('-'):
                    throw new FormatException($"\"{word}\" is no option.\n{Usage}");
                default:
                    options.Rooms.Add(words[i]);
                    break;
            }
        }

        return options;
    }

    /// <summary>Returns true for a room that was asked for.</summary>
    public bool Asks(string room) => Rooms.Count == 0 || Rooms.Exists(asked => room.StartsWith(asked, StringComparison.OrdinalIgnoreCase));

    private static int Number(IReadOnlyList<string> words, int at)
    {
        string word = at < words.Count ? words[at] : "";
        return int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number > 0
            ? number
            : throw new FormatException($"{words[at - 1]} takes a whole number above 0, not \"{word}\".");
    }
}
