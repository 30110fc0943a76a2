using System.Text.RegularExpressions;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>A message that a test waits for: its kind, or any, and its text or a pattern.</summary>
internal readonly record struct ExpectedMessage(LogType? Type, string Text, Regex Pattern)
{
    public bool Matches(in LoggedMessage message) =>
        (Type == null || Type == message.Type) && (Pattern?.IsMatch(message.Text) ?? Text == message.Text);

    public override string ToString() => $"[{Type?.ToString() ?? "any"}] {(Pattern == null ? Text : $"Regex: {Pattern}")}";
}
