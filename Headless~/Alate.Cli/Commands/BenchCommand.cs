using System.CommandLine;
using System.IO;
using Alate.Benchmarks;
using Alate.Cli.Output;

namespace Alate.Cli.Commands;

/// <summary><c>bench</c>: the kernels against what one would write at first, as ratios within this process.</summary>
internal static class BenchCommand
{
    public static Command Create(TextWriter output)
    {
        var json = new Option<string>("--json") { HelpName = "FILE", Description = "Also write the ratios as JSON to this file." };
        var command = new Command(
            "bench", "Measures the kernels against naive baselines within one process. Build with -c Release.") { json };
        HelpExamples.Set(command, "Example:\n  bench --json bench.json");
        command.SetAction(parsed =>
        {
            string file = parsed.GetValue(json);
            if (file != null)
                OutputFolder.CheckFile(file);
            return BenchmarkSuite.Run(file, output);
        });
        return command;
    }
}
