using System;
using System.Globalization;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.StandIns;

namespace Alate.Benchmarks;

/// <summary>Measures the cost of a frame by the number of insects and of cores, and the allocations and jobs of a frame.</summary>
internal sealed class CrowdComparison
{
    private const int k_WarmFrames = 100;
    private static readonly int[] s_Crowds = [1, 10, 100, 400];

    private readonly Specimen m_Specimen;

    public CrowdComparison(Specimen specimen) => m_Specimen = specimen;

    public void Run(Report report, Swarm sixtyFour)
    {
        using var one = new Swarm([m_Specimen], 1);
        using var sixteen = new Swarm([m_Specimen], 16);
        using var fourHundred = new Swarm([m_Specimen], 400);
        double[] time = Race.Run(one.Contestant, sixteen.Contestant, sixtyFour.Contestant, fourHundred.Contestant);
        report.Ratio(Targets.Crowd, time[3], time[1], time[3] / time[1]);
        report.Ratio(Targets.Single, time[0], time[2], time[0] / time[2]);
        Cores(report, sixtyFour);
        JobsUtility.ResetJobWorkerCount();
        foreach (int insects in s_Crowds)
            Memory(report, insects);
        JobsUtility.JobWorkerCount = 0;
    }

    private static void Cores(Report report, Swarm swarm)
    {
        // A frame in between wakes the workers, or sends them to sleep.
        Contestant frames = swarm.Contestant;
        double[] time = Race.Run(
            frames with { Prepare = () => FrameWith(1, swarm) }, frames with { Prepare = () => FrameWith(0, swarm) });
        report.Ratio(Targets.Cores, time[0], time[1], time[1] / time[0]);
    }

    private static void FrameWith(int workers, Swarm swarm)
    {
        JobsUtility.JobWorkerCount = workers;
        swarm.Frame();
    }

    private void Memory(Report report, int insects)
    {
        using var swarm = new Swarm([m_Specimen], insects);
        swarm.Frame();
        long own = GC.GetAllocatedBytesForCurrentThread(), all = GC.GetTotalAllocatedBytes(precise: true);
        for (int frame = 0; frame < k_WarmFrames; frame++)
            swarm.Frame();
        own = GC.GetAllocatedBytesForCurrentThread() - own;
        all = GC.GetTotalAllocatedBytes(precise: true) - all;

        string group = insects.ToString(CultureInfo.InvariantCulture);
        report.Figure(
            "bytes_per_frame", group, $"frame of {insects} insects", "bytes allocated", Math.Max(own, all) / (double)k_WarmFrames);
        report.Figure("jobs_per_frame", group, $"frame of {insects} insects", "jobs", Jobs(swarm));
    }

    // Jobs that are pending when a whole frame has been scheduled and none of it completed.
    private static int Jobs(Swarm swarm)
    {
        int before = JobExecution.PendingCount;
        swarm.World.ScheduleStep(swarm.TimeDue);
        swarm.World.ScheduleSkin(1f);
        int jobs = JobExecution.PendingCount - before;
        swarm.World.Complete();
        return jobs;
    }
}
