using System.Collections.Generic;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Unity.Tests.Engine;

public sealed class PlayModeTests : FreshSceneFixture
{
    private static readonly List<string> s_Loads = new();

    [Test]
    public void PlayingTwice_RunsTheLoadMethodsTwice_InTheirOrder()
    {
        string[] once = { "subsystems", "before", "after" };
        PlayerLoop.ExitPlayMode();
        s_Loads.Clear();

        PlayerLoop.EnterPlayMode();
        Assert.That(s_Loads, Is.EqualTo(once));
        PlayerLoop.ExitPlayMode();
        PlayerLoop.EnterPlayMode();

        Assert.That(s_Loads, Is.EqualTo(new[] { once[0], once[1], once[2], once[0], once[1], once[2] }));
    }

    [Test]
    public void PlayingAgain_BeginsAtTimeZero_WithNothingOfTheTimeBefore()
    {
        var left = new GameObject("left");
        Object.DontDestroyOnLoad(new GameObject("lasting"));
        PlayerLoop.Tick(1f);
        Time.timeScale = 3f;

        PlayerLoop.ExitPlayMode();
        PlayerLoop.EnterPlayMode();

        Assert.That(left == null, Is.True);
        Assert.That(Object.FindObjectsByType<GameObject>(FindObjectsSortMode.None), Is.Empty);
        Assert.That((Time.time, Time.timeScale, Time.frameCount), Is.EqualTo((0f, 1f, 0)));
    }

    [Test]
    public void WhatLasts_SurvivesItsScene()
    {
        Scene scene = SceneManager.CreateScene("second");
        var going = new GameObject("going");
        var lasting = new GameObject("lasting");
        SceneManager.MoveGameObjectToScene(going, scene);
        SceneManager.MoveGameObjectToScene(lasting, scene);
        Object.DontDestroyOnLoad(lasting);

        SceneManager.UnloadSceneAsync(scene);
        PlayerLoop.Tick(0.01f);

        Assert.That(going == null, Is.True);
        Assert.That(lasting == null, Is.False);
    }

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.AfterSceneLoad)]
    private static void After() => s_Loads.Add("after");

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
    private static void Before() => s_Loads.Add("before");

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
    private static void Subsystems() => s_Loads.Add("subsystems");
}
