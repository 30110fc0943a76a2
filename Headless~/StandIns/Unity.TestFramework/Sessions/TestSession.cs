using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using UnityEngine;
using UnityEngine.TestTools;

namespace Unity.StandIns;

/// <summary>The running test: its mode, its log and what surrounds it.</summary>
[StandInExtension]
public static class TestSession
{
    private const float k_UsualFrame = 1f / 60f;

    /// <summary>The log of the running test; null between tests.</summary>
    internal static TestLog Logs { get; private set; }

    /// <summary>Seconds of a frame that a test waits for: Time.captureDeltaTime, or 1/60 s.</summary>
    internal static float FrameTime => Time.captureDeltaTime > 0f ? Time.captureDeltaTime : k_UsualFrame;

    internal static void Begin(ITest test, bool plays)
    {
        Logs = new TestLog { MustExpectAll = MustExpectAll(test) };
        Logs.Begin();
        SetMode(plays);
        foreach (MethodInfo method in Methods<UnitySetUpAttribute>(test).Reverse())
            RoutineRunner.Run((IEnumerator)method.Invoke(test.Fixture, null));
    }

    internal static void End(ITest test)
    {
        try
        {
            foreach (MethodInfo method in Methods<UnityTearDownAttribute>(test))
                RoutineRunner.Run((IEnumerator)method.Invoke(test.Fixture, null));
            if (PlayerLoop.IsPlaying)
                PlayerLoop.Tick(FrameTime);
            if (TestContext.CurrentContext.Result.Outcome.Status == TestStatus.Failed)
                return;
            Logs.CheckFailures();
            Logs.CheckExpected();
        }
        finally
        {
            Logs.End();
            Logs = null;
        }
    }

    /// <summary>
    /// Enters or leaves play mode if the next test needs it; that goes with an empty scene. In play mode a frame passes before the next
    /// test: what a class's OneTimeTearDown destroyed has gone by then.
    /// </summary>
    private static void SetMode(bool plays)
    {
        if (PlayerLoop.IsPlaying)
            PlayerLoop.Tick(FrameTime);
        if (plays == PlayerLoop.IsPlaying)
            return;
        if (plays)
            PlayerLoop.EnterPlayMode();
        else
            PlayerLoop.ExitPlayMode();
    }

    private static bool MustExpectAll(ITest test)
    {
        Type type = test.TypeInfo?.Type;
        TestMustExpectAllLogsAttribute attribute = test.Method?.MethodInfo.GetCustomAttribute<TestMustExpectAllLogsAttribute>()
            ?? type?.GetCustomAttribute<TestMustExpectAllLogsAttribute>()
            ?? type?.Assembly.GetCustomAttribute<TestMustExpectAllLogsAttribute>();
        return attribute is { MustExpect: true };
    }

    /// <summary>The methods of a fixture with an attribute, those of derived classes first.</summary>
    private static IEnumerable<MethodInfo> Methods<T>(ITest test) where T : Attribute
    {
        const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        for (Type type = test.Fixture?.GetType(); type != null && type != typeof(object); type = type.BaseType)
        {
            foreach (MethodInfo method in type.GetMethods(own))
            {
                if (method.IsDefined(typeof(T), false))
                    yield return method;
            }
        }
    }
}
