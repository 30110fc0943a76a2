using System;
using System.Collections;
using System.Runtime.ExceptionServices;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>A routine that keeps what it, or a routine that it yields, throws.</summary>
internal sealed class GuardedRoutine(IEnumerator routine, GuardedRoutine outer = null) : IEnumerator
{
    private ExceptionDispatchInfo _thrown;

    public bool Done { get; private set; }

    public object Current { get; private set; }

    public bool MoveNext()
    {
        if (Done)
            return false;
        try
        {
            Done = !routine.MoveNext();
            Current = Done ? null : Guard(routine.Current);
        }
        catch (Exception e)
        {
            Fail(ExceptionDispatchInfo.Capture(e));
        }

        return !Done;
    }

    public void Reset() => throw new NotSupportedException();

    public void Rethrow() => _thrown?.Throw();

    private object Guard(object yielded) =>
        yielded is IEnumerator inner and not CustomYieldInstruction ? new GuardedRoutine(inner, this) : yielded;

    private void Fail(ExceptionDispatchInfo thrown)
    {
        Done = true;
        Current = null;
        _thrown = thrown;
        outer?.Fail(thrown);
    }
}
