using System;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Unity.Tests.Engine;

public sealed class LogTests
{
    [SetUp]
    public void LetTheOuterTestLog() => LogAssert.ignoreFailingMessages = true;

    [Test]
    public void AnUnexpectedError_FailsTheTest() =>
        Assert.That(Verdict(_ => Debug.LogError("oh")), Throws.TypeOf<AssertionException>().With.Message.Contain("oh"));

    [Test]
    public void AnUnexpectedException_FailsTheTest() =>
        Assert.That(Verdict(_ => Debug.LogException(new Exception("oh"))), Throws.TypeOf<AssertionException>());

    [Test]
    public void AWarning_FailsNoTest() => Assert.That(Verdict(_ => Debug.LogWarning("oh")), Throws.Nothing);

    [Test]
    public void AWarning_FailsATestThatMustExpectAll() => Assert.That(
        Verdict(log =>
        {
            log.MustExpectAll = true;
            Debug.LogWarning("oh");
        }), Throws.TypeOf<AssertionException>());

    [Test]
    public void ExpectedMessages_FailNoTest_InTheirOrder() => Assert.That(
        Verdict(log =>
        {
            log.Expect(new ExpectedMessage(LogType.Error, "oh", null));
            log.Expect(new ExpectedMessage(LogType.Warning, null, new Regex("^a.c$")));
            Debug.LogError("oh");
            Debug.LogWarning("abc");
        }), Throws.Nothing);

    [Test]
    public void AnExpectedMessageThatDoesNotCome_FailsTheTest() => Assert.That(
        Verdict(log => log.Expect(new ExpectedMessage(LogType.Log, "oh", null))), Throws.TypeOf<AssertionException>());

    [Test]
    public void AllMessagesChecked_FailForAPlainOne() => Assert.That(
        Verdict(log =>
        {
            Debug.Log("oh");
            log.CheckAll();
        }), Throws.TypeOf<AssertionException>());

    [Test]
    public void IgnoredErrors_FailNoTest() => Assert.That(
        Verdict(log =>
        {
            log.IgnoreFailures = true;
            Debug.LogError("oh");
        }), Throws.Nothing);

    private static TestDelegate Verdict(Action<TestLog> test) => () =>
    {
        var log = new TestLog();
        log.Begin();
        try
        {
            test(log);
        }
        finally
        {
            log.End();
        }

        log.CheckFailures();
        log.CheckExpected();
    };
}
