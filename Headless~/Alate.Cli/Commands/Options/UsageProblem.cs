using System.CommandLine;
using System.CommandLine.Parsing;

namespace Alate.Cli;

/// <summary>Says in one line why a command line is not understood.</summary>
internal static class UsageProblem
{
    /// <summary>The problem; null where the command line is understood.</summary>
    public static string Find(ParseResult parsed)
    {
        Command command = parsed.CommandResult.Command;
        if (command.Subcommands.Count > 0 && parsed.UnmatchedTokens.Count > 0)
            return Unknown(parsed.UnmatchedTokens[0], parsed.RootCommandResult.Command, command);
        if (HelpExamples.AreAskedFor(parsed))
            return null;
        if ((WithoutValue(parsed) ?? UnknownOption(parsed)) is string misplaced)
            return misplaced;
        if (parsed.Errors.Count == 0)
            return null;
        return command.Subcommands.Count > 0
            ? $"'{command.Name}' needs a command. {Known(command)}"
            : QuotedMessage.Values(parsed.Errors[0].Message);
    }

    private static bool IsOption(string word) => word.Length > 2 && word.StartsWith("--", StringComparison.Ordinal);

    // An option stands where the value should; a file of such a name can be given as ./--name.
    private static string WithoutValue(ParseResult parsed)
    {
        Command command = parsed.CommandResult.Command;
        foreach (OptionResult given in parsed.CommandResult.Children.OfType<OptionResult>().Where(given => !given.Implicit))
        {
            Token next = given.Tokens.FirstOrDefault(
                token => IsOption(token.Value) || command.Options.Any(known => known.Aliases.Contains(token.Value)));
            if (next != null)
                return $"{given.Option.Name} needs a value; behind it stands the option {Quote.Of(next.Value)}.";
        }

        return null;
    }

    // One that is taken for an argument, or for nothing.
    private static string UnknownOption(ParseResult parsed)
    {
        Command command = parsed.CommandResult.Command;
        string word = parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(given => given.Tokens).Select(token => token.Value)
            .Concat(parsed.UnmatchedTokens).FirstOrDefault(IsOption);
        if (word == null)
            return null;
        if (command.Options.Any(known => known.Name == word))
            return $"'{word}' stands in a wrong place, such as behind '--'.";
        (string name, int distance) = command.Options.Select(known => (known.Name, Distance(word.ToLowerInvariant(), known.Name)))
            .MinBy(known => known.Item2);
        string nearest = distance <= 1 + word.Length / 4 ? $" Did you mean '{name}'?" : "";
        return $"'{command.Name}' has no option {Quote.Of(word)}.{nearest} '--help' lists them.";
    }

    private static string Unknown(string word, Command root, Command command)
    {
        if (word.StartsWith('-'))
            return $"Unknown option {Quote.Of(word)}. {Known(command)}";
        (string path, int distance) = Paths(root, "").Select(known => (known.Path, Distance(word.ToLowerInvariant(), known.Name)))
            .MinBy(known => known.Item2);
        if (path == word)
            return $"'{path}' stands in a wrong place, such as behind '--'. {Known(command)}";
        string nearest = distance <= 1 + word.Length / 4 ? $" Did you mean '{path}'?" : "";
        return $"Unknown command {Quote.Of(word)}.{nearest} {Known(command)}";
    }

    private static string Known(Command command) =>
        $"Commands: {string.Join(", ", command.Subcommands.Select(known => known.Name))}.";

    // Every command with the words that lead to it.
    private static IEnumerable<(string Name, string Path)> Paths(Command command, string path)
    {
        foreach (Command known in command.Subcommands)
        {
            yield return (known.Name, path + known.Name);
            foreach ((string, string) below in Paths(known, path + known.Name + " "))
                yield return below;
        }
    }

    // How many letters must be put in, taken out or changed to make one word of the other.
    private static int Distance(string a, string b)
    {
        int[] before = Enumerable.Range(0, b.Length + 1).ToArray();
        for (int i = 1; i <= a.Length; i++)
        {
            int[] row = new int[b.Length + 1];
            row[0] = i;
            for (int j = 1; j <= b.Length; j++)
                row[j] = Math.Min(before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), 1 + Math.Min(before[j], row[j - 1]));
            before = row;
        }

        return before[b.Length];
    }
}
