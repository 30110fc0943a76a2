using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.StandIns;

/// <summary>One line of the log.</summary>
[StandInExtension]
public readonly record struct LogRecord(LogType Type, string Message, string StackTrace, Object Context, Exception Exception)
{
    /// <summary>Whether such a line fails a test that does not expect it.</summary>
    public bool IsFailure => Type is LogType.Error or LogType.Assert or LogType.Exception;
}
