namespace Unity.Jobs;

public static class IJobExtensions
{
    public static JobHandle Schedule<T>(this T jobData, JobHandle dependsOn = default) where T : struct, IJob =>
        SingleJob<T>.Schedule(ref jobData, dependsOn);

    public static JobHandle ScheduleByRef<T>(this ref T jobData, JobHandle dependsOn = default) where T : struct, IJob =>
        SingleJob<T>.Schedule(ref jobData, dependsOn);

    public static void Run<T>(this T jobData) where T : struct, IJob => SingleJob<T>.Run(ref jobData);

    public static void RunByRef<T>(this ref T jobData) where T : struct, IJob => SingleJob<T>.Run(ref jobData);
}
