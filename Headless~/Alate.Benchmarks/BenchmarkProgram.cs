using System;

namespace Alate.Benchmarks;

public static class BenchmarkProgram
{
    public static int Main(string[] arguments) => BenchmarkSuite.Run(null, Console.Out);
}
