using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using Unity.StandIns;

namespace UnityEngine.TestTools;

/// <summary>What Unity's runner does around each test: play mode for play-mode tests, routines, and a look at the log.</summary>
internal static class TestRun
{
    public static void Begin(bool playMode, object fixture)
    {
        LogScope.Begin();
        if (playMode)
            PlayerLoop.EnterPlayMode();
        RunAll<UnitySetUpAttribute>(fixture, baseFirst: true);
    }

    public static void End(object fixture)
    {
        try
        {
            RunAll<UnityTearDownAttribute>(fixture, baseFirst: false);
        }
        finally
        {
            if (PlayerLoop.IsPlaying)
                PlayerLoop.ExitPlayMode();
            LogScope.End().Judge();
        }
    }

    public static void Drive(IEnumerator routine)
    {
        if (routine == null)
            throw new InvalidOperationException("The test returned no routine.");
        Guest.Run(routine, PerformBetweenFrames);
    }

    private static bool PerformBetweenFrames(object yielded)
    {
        if (yielded is not IEditModeTestYieldInstruction instruction)
            return false;
        IEnumerator steps = instruction.Perform();
        while (steps.MoveNext())
            PlayerLoop.Tick();
        return true;
    }

    private static void RunAll<T>(object fixture, bool baseFirst) where T : Attribute
    {
        if (fixture == null)
            return;
        const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        var methods = new List<MethodInfo>();
        for (Type type = fixture.GetType(); type != null; type = type.BaseType)
            methods.AddRange(Array.FindAll(type.GetMethods(own), m => m.IsDefined(typeof(T))));
        if (baseFirst)
            methods.Reverse();
        foreach (MethodInfo method in methods)
            Drive((IEnumerator)method.Invoke(fixture, null));
    }
}
