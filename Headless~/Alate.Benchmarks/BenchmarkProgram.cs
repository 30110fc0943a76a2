using System;

namespace Alate.Benchmarks;

/// <summary>The suite by itself: an optional argument is the path of its JSON.</summary>
public static class BenchmarkProgram
{
    public static int Main(string[] arguments) => BenchmarkSuite.Run(arguments.Length > 0 ? arguments[0] : null, Console.Out);
}
