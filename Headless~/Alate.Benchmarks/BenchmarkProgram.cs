using System;

namespace Alate.Benchmarks;

/// <summary>
/// The suite by itself, without a file of its figures, or with --hash the hashes of scenes: as <c>bench</c> of the command line, in less to
/// take to another machine.
/// </summary>
public static class BenchmarkProgram
{
    public static int Main(string[] args) => args switch
    {
        ["--hash"] => SceneHashes.Run(Console.Out),
        ["--hash", string scene] => SceneHashes.Run(Console.Out, scene),
        _ => BenchmarkSuite.Run(null, Console.Out),
    };
}
