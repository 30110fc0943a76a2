using System;
using System.Collections;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Unity.Tests.Engine;

public sealed class RoutineTests
{
    private int m_FrameAfterSetUp = -1;

    [UnitySetUp]
    public IEnumerator WaitAFrame()
    {
        yield return null;
        m_FrameAfterSetUp = Time.frameCount;
    }

    [TearDown]
    public void RestoreTime()
    {
        Time.timeScale = 1f;
        Time.captureDeltaTime = 0f;
    }

    [UnityTest]
    public IEnumerator EachYield_IsAFrame()
    {
        Assert.That(Application.isPlaying, Is.True);
        Assert.That(m_FrameAfterSetUp, Is.EqualTo(Time.frameCount).And.Positive);
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
    public void WhatARoutineThrows_ComesOut() => Assert.That(() => RoutineRunner.Run(Failing()), Throws.TypeOf<InvalidCastException>());

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
