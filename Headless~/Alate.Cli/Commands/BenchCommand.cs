using System.CommandLine;
using System.Diagnostics;
using Alate.Benchmarks;

namespace Alate.Cli;

/// <summary><c>bench</c>: the kernels against what one would write at first, as ratios within this process.</summary>
internal static class BenchCommand
{
    /// <summary>Variable of .NET that has each method compiled once and for all; the tool's own setting gives way to it.</summary>
    private const string k_Tiers = "DOTNET_TieredCompilation", k_None = "0";

    public static Command Create(TextWriter output)
    {
        var json = new Option<string>("--json") { HelpName = "FILE", Description = "Also write the ratios as JSON to this file." };
        var hash = new Option<bool>("--hash")
        {
            Description = "Measure nothing: run four scenes in several ways and compare the hashes of their results with the held ones.",
        };
        var command = new Command(
            "bench", "Measures the kernels against naive baselines within one process. Build with -c Release.") { json, hash };
        HelpExamples.Set(command, "Examples:\n  bench --json bench.json\n  bench --hash");
        command.Validators.Add(parsed =>
        {
            if (parsed.GetValue(hash) && parsed.GetValue(json) != null)
                parsed.AddError("--hash measures nothing: leave out --json.");
        });
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(hash))
                return SceneHashes.Run(output);
            string file = parsed.GetValue(json);
            if (Environment.GetEnvironmentVariable(k_Tiers) == k_None)
                return Run(file, stream => BenchmarkSuite.Run(stream, output));
            if (file != null)
                OutputFile.Check(file);
            return RunWithoutTiers([.. parsed.Tokens.Select(token => token.Value)]);
        });
        return command;
    }

    // The same command in a process of its own.
    private static int RunWithoutTiers(string[] words)
    {
        string program = Environment.ProcessPath;
        bool isHost = Path.GetFileNameWithoutExtension(program) == "dotnet";
        var start = new ProcessStartInfo(program, isHost ? [typeof(BenchCommand).Assembly.Location, .. words] : words);
        start.Environment[k_Tiers] = k_None;
        using var process = Process.Start(start);
        process.WaitForExit();
        return process.ExitCode;
    }

    /// <summary>Runs the measurements and writes their figures; a file that cannot be is refused before anything is measured.</summary>
    /// <param name="file">Where the figures go; null for nowhere.</param>
    /// <param name="measure">Given where to write the figures, or null; its exit code counts.</param>
    /// <exception cref="UserException">The file cannot be written.</exception>
    public static int Run(string file, Func<Stream, int> measure)
    {
        if (file == null)
            return measure(null);
        OutputFile.Check(file);
        using var figures = new MemoryStream();
        int code = measure(figures);
        OutputFile.Write(file, figures.WriteTo);
        return code;
    }
}
