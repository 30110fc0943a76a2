using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

public sealed class LifecycleTests : FreshSceneFixture
{
    [SetUp]
    public void OpenDiary() => Diary.Lines.Clear();

    [Test]
    public void AnActiveComponent_AwakesAndIsEnabledAtOnce_AndStartsInTheNextFrame()
    {
        new GameObject("a").AddComponent<Diary>();
        Assert.That(Diary.Lines, Is.EqualTo(new[] { "a.Awake", "a.OnEnable" }));
        Diary.Lines.Clear();

        PlayerLoop.Tick(0.02f);

        Assert.That(Diary.Lines, Is.EqualTo(new[] { "a.Start", "a.FixedUpdate", "a.Update", "a.LateUpdate" }));
    }

    [Test]
    public void AnInactiveObject_DoesNotAwake_UntilItIsActivated()
    {
        var parent = new GameObject("parent");
        parent.SetActive(false);
        var child = new GameObject("child");
        child.transform.SetParent(parent.transform);
        child.AddComponent<Diary>();
        PlayerLoop.Tick(0.01f);
        Assert.That(Diary.Lines, Is.Empty);

        parent.SetActive(true);

        Assert.That(Diary.Lines, Is.EqualTo(new[] { "child.Awake", "child.OnEnable" }));
    }

    [Test]
    public void ExecutionOrder_ComesBeforeTheOrderOfMaking()
    {
        new GameObject("late").AddComponent<Diary>();
        new GameObject("early").AddComponent<EarlyDiary>();
        Diary.Lines.Clear();

        PlayerLoop.Tick(0f);

        Assert.That(Diary.Lines, Is.EqualTo(new[]
        {
            "early.Start", "late.Start", "early.Update", "late.Update", "early.LateUpdate", "late.LateUpdate",
        }));
    }

    [Test]
    public void Destroy_WaitsForTheEndOfTheFrame_AndDisablesFirst()
    {
        var doomed = new GameObject("a");
        Diary diary = doomed.AddComponent<Diary>();
        Object.Destroy(doomed);
        Assert.That(doomed == null, Is.False);
        Diary.Lines.Clear();

        PlayerLoop.Tick(0f);

        Assert.That(Diary.Lines, Is.EqualTo(new[] { "a.Start", "a.Update", "a.LateUpdate", "a.OnDisable", "a.OnDestroy" }));
        Assert.That(doomed == null && diary == null, Is.True);
        Assert.That(() => diary.transform, Throws.TypeOf<MissingReferenceException>());
    }

    [Test]
    public void DestroyImmediate_OfAParent_EndsItsChildren()
    {
        var parent = new GameObject("parent");
        Diary child = new GameObject("child").AddComponent<Diary>();
        child.transform.SetParent(parent.transform);
        Diary.Lines.Clear();

        Object.DestroyImmediate(parent);

        Assert.That(child == null, Is.True);
        Assert.That(Diary.Lines, Is.EqualTo(new[] { "child.OnDisable", "child.OnDestroy" }));
    }

    [Test]
    public void WhoNeverAwoke_HearsNoOnDestroy()
    {
        var sleeper = new GameObject("a");
        sleeper.SetActive(false);
        sleeper.AddComponent<Diary>();

        Object.DestroyImmediate(sleeper);

        Assert.That(Diary.Lines, Is.Empty);
    }

    [Test]
    public void FixedSteps_FollowScaledTime_NotFrames()
    {
        new GameObject("a").AddComponent<Diary>();
        Time.timeScale = 0.5f;
        for (int i = 0; i < 10; i++)
            PlayerLoop.Tick(0.1f);

        Assert.That(Diary.Lines.FindAll(l => l == "a.FixedUpdate"), Has.Count.EqualTo(25));
        Assert.That(Diary.Lines.FindAll(l => l == "a.Update"), Has.Count.EqualTo(10));
        Assert.That(Time.time, Is.EqualTo(0.5f).Within(1e-6f));
    }

    [Test]
    public void ALongFrame_IsCutToTheMaximum()
    {
        PlayerLoop.Tick(5f);

        Assert.That(Time.deltaTime, Is.EqualTo(1f / 3f));
        Assert.That(Time.unscaledDeltaTime, Is.EqualTo(5f));
    }

    [Test]
    public void WithTimeScaleZero_FramesGoOn_AndTimeStands()
    {
        new GameObject("a").AddComponent<Diary>();
        Time.timeScale = 0f;
        PlayerLoop.Tick(0.1f);

        Assert.That(Diary.Lines, Has.None.EqualTo("a.FixedUpdate").And.Some.EqualTo("a.Update"));
        Assert.That(Time.time, Is.Zero);
    }

    [Test]
    public void ExitingPlayMode_EndsEverythingButWhatIsMarkedDontSave()
    {
        Diary ordinary = new GameObject("ordinary").AddComponent<Diary>();
        Diary lasting = new GameObject("lasting").AddComponent<Diary>();
        Object.DontDestroyOnLoad(lasting.gameObject);
        var hidden = new GameObject("hidden") { hideFlags = HideFlags.HideAndDontSave };

        PlayerLoop.ExitPlayMode();

        Assert.That(ordinary == null && lasting == null, Is.True);
        Assert.That(hidden == null, Is.False);
        Object.DestroyImmediate(hidden);
    }

    [Test]
    public void OneWhoThrows_IsLogged_AndTheOthersGoOn()
    {
        new GameObject("bad").AddComponent<Thrower>();
        new GameObject("good").AddComponent<Diary>();
        LogAssert.Expect(LogType.Exception, "InvalidOperationException: no");

        PlayerLoop.Tick(0f);

        Assert.That(Diary.Lines, Has.Some.EqualTo("good.Update"));
    }

    [Test]
    public void AFrame_AllocatesNothing()
    {
        new GameObject("quiet").AddComponent<Counter>();
        for (int i = 0; i < 4; i++)
            PlayerLoop.Tick(0.02f);

        long before = System.GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
            PlayerLoop.Tick(0.02f);

        Assert.That(System.GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    [Test]
    public void AChildThatEndsItsParentWhileItEnds_EndsOnce()
    {
        var parent = new GameObject("parent");
        var child = new GameObject("child", typeof(Avenger), typeof(Diary));
        child.transform.SetParent(parent.transform);
        Diary.Lines.Clear();

        Object.DestroyImmediate(child);

        Assert.That(parent == null && child == null, Is.True);
        Assert.That(Diary.Lines, Is.EqualTo(new[] { "child.OnDisable", "child.OnDestroy" }));
    }

    [Test]
    public void AComponentThatEndsItsObjectWhileItEnds_LetsAllHear()
    {
        var owner = new GameObject("owner", typeof(Diary), typeof(SelfEnder));
        Diary.Lines.Clear();

        Object.DestroyImmediate(owner.GetComponent<SelfEnder>());

        Assert.That(owner == null, Is.True);
        Assert.That(Diary.Lines, Is.EqualTo(new[] { "owner.OnDisable", "owner.OnDestroy", "owner.OnDisable", "owner.OnDestroy" }));
    }

    [Test]
    public void WhoIsWokenWhileFallingAsleep_StaysAwake()
    {
        var parent = new GameObject("parent");
        var insomniac = new GameObject("insomniac", typeof(Insomniac), typeof(Diary));
        insomniac.transform.SetParent(parent.transform);
        Diary.Lines.Clear();

        parent.SetActive(false);

        Assert.That(insomniac.GetComponent<Diary>().isActiveAndEnabled, Is.True);
        PlayerLoop.Tick(0f);
        Assert.That(Diary.Lines, Has.Some.EqualTo("insomniac.Update").And.None.EqualTo("insomniac.OnDisable"));
    }

    private sealed class Avenger : MonoBehaviour
    {
        private void OnDisable() => DestroyImmediate(transform.parent.gameObject);
    }

    private sealed class SelfEnder : Diary
    {
        protected override void Disabled() => DestroyImmediate(gameObject);
    }

    private sealed class Insomniac : MonoBehaviour
    {
        private void OnDisable()
        {
            if (transform.parent != null)
                transform.SetParent(null);
        }
    }

    private sealed class Thrower : MonoBehaviour
    {
        private void Update() => throw new System.InvalidOperationException("no");
    }

    private sealed class Counter : MonoBehaviour
    {
        private int m_Count;

        private void FixedUpdate() => m_Count++;

        private void Update() => m_Count++;
    }
}
