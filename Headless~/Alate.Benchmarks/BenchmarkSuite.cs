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
        new SkinningComparison(specimen, plain, pack).Run(report);
        return report.IsValid ? 0 : 1;
    }
}
