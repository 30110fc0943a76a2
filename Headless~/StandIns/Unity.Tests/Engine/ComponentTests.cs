using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

public sealed class ComponentTests : FreshSceneFixture
{
    [Test]
    public void ARequiredComponent_IsAddedToo_AndCannotBeTakenAway()
    {
        Needy needy = new GameObject("a").AddComponent<Needy>();
        Assert.That(needy.TryGetComponent(out Rigidbody body), Is.True);

        LogAssert.Expect(LogType.Error, new Regex("depends on it"));
        Object.DestroyImmediate(body);
        Assert.That(body == null, Is.False);
    }

    [Test]
    public void ASingleComponent_IsNotAddedTwice()
    {
        var owner = new GameObject("a", typeof(Single));
        LogAssert.Expect(LogType.Error, new Regex("already added"));
        Assert.That(owner.AddComponent<Single>() == null, Is.True);
    }

    [Test]
    public void Components_AreFoundByInterface_InChildrenAndParents()
    {
        var root = new GameObject("root", typeof(Single));
        var child = new GameObject("child", typeof(Single));
        child.transform.SetParent(root.transform);
        var found = new List<INamed>();

        root.GetComponentsInChildren(found);
        Assert.That(found, Has.Count.EqualTo(2));
        Assert.That(child.GetComponentsInParent<Single>(), Has.Length.EqualTo(2));
        Assert.That(child.transform.root.GetComponentInChildren<INamed>(), Is.SameAs(root.GetComponent<Single>()));

        child.SetActive(false);
        Assert.That(root.GetComponentsInChildren<INamed>(), Has.Length.EqualTo(1));
        Assert.That(root.GetComponentsInChildren<INamed>(true), Has.Length.EqualTo(2));
    }

    [Test]
    public void ADestroyedComponent_IsNoLongerFound_AndEqualsNull()
    {
        var owner = new GameObject("a", typeof(Single));
        Single single = owner.GetComponent<Single>();
        Object.DestroyImmediate(single);

        Assert.That(owner.GetComponent<Single>(), Is.Null);
        Assert.That(single == null && !single && single.Equals(null), Is.True);
        Assert.That(() => single.name, Throws.TypeOf<MissingReferenceException>());
    }

    [Test]
    public void ACoroutine_WaitsAsItSays_AndEndsWithItsObject()
    {
        Single host = new GameObject("a").AddComponent<Single>();
        var lines = new List<string>();
        host.StartCoroutine(Steps(lines));
        Assert.That(lines, Is.EqualTo(new[] { "at once" }));

        PlayerLoop.Tick(0.1f);
        PlayerLoop.Tick(0.1f);
        Assert.That(lines, Is.EqualTo(new[] { "at once", "next frame" }));
        for (int i = 0; i < 7; i++)
            PlayerLoop.Tick(0.1f);
        Assert.That(lines, Has.Count.EqualTo(3));

        host.gameObject.SetActive(false);
        host.gameObject.SetActive(true);
        PlayerLoop.Tick(0.1f);
        Assert.That(lines, Has.Count.EqualTo(3));
    }

    [Test]
    public void ABodyInFreeFall_ObeysNewton()
    {
        Rigidbody body = new GameObject("a").AddComponent<Rigidbody>();
        for (int i = 0; i < 50; i++)
            PlayerLoop.Tick(0.02f);

        Assert.That(body.GetPointVelocity(body.worldCenterOfMass).y, Is.EqualTo(-9.81f).Within(1e-3f));
        Assert.That(body.position.y, Is.EqualTo(-9.81f / 2f).Within(0.11f));
    }

    [Test]
    public void AScenesObjects_EndWithIt_AndOthersStay()
    {
        var stays = new GameObject("stays");
        Scene scene = UnityEngine.SceneManagement.SceneManager.CreateScene("other");
        var moves = new GameObject("moves", typeof(Diary));
        UnityEngine.SceneManagement.SceneManager.MoveGameObjectToScene(moves, scene);
        Diary.Lines.Clear();

        UnityEngine.SceneManagement.SceneManager.UnloadSceneAsync(scene);

        Assert.That(moves == null, Is.True);
        Assert.That(stays == null, Is.False);
        Assert.That(scene.IsValid(), Is.False);
        Assert.That(Diary.Lines, Is.EqualTo(new[] { "moves.OnDisable", "moves.OnDestroy" }));
    }

    [Test]
    public void InEditMode_OnlyThoseThatAskHearMessages_AndAddingSendsReset()
    {
        PlayerLoop.ExitPlayMode();
        Diary.Lines.Clear();
        var quiet = new GameObject("quiet", typeof(Diary));
        Always always = new GameObject("always").AddComponent<Always>();
        PlayerLoop.Tick(0.1f);

        Assert.That(Diary.Lines, Is.Empty);
        Assert.That(always.heard, Is.EqualTo(new[] { "OnEnable", "Reset", "OnValidate", "Update" }));
        LogAssert.Expect(LogType.Error, new Regex("DestroyImmediate"));
        Object.Destroy(quiet);
        Object.DestroyImmediate(quiet);
        Object.DestroyImmediate(always.gameObject);
    }

    [Test]
    public void WhatIsNotToBeSaved_IsNotFoundByType()
    {
        var hidden = new GameObject("hidden", typeof(Single)) { hideFlags = HideFlags.HideAndDontSave };
        Assert.That(Object.FindObjectsByType<Single>(FindObjectsSortMode.None), Is.Empty);
        Assert.That(Resources.FindObjectsOfTypeAll<Single>(), Has.Length.EqualTo(1));
        Object.DestroyImmediate(hidden);
        Assert.That(Resources.FindObjectsOfTypeAll<Single>(), Is.Empty);
    }

    [Test]
    public void WhatOutlivesPlay_DoesNotAwakeAgain()
    {
        Diary.Lines.Clear();
        var lasting = new GameObject("lasting", typeof(Diary)) { hideFlags = HideFlags.HideAndDontSave };
        PlayerLoop.ExitPlayMode();
        PlayerLoop.EnterPlayMode();
        PlayerLoop.Tick(0f);

        Assert.That(Diary.Lines, Is.EqualTo(new[]
        {
            "lasting.Awake", "lasting.OnEnable", "lasting.Start", "lasting.Update", "lasting.LateUpdate",
        }));
        Object.DestroyImmediate(lasting);
    }

    [Test]
    public void AKey_IsDownForOneFrame_AndHeldUntilReleased()
    {
        Input.Press(KeyCode.Space);
        PlayerLoop.Tick(0f);
        Assert.That((Input.GetKeyDown(KeyCode.Space), Input.GetKey(KeyCode.Space)), Is.EqualTo((true, true)));
        PlayerLoop.Tick(0f);
        Assert.That((Input.GetKeyDown(KeyCode.Space), Input.GetKey(KeyCode.Space)), Is.EqualTo((false, true)));
        Input.Release(KeyCode.Space);
        PlayerLoop.Tick(0f);
        Assert.That((Input.GetKeyUp(KeyCode.Space), Input.GetKey(KeyCode.Space)), Is.EqualTo((true, false)));
    }

    private static IEnumerator Steps(List<string> lines)
    {
        lines.Add("at once");
        yield return null;
        lines.Add("next frame");
        yield return new WaitForSeconds(0.75f);
        lines.Add("later");
        yield return new WaitForSeconds(0.05f);
        lines.Add("never");
    }

    private interface INamed
    {
    }

    [DisallowMultipleComponent]
    private sealed class Single : MonoBehaviour, INamed
    {
    }

    [RequireComponent(typeof(Rigidbody))]
    private sealed class Needy : MonoBehaviour
    {
    }

    [ExecuteAlways]
    private sealed class Always : MonoBehaviour
    {
        public List<string> heard = new();

        private void OnEnable() => heard.Add(nameof(OnEnable));

        private void Reset() => heard.Add(nameof(Reset));

        private void OnValidate() => heard.Add(nameof(OnValidate));

        private void Update() => heard.Add(nameof(Update));
    }
}
