using System;
using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Unity.Tests;

public sealed class TestFrameworkTests
{
    private int m_FrameAfterSetUp = -1;

    [UnitySetUp]
    public IEnumerator WaitAFrame()
    {
        yield return null;
        m_FrameAfterSetUp = Time.frameCount;
    }

    [UnityTest]
    public IEnumerator EachYield_IsAFrame()
    {
        Assert.That(Application.isPlaying, Is.True);
        Assert.That(m_FrameAfterSetUp, Is.EqualTo(1));
        int before = Time.frameCount;
        yield return null;
        yield return null;
        Assert.That(Time.frameCount, Is.EqualTo(before + 2));
    }

    [UnityTest]
    public IEnumerator ARoutineInARoutine_IsRunToItsEnd()
    {
        int before = Time.frameCount;
        yield return Frames(3);
        Assert.That(Time.frameCount, Is.EqualTo(before + 3));
    }

    [UnityTest]
    public IEnumerator Waiting_FollowsScaledTime([Values(0.5f, 2f)] float scale)
    {
        Time.timeScale = scale;
        Time.captureDeltaTime = 0.01f;
        float before = Time.time;
        yield return new WaitForSeconds(1f);
        Assert.That(Time.time - before, Is.EqualTo(1f).Within(0.01f * scale + 1e-5f));
    }

    [UnityTest]
    public IEnumerator WaitingForAFixedStep_EndsInsideOne()
    {
        yield return new WaitForFixedUpdate();
        Assert.That(Time.inFixedTimeStep, Is.True);
        yield return new WaitForEndOfFrame();
        Assert.That(Time.inFixedTimeStep, Is.False);
    }

    [Test]
    public void WhatARoutineThrows_ComesOut() => Assert.That(() => TestRun.Drive(Failing()), Throws.TypeOf<InvalidCastException>());

    [Test]
    public void AnUnexpectedError_FailsTheTest() =>
        Assert.That(Verdict(() => Debug.LogError("oh")), Throws.TypeOf<AssertionException>().With.Message.Contain("oh"));

    [Test]
    public void AnUnexpectedException_FailsTheTest() =>
        Assert.That(Verdict(() => Debug.LogException(new Exception("oh"))), Throws.TypeOf<AssertionException>());

    [Test]
    public void AWarning_FailsNoTest() => Assert.That(Verdict(() => Debug.LogWarning("oh")), Throws.Nothing);

    [Test]
    public void AnExpectedError_FailsNoTest() => Assert.That(
        Verdict(() =>
        {
            LogAssert.Expect(LogType.Error, "oh");
            LogAssert.Expect(LogType.Warning, new Regex("^a.c$"));
            Debug.LogError("oh");
            Debug.LogWarning("abc");
        }), Throws.Nothing);

    [Test]
    public void AnExpectedMessageThatDoesNotCome_FailsTheTest() =>
        Assert.That(Verdict(() => LogAssert.Expect(LogType.Log, "oh")), Throws.TypeOf<AssertionException>());

    [Test]
    public void NoUnexpectedReceived_FailsForPlainMessagesToo() => Assert.That(
        Verdict(() =>
        {
            Debug.Log("oh");
            LogAssert.NoUnexpectedReceived();
        }), Throws.TypeOf<AssertionException>());

    [Test]
    public void IgnoredErrors_FailNoTest() => Assert.That(
        Verdict(() =>
        {
            LogAssert.ignoreFailingMessages = true;
            Debug.LogError("oh");
        }), Throws.Nothing);

    private static TestDelegate Verdict(Action test) => () =>
    {
        LogScope.Begin();
        try
        {
            test();
        }
        finally
        {
            LogScope scope = LogScope.End();
            scope.Judge();
        }
    };

    private static IEnumerator Failing()
    {
        yield return null;
        throw new InvalidCastException();
    }

    private static IEnumerator Frames(int count)
    {
        for (int i = 0; i < count; i++)
            yield return null;
    }
}
