using System;

namespace Alate.Benchmarks;

/// <summary>The suite by itself, without a file of its figures; the command <c>bench --json FILE</c> of the command line writes one.</summary>
public static class BenchmarkProgram
{
    public static int Main() => BenchmarkSuite.Run(null, Console.Out);
}
