using System;
using System.Collections.Generic;

namespace StandIns;

/// <summary>Dialogs that a test answers.</summary>
[Unity.StandIns.StandInExtension]
public static class AnsweredDialogs
{
    /// <summary>Answers to the dialogs that ask for files, in their order.</summary>
    public static Queue<string> Answers { get; } = [];

    /// <summary>Texts of the dialogs so far.</summary>
    public static List<string> Texts { get; } = [];

    /// <summary>Forgets all.</summary>
    public static void Clear()
    {
        Answers.Clear();
        Texts.Clear();
    }

    internal static string Ask(string text)
    {
        Texts.Add(text);
        return Answers.TryDequeue(out string answer) ? answer : throw new InvalidOperationException($"The test has no answer to '{text}'.");
    }

    internal static bool Tell(string text)
    {
        Texts.Add(text);
        return true;
    }
}
