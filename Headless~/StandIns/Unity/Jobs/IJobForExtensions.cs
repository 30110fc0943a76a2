namespace Unity.Jobs;

public static class IJobForExtensions
{
    /// <summary>Each index in turn, on one thread.</summary>
    public static JobHandle Schedule<T>(this T jobData, int arrayLength, JobHandle dependency) where T : struct, IJobFor =>
        ForJob<T>.Schedule(ref jobData, arrayLength, arrayLength, false, dependency);

    public static JobHandle ScheduleByRef<T>(this ref T jobData, int arrayLength, JobHandle dependency) where T : struct, IJobFor =>
        ForJob<T>.Schedule(ref jobData, arrayLength, arrayLength, false, dependency);

    /// <summary>Batches of indices on all threads, in any order.</summary>
    public static JobHandle ScheduleParallel<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependency)
        where T : struct, IJobFor => ForJob<T>.Schedule(ref jobData, arrayLength, innerloopBatchCount, true, dependency);

    public static JobHandle ScheduleParallelByRef<T>(this ref T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependency)
        where T : struct, IJobFor => ForJob<T>.Schedule(ref jobData, arrayLength, innerloopBatchCount, true, dependency);

    public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobFor => ForJob<T>.Run(ref jobData, arrayLength);

    public static void RunByRef<T>(this ref T jobData, int arrayLength)
        where T : struct, IJobFor => ForJob<T>.Run(ref jobData, arrayLength);
}
