using System;
using Unity.StandIns;

namespace Alate.Benchmarks;

/// <summary>
/// Measures what flight adds to a frame of wings that beat alike and carry nothing, with the jobs and allocations of a frame.
/// </summary>
internal static class FlightComparison
{
    public const int Insects = 400;

    private const int k_Frames = 60;

    public static void Run(Report report)
    {
        using var wings = new FlyingSwarm(Insects, flies: false);
        using var flight = new FlyingSwarm(Insects, flies: true);
        for (int frame = 0; frame < k_Frames; frame++)
        {
            wings.Frame();
            flight.Frame();
        }

        report.Check("insects that fly hover", flight.FastestBody(), 1.5);
        double[] time = Race.Run(flight.Contestant, wings.Contestant);
        report.Ratio(Targets.Flight, time[0], time[1], time[0] / time[1]);

        using (var ahead = new FlyingSwarm(Insects, flies: true, allTerms: true))
        {
            for (int frame = 0; frame < k_Frames; frame++)
                ahead.Frame();

            report.Check("insects with all terms fly ahead", ahead.FastestBody(), 2.5);
            time = Race.Run(ahead.Contestant, wings.Contestant);
            report.Ratio(Targets.FlightByReaction, time[0], time[1], time[0] / time[1]);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int frame = 0; frame < k_Frames; frame++)
            flight.Frame();
        double bytes = (GC.GetAllocatedBytesForCurrentThread() - before) / (double)k_Frames;
        report.Figure("flight_bytes_per_frame", $"frame of {Insects} insects that fly", "bytes allocated", bytes);
        report.Figure("flight_jobs_added", $"frame of {Insects} insects that fly", "jobs more", Jobs(flight) - Jobs(wings));
    }

    private static int Jobs(FlyingSwarm swarm)
    {
        int before = JobExecution.PendingCount;
        swarm.Schedule();
        int jobs = JobExecution.PendingCount - before;
        swarm.World.Complete();
        return jobs;
    }
}
