using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text.Json;
using Unity.Jobs.LowLevel.Unsafe;

namespace Alate.Benchmarks;

/// <summary>
/// All measurements in one process: kernels, frames, crowds, species. Every ratio is taken between variants that run in turn, so it depends
/// little on the machine; the absolute times are for this one.
/// </summary>
public static class BenchmarkSuite
{
    private const int k_WarmUpSubsteps = 100;

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    private static readonly bool s_SafetyChecks = true;
#else
    private static readonly bool s_SafetyChecks = false;
#endif

    /// <summary>Measures, prints a table and writes the figures.</summary>
    /// <param name="json">Takes the figures at the end; null for the table alone.</param>
    /// <param name="output">Takes the table, line by line as it grows.</param>
    /// <returns>0; 1 if a baseline does not compute what ours does.</returns>
    public static int Run(Stream json, TextWriter output)
    {
        var report = new Report(output);
        Machine(report);
        report.Heading();
        Measure(report);
        if (json != null)
            JsonSerializer.Serialize(json, report.Content, new JsonSerializerOptions { WriteIndented = true });
        return report.IsValid ? 0 : 1;
    }

    private static void Measure(Report report)
    {
        HotCode.Run(report);
        using var monarch = Specimen.Monarch();
        using var version01 = Specimen.MonarchOfVersion01();
        var plain = new PlainRig(version01);
        using (var pack = new FlyingPack(version01, k_WarmUpSubsteps))
        {
            new SkinningComparison(version01, plain, pack).Run(report);
            AerodynamicsComparison.Run(report, version01, plain, pack);
            new ElasticityComparison(version01, plain, pack).Run(report);
            MotionComparison.Run(report, version01, plain, pack);
        }

        ArrayComparison.Run(report);
        WakeComparison.Run(report);
        SubstepBreakdown.Run(report, monarch, version01);
        OnOneCore(() => Crowds(report, monarch, version01, plain));
        SystemFigures.Run(report);
        LivingFigures.Run(report);
        StartFigures.Run(report);
        MemoryFigures.Run(report);
        OnOneCore(() => UploadComparison.Run(report, monarch));
        OnOneCore(() => BakedFigures.Run(report));
        AuthoringFigures.Run(report);
    }

    private static void Crowds(Report report, Specimen monarch, Specimen version01, PlainRig plain)
    {
        using (var swarm = new Swarm([monarch], FrameComparison.Insects))
        {
            using (var earlier = new Swarm([version01], FrameComparison.Insects))
                new FrameComparison(version01, plain, earlier, swarm).Run(report);
            new CrowdComparison(monarch).Run(report, swarm);
            InflowComparison.Run(report, monarch);
        }

        FlightComparison.Run(report);
        SpeciesFigures.Run(report);
    }

    /// <summary>Measures frames of crowds that live, on all cores, and of baked ones, on one.</summary>
    internal static List<LivingFrame> MeasureCrowds(TextWriter output)
    {
        var report = new Report(output);
        List<LivingFrame> frames = LivingFigures.Run(report);
        OnOneCore(() => frames.AddRange(BakedFigures.Run(report)));
        return frames;
    }

    /// <summary>Counts the memory of an insect that lives.</summary>
    internal static List<InsectMemory> MeasureMemory(TextWriter output) => MemoryFigures.Run(new Report(output));

    private static void OnOneCore(Action measure)
    {
        int workers = JobsUtility.JobWorkerCount;
        JobsUtility.JobWorkerCount = 0;
        try
        {
            measure();
        }
        finally
        {
            JobsUtility.JobWorkerCount = workers;
        }
    }

    private static void Machine(Report report)
    {
        report.Content["runtime"] = RuntimeInformation.FrameworkDescription;
        report.Content["processor"] = RuntimeInformation.ProcessArchitecture.ToString();
        report.Content["processor_count"] = Environment.ProcessorCount;
        report.Content["safety_checks"] = s_SafetyChecks;
        report.Content["note"] = "RyuJIT on the headless stand-ins; Burst was not measured.";
        report.Line($"{report.Content["runtime"]}, {Environment.ProcessorCount} processors. {report.Content["note"]}");
        if (s_SafetyChecks)
            report.Line("This build has the safety checks of a debug build on: take -c Release for figures that count.");
    }
}
