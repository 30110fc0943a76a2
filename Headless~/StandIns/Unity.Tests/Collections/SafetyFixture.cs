using NUnit.Framework;
using StandIns;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.StandIns;

namespace Unity.Tests;

/// <summary>Each test ends as it began: no job pending, no memory leaked, and jobs on workers in their usual order.</summary>
public abstract class SafetyFixture
{
    private int m_LiveBefore;

    [SetUp]
    public void RememberWhatLives() => m_LiveBefore = NativeMemoryLedger.LiveCount;

    [TearDown]
    public void CheckThatNothingIsLeft()
    {
        JobExecution.Order = JobOrder.Ascending;
        JobsUtility.ResetJobWorkerCount();
        int pending = JobExecution.PendingCount;
        JobExecution.CompleteAll();
        Assert.That(pending, Is.Zero, "jobs were not completed");
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(m_LiveBefore), NativeMemoryLedger.Describe());
    }
}
