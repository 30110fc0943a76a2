using System.CommandLine;

namespace Alate.Cli;

/// <summary>Options that take one of a few words.</summary>
internal static class Choice
{
    /// <summary>An option whose value is null when it is not given.</summary>
    public static Option<T?> Optional<T>(string name, string description, Dictionary<string, T> values) where T : struct => new(name)
    {
        Description = description,
        HelpName = string.Join("|", values.Keys),
        CustomParser = result =>
        {
            string text = result.Tokens.Count > 0 ? result.Tokens[0].Value : "";
            if (values.TryGetValue(text.ToLowerInvariant(), out T value))
                return value;
            result.AddError($"{name} takes {string.Join(", ", values.Keys.SkipLast(1))} or {values.Keys.Last()}, not {Quote.Of(text)}.");
            return null;
        },
    };
}
