using NUnit.Framework;
using Unity.StandIns;

namespace Unity.Tests.Engine;

/// <summary>Each test begins with an empty scene at time 0.</summary>
public abstract class FreshSceneFixture
{
    [SetUp]
    public void PlayAnew()
    {
        if (PlayerLoop.IsPlaying)
            PlayerLoop.ExitPlayMode();
        PlayerLoop.EnterPlayMode();
    }

    /// <summary>No time scale or object of this test meets the next.</summary>
    [TearDown]
    public void StopPlaying()
    {
        if (PlayerLoop.IsPlaying)
            PlayerLoop.ExitPlayMode();
    }
}
