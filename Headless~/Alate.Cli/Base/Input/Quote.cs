using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>Quotes values of users in messages: as much of them as finds the place.</summary>
internal static partial class Quote
{
    /// <summary>Most characters of a value, and of any word: a file's path is one.</summary>
    private const int k_Value = 60, k_Word = 260;

    /// <summary>A value in quotation marks, up to 60 characters.</summary>
    public static string Of(string value) => $"'{Short(value, k_Value)}'";

    /// <summary>A message of a library, in which each quoted value has up to 60 characters.</summary>
    public static string Values(string message) => InQuotes().Replace(message, found => Of(found.Groups[1].Value));

    /// <summary>A message in which no word is longer than a path.</summary>
    public static string Words(string message) => LongWords().Replace(message, found => Short(found.Value, k_Word));

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

    private static string Short(string text, int most)
    {
        if (text.Length <= most)
            return text;
        int end = char.IsHighSurrogate(text[most - 1]) ? most - 1 : most;
        return text[..end] + "…";
    }

    [GeneratedRegex("'([^']{61,})'")]
    private static partial Regex InQuotes();

    [GeneratedRegex(@"\S{261,}")]
    private static partial Regex LongWords();
}
