using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Unity.Tests.Engine;

public sealed class StrictnessTests
{
    private sealed class Asset : ScriptableObject
    {
    }

    private sealed class Script : MonoBehaviour
    {
    }

    private readonly List<string> m_Warnings = new();

    [SetUp]
    public void Listen()
    {
        m_Warnings.Clear();
        LogChannel.Received += Hear;
    }

    [TearDown]
    public void StopListening() => LogChannel.Received -= Hear;

    [Test]
    public void AnotherThread_MayNotTouchObjects()
    {
        var made = new GameObject("a");
        Assert.That(OnAnotherThread(() => made.name), Throws.TypeOf<UnityException>().With.Message.Contain("name"));
        Assert.That(OnAnotherThread(() => made.transform.position), Throws.TypeOf<UnityException>());
        Assert.That(OnAnotherThread(() => new GameObject("b")), Throws.TypeOf<UnityException>());
        Assert.That(OnAnotherThread(() => Time.deltaTime), Throws.TypeOf<UnityException>());
        Object.DestroyImmediate(made);
    }

    [Test]
    public void AnotherThread_MayCompareWithNullAndLog()
    {
        var made = new GameObject("a");
        Assert.That(OnAnotherThread(() => made == null), Throws.Nothing);
        Assert.That(OnAnotherThread(() => 2f * Vector3.one), Throws.Nothing);
        Object.DestroyImmediate(made);
    }

    [Test]
    public void ADestroyedObject_EqualsNull_AndRefusesToBeUsed()
    {
        var made = new GameObject("a");
        Transform transform = made.transform;
        Object.DestroyImmediate(made);
        Assert.That(made == null, Is.True);
        Assert.That((bool)transform, Is.False);
        Assert.That(() => made.name, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => transform.position, Throws.TypeOf<MissingReferenceException>());
        MeshRenderer renderer = new GameObject("b").AddComponent<MeshRenderer>();
        Object.DestroyImmediate(renderer.gameObject);
        Assert.That(
            () => renderer.motionVectorGenerationMode = MotionVectorGenerationMode.Camera, Throws.TypeOf<MissingReferenceException>());
    }

    [Test]
    public void AComponentMadeByNew_EqualsNull_AndIsToldInTheLog()
    {
        Assert.That(new Script() == null, Is.True);
        Assert.That(m_Warnings, Has.Count.EqualTo(1).And.Some.Contain("Script").And.Some.Contain("AddComponent"));
    }

    [Test]
    public void AnAssetMadeByNew_IsToldInTheLog()
    {
        Object.DestroyImmediate(new Asset());
        Assert.That(m_Warnings, Has.Count.EqualTo(1).And.Some.Contain("CreateInstance"));
    }

    [Test]
    public void WhatIsMadeAsItShould_IsNot()
    {
        var made = new GameObject("a", typeof(Script));
        Object copy = Object.Instantiate(made);
        Asset asset = ScriptableObject.CreateInstance<Asset>();
        Object.DestroyImmediate(made);
        Object.DestroyImmediate(copy);
        Object.DestroyImmediate(asset);
        Assert.That(m_Warnings, Is.Empty);
    }

    private static TestDelegate OnAnotherThread<T>(Func<T> use) => () =>
        Task.Factory.StartNew(use, TaskCreationOptions.LongRunning).GetAwaiter().GetResult();

    private void Hear(string text, string trace, LogType type, Object context)
    {
        if (type == LogType.Warning)
            m_Warnings.Add(text);
    }
}
