using System;
using System.Collections;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>The routines of one behaviour; they go on while its object is active, also if it is disabled itself.</summary>
internal sealed class CoroutineSet(MonoBehaviour owner)
{
    private static readonly List<CoroutineSet> s_Running = [];
    private static readonly List<CoroutineSet> s_Round = [];

    private readonly List<Coroutine> _routines = [];

    public Coroutine Start(IEnumerator routine)
    {
        var started = new Coroutine(routine);
        try
        {
            started.Step();
        }
        catch (Exception e)
        {
            started.Abandon();
            Debug.LogException(e, owner);
        }

        if (started.Done)
            return started;
        _routines.Add(started);
        if (!s_Running.Contains(this))
            s_Running.Add(this);
        return started;
    }

    public void Stop(Predicate<Coroutine> chosen)
    {
        foreach (Coroutine routine in _routines)
        {
            if (chosen(routine))
                routine.Abandon();
        }
    }

    public static void ResumeAll(FramePoint point)
    {
        s_Round.Clear();
        s_Round.AddRange(s_Running);
        foreach (CoroutineSet set in s_Round)
            set.Resume(point);
        s_Running.RemoveAll(s => s._routines.Count == 0);
    }

    private void Resume(FramePoint point)
    {
        int count = _routines.Count;
        for (int i = 0; i < count; i++)
            _routines[i].Resume(point, owner);
        _routines.RemoveAll(r => r.Done);
    }
}
