using System;
using System.Collections;
using System.Diagnostics;
using StandIns;
using UnityEngine.TestTools;

namespace Unity.StandIns;

/// <summary>Runs the routine of a test: in play mode as a coroutine of a lasting object, in edit mode step by step.</summary>
internal static class RoutineRunner
{
    private static readonly TimeSpan s_Patience = TimeSpan.FromMinutes(3);

    public static void Run(IEnumerator routine)
    {
        if (TestSession.Logs == null)
            throw new InvalidOperationException($"The test assembly lacks [assembly: {nameof(PlayerTestsAttribute)}].");
        if (PlayerLoop.IsPlaying)
            Play(routine);
        else
            Edit(routine);
    }

    private static void Play(IEnumerator routine)
    {
        var guarded = new GuardedRoutine(routine);
        var host = RoutineHost.Create();
        var watch = Stopwatch.StartNew();
        try
        {
            host.StartCoroutine(guarded);
            while (!guarded.Done)
            {
                Tick(watch);
                if (host == null)
                    throw new InvalidOperationException("Play mode ended under a test that runs in play mode.");
            }
        }
        finally
        {
            host.End();
        }

        guarded.Rethrow();
    }

    private static void Edit(IEnumerator routine)
    {
        var watch = Stopwatch.StartNew();
        while (routine.MoveNext())
        {
            switch (routine.Current)
            {
                case null when PlayerLoop.IsPlaying:
                    Tick(watch);
                    break;
                case null:
                    TestSession.Logs.CheckFailures();
                    break;
                case IEditModeTestYieldInstruction instruction:
                    Edit(instruction.Perform());
                    break;
                default:
                    throw new NotSupportedException(
                        $"In edit mode a test may yield null and edit-mode instructions, not {routine.Current.GetType().Name}.");
            }
        }
    }

    private static void Tick(Stopwatch watch)
    {
        PlayerLoop.Tick(TestSession.FrameTime);
        TestSession.Logs.CheckFailures();
        if (watch.Elapsed > s_Patience)
            throw new TimeoutException($"The test did not end within {s_Patience.TotalMinutes} minutes.");
    }
}
