using System;
using System.CommandLine;
using Alate.Benchmarks;

namespace Alate.Cli.Commands;

/// <summary><c>bench</c>: the kernels against what one would write at first, as ratios within this process.</summary>
internal static class BenchCommand
{
    public static Command Create()
    {
        var json = new Option<string>("--json") { HelpName = "FILE", Description = "Also writes the ratios as JSON." };
        var command = new Command("bench", "Measures the kernels against naive baselines in one process. Build with -c Release.\n\nExample:\n  bench --json bench.json") { json };
        command.SetAction(parsed => BenchmarkSuite.Run(parsed.GetValue(json), Console.Out));
        return command;
    }
}
