using System.Collections;
using Alate.Showcase;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.PlaySessions;

/// <summary>Statics that outlive a play without a reload of the domain: the next play begins as the first did.</summary>
public sealed class PlayStaticsTests
{
    [TearDown]
    public void Leave()
    {
        if (PlayerLoop.IsPlaying)
            PlayerLoop.ExitPlayMode();
        Input.HoldMouse(0, false);
    }

    [UnityTest]
    public IEnumerator WhoListenedToTheEndOfAPlay_IsNotToldOfTheNext()
    {
        int told = 0;
        for (int session = 0; session < 3; session++)
        {
            yield return new EnterPlayMode(false);
            if (session == 0)
                PlayEnd.Ended += () => told++;
            yield return new ExitPlayMode();
            Assert.That(told, Is.EqualTo(1), $"session {session}");
        }
    }

    [UnityTest]
    public IEnumerator ThePatienceOfAPlay_IsTenSeconds_AndItsBudgetNone_WhateverTheyWereInTheLast()
    {
        for (int session = 0; session < 2; session++)
        {
            yield return new EnterPlayMode(false);
            Assert.That((WingSystem.Patience, WingSystem.Budget), Is.EqualTo((10f, 0f)));
            (WingSystem.Patience, WingSystem.Budget) = (3f, 2f);
            yield return new ExitPlayMode();
        }
    }

    // Frames are counted anew: a later one has the number of an earlier one.
    [UnityTest]
    public IEnumerator ThePointer_IsReadAnew_InTheSameFrameOfTheNextPlay()
    {
        for (int session = 0; session < 2; session++)
        {
            yield return new EnterPlayMode(false);
            while (Time.frameCount < 4)
                yield return null;
            Input.MoveMouse(new Vector2(100f + session, 50f));
            Assert.That(PointerReader.Now.position.x, Is.EqualTo(100f + session), $"session {session}");
            yield return new ExitPlayMode();
        }
    }

    [UnityTest]
    public IEnumerator APanelOfTheLastPlay_CoversNothing_AndHoldsNothing()
    {
        var place = new Vector2(50f, 30f);
        yield return new EnterPlayMode(false);
        SlidingPanel first = new GameObject("first").AddComponent<SlidingPanel>();
        for (int frame = 0; frame < 20; frame++)
            yield return null;
        Assert.That(ScreenPanel.Covers(place));
        first.enabled = false;
        yield return new ExitPlayMode();
        Assert.That(first == null, "its scene has ended");

        yield return new EnterPlayMode(false);
        yield return null;
        Assert.That(ScreenPanel.Covers(place), Is.False, "it is drawn no more");
        yield return new ExitPlayMode();
    }

    private sealed class SlidingPanel : MonoBehaviour
    {
        private readonly ScreenPanel m_Panel = new(200f);

        private float m_Value;

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            m_Value = m_Panel.Slider("value", m_Value, 0f, 1f);
            m_Panel.End();
        }
    }
}
