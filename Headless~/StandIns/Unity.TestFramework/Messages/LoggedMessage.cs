using UnityEngine;

namespace Unity.StandIns;

internal readonly record struct LoggedMessage(LogType Type, string Text, string StackTrace)
{
    public bool IsFailure => Type is LogType.Error or LogType.Assert or LogType.Exception;

    public override string ToString() => $"[{Type}] {Text}";
}
