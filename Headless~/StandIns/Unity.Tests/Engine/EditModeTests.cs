using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Unity.Tests.EditMode;

public sealed class EditModeTests
{
    private sealed class Silent : MonoBehaviour
    {
        public int Heard { get; private set; }

        private void Awake() => Heard++;

        private void Update() => Heard++;
    }

    [ExecuteAlways]
    private sealed class Awake : MonoBehaviour
    {
        public int Enabled { get; private set; }

        private void OnEnable() => Enabled++;
    }

    [Test]
    public void OutsidePlayMode_OnlyScriptsThatAlwaysExecuteHearMessages()
    {
        var made = new GameObject("a");
        Assert.That(Application.isPlaying, Is.False);
        Assert.That(made.AddComponent<Silent>().Heard, Is.Zero);
        Assert.That(made.AddComponent<Awake>().Enabled, Is.EqualTo(1));
        Object.DestroyImmediate(made);
    }

    [Test]
    public void Destroy_IsForPlayMode()
    {
        var made = new GameObject("a");
        LogAssert.Expect(LogType.Error, "Destroy may not be called from edit mode! Use DestroyImmediate instead.");
        Object.Destroy(made);
        Object.DestroyImmediate(made);
    }

    [UnityTest]
    public IEnumerator ATest_EntersAndLeavesPlayMode()
    {
        yield return new EnterPlayMode();
        Assert.That(Application.isPlaying, Is.True);
        Silent played = new GameObject("a").AddComponent<Silent>();
        yield return null;
        Assert.That(played.Heard, Is.EqualTo(2));
        yield return new ExitPlayMode();
        Assert.That(Application.isPlaying, Is.False);
        Assert.That(played == null, Is.True);
    }
}
