using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>Shortens what others put into messages, as <see cref="Quote"/> does with values.</summary>
internal static partial class QuotedMessage
{
    /// <summary>Most characters of any word: a file's path is one.</summary>
    private const int k_Word = 260;

    /// <summary>A message of a library, in which each quoted value has up to 60 characters.</summary>
    public static string Values(string message) => InQuotes().Replace(message, found => Quote.Of(found.Groups[1].Value));

    /// <summary>A message in which no word is longer than a path.</summary>
    public static string Words(string message) => LongWords().Replace(message, found => Quote.Short(found.Value, k_Word));

    /// <summary>The beginning of a text that has at most so many bytes in UTF-8, without half a character at its end.</summary>
    public static string Bytes(string text, int most)
    {
        if (Encoding.UTF8.GetByteCount(text) <= most)
            return text;
        int length = 0, left = most - "…"u8.Length;
        foreach (Rune rune in text.EnumerateRunes())
        {
            left -= rune.Utf8SequenceLength;
            if (left < 0)
                break;
            length += rune.Utf16SequenceLength;
        }

        return text[..length] + "…";
    }

    [GeneratedRegex("'([^']{61,})'")]
    private static partial Regex InQuotes();

    [GeneratedRegex(@"\S{261,}")]
    private static partial Regex LongWords();
}
