using System;
using System.IO;

namespace Alate.Benchmarks;

public static class BenchmarkSuite
{
    public static int Run(string jsonPath, TextWriter output)
    {
        var report = new Report(output);
        report.Heading();
        using var specimen = Specimen.Monarch();
        using var pack = new FlyingPack(specimen, 100);
        var plain = new PlainRig(specimen);

        SubstepBreakdown.Run(report, specimen);
        new SkinningComparison(specimen, plain, pack).Run(report);
        AerodynamicsComparison.Run(report, specimen, plain, pack);
        new ElasticityComparison(specimen, plain, pack).Run(report);
        MotionComparison.Run(report, specimen, plain, pack);
        Unity.Jobs.LowLevel.Unsafe.JobsUtility.JobWorkerCount = 0;
        using var swarm = new Swarm([specimen], 64);
        new FrameComparison(specimen, plain, swarm).Run(report);
        return report.IsValid ? 0 : 1;
    }
}
