using System.Collections.Generic;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.Tests;

/// <summary>Each test plays: it begins with an empty scene at time 0, and nothing that it makes is left.</summary>
public abstract class PlayModeFixture
{
    private readonly List<string> m_Problems = new();

    /// <summary>Warnings and worse that were logged.</summary>
    protected IReadOnlyList<string> Problems => m_Problems;

    [SetUp]
    public void Play()
    {
        m_Problems.Clear();
        LogChannel.Received += Hear;
        PlayerLoop.EnterPlayMode();
    }

    [TearDown]
    public void Stop()
    {
        if (PlayerLoop.IsPlaying)
            PlayerLoop.ExitPlayMode();
        LogChannel.Received -= Hear;
        foreach (GameObject left in Resources.FindObjectsOfTypeAll<GameObject>())
            Object.DestroyImmediate(left);
    }

    private void Hear(string text, string trace, LogType type, Object context)
    {
        if (type != LogType.Log)
            m_Problems.Add(text);
    }
}
