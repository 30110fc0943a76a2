using System;
using System.Collections;
using System.Runtime.ExceptionServices;
using Unity.StandIns;

namespace UnityEngine;

/// <summary>A routine that is driven from outside the scene, as a test is; what it throws comes out of Run.</summary>
internal sealed class Guest
{
    private readonly Coroutine _routine;
    private ExceptionDispatchInfo _error;

    private Guest(IEnumerator routine) => _routine = new Coroutine(routine);

    public static Guest Current { get; private set; }

    /// <summary>
    /// Runs a routine to its end, frame by frame. What outside does with a yielded object happens between two frames;
    /// it says whether the object was for it.
    /// </summary>
    public static void Run(IEnumerator routine, Func<object, bool> outside)
    {
        if (Current != null)
            throw new InvalidOperationException("Another routine is being driven.");
        var guest = new Guest(routine);
        Current = guest;
        try
        {
            guest.Step();
            while (!guest._routine.Done)
            {
                if (outside(guest._routine.WaitsFor))
                    guest.Step();
                else
                    PlayerLoop.Tick();
                guest._error?.Throw();
            }
        }
        finally
        {
            Current = null;
        }

        guest._error?.Throw();
    }

    public void Resume(FramePoint point)
    {
        if (!_routine.Done && _routine.MayResume(point))
            Step();
    }

    private void Step()
    {
        try
        {
            _routine.Step();
        }
        catch (Exception e)
        {
            _routine.Abandon();
            _error = ExceptionDispatchInfo.Capture(e);
        }
    }
}
