using System;
using System.Collections;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>A routine and those that it waits for, innermost last.</summary>
public sealed class Coroutine : YieldInstruction
{
    private readonly Stack<IEnumerator> _frames = new();
    private object _waitsFor;
    private double _until;

    internal Coroutine(IEnumerator routine)
    {
        Routine = routine;
        _frames.Push(routine);
    }

    internal IEnumerator Routine { get; }

    internal bool Done { get; private set; }

    internal void Abandon() => Done = true;

    /// <summary>Goes on to the next yield if what it waits for is over at this point of the frame.</summary>
    internal void Resume(FramePoint point, Object owner)
    {
        if (Done || !MayResume(point))
            return;
        try
        {
            Step();
        }
        catch (Exception e)
        {
            Done = true;
            Debug.LogException(e, owner);
        }
    }

    internal void Step()
    {
        while (_frames.Count > 0)
        {
            if (!_frames.Peek().MoveNext())
            {
                _frames.Pop();
                continue;
            }

            // A custom instruction is asked again each frame; another routine runs at once.
            object yielded = _frames.Peek().Current;
            if (_frames.Peek() is CustomYieldInstruction || yielded is not IEnumerator inner)
            {
                _waitsFor = yielded;
                _until = yielded is WaitForSeconds wait ? Time.timeAsDouble + wait.Seconds : 0.0;
                return;
            }

            _frames.Push(inner);
        }

        Done = true;
    }

    private bool MayResume(FramePoint point) => _waitsFor switch
    {
        WaitForFixedUpdate => point == FramePoint.FixedUpdate,
        WaitForEndOfFrame => point == FramePoint.EndOfFrame,
        _ when point != FramePoint.Update => false,
        WaitForSeconds => Time.timeAsDouble >= _until,
        Coroutine other => other.Done,
        _ => true,
    };
}

/// <summary>Points of a frame at which routines continue.</summary>
internal enum FramePoint
{
    FixedUpdate,
    Update,
    EndOfFrame,
}
