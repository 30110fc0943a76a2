using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Mutations.Sources;

namespace Alate.Mutations.Trials;

/// <summary>A worker, watched from outside: how long it computes, how long it waits, how much memory it takes.</summary>
/// <param name="bin">Folder of the tests, with the changed assemblies.</param>
/// <param name="tests">Name of the assembly whose dependencies the worker has.</param>
/// <param name="scratch">Folder for what tests write.</param>
internal sealed class WorkerProcess(string bin, string tests, string scratch)
{
    private const long k_Memory = 4L << 30;

    /// <summary>Processor time that a group may take beyond five times what it took before, seconds.</summary>
    public double Patience { get; init; } = 15;

    /// <summary>Why the last worker was ended; null if it came to its end by itself.</summary>
    public string Ended { get; private set; }

    /// <summary>Runs groups of tests.</summary>
    /// <param name="groups">Groups in their order.</param>
    /// <param name="seconds">Processor time that each group took; null for no limit.</param>
    /// <param name="mutant">Number of the mutant that lives; 0 for none.</param>
    /// <param name="records">Whether the mutants that tests meet are recorded.</param>
    /// <returns>What the worker reported.</returns>
    public List<TestReport> Run(IReadOnlyList<TestGroup> groups, IReadOnlyList<double> seconds, int mutant, bool records)
    {
        string folder = Path.Combine(scratch, Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(folder);
        string plan = Path.Combine(folder, "plan"), report = Path.Combine(folder, "report");
        File.WriteAllText(plan, JsonSerializer.Serialize(groups));
        using Process process = Start(folder, ["worker", plan, report], mutant, records);
        Ended = Watch(process, report, seconds);
        List<TestReport> reports = Read(report);
        if (Ended == null && (reports.Count == 0 || reports[^1].Event != TestReport.Done))
            Ended = $"crash, exit code {process.ExitCode}";
        Directory.Delete(folder, true);
        return reports;
    }

    /// <summary>Classes of tests of an assembly.</summary>
    public string[] Classes(string assembly)
    {
        using Process process = Start(scratch, ["classes", assembly], 0, false);
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
    }

    private Process Start(string temporary, string[] arguments, int mutant, bool records)
    {
        string name = Path.Combine(bin, tests);
        string[] dependencies = File.Exists(name + ".deps.json") ? ["--depsfile", name + ".deps.json"] : [];
        string worker = Path.Combine(bin, "Alate.Mutations.dll");
        string[] words = ["exec", .. dependencies, "--runtimeconfig", name + ".runtimeconfig.json", worker, .. arguments];
        var start = new ProcessStartInfo("dotnet", words)
        {
            WorkingDirectory = temporary,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["TMPDIR"] = temporary;
        start.Environment[MutantSwitch.Variable] = mutant.ToString();
        start.Environment["DOTNET_GCgen0size"] = "0x4000000";
        start.Environment["DOTNET_GCHeapHardLimit"] = "0xC0000000";
        start.Environment["DOTNET_DbgEnableMiniDump"] = "0";
        if (records)
            start.Environment[MutantSwitch.HitsVariable] = Path.Combine(temporary, "hits");
        var process = Process.Start(start);
        process.StandardInput.Close();
        process.ErrorDataReceived += (_, _) => { };
        process.BeginErrorReadLine();
        if (arguments[0] == "worker")
        {
            process.OutputDataReceived += (_, _) => { };
            process.BeginOutputReadLine();
        }

        return process;
    }

    /// <summary>
    /// Waits for the end, and ends a worker that computes or waits much longer than the tests did before, or that takes too much memory.
    /// </summary>
    private string Watch(Process process, string report, IReadOnlyList<double> seconds)
    {
        int group = -1;
        double began = 0;
        var wall = Stopwatch.StartNew();
        while (!process.WaitForExit(200))
        {
            process.Refresh();
            double now;
            long memory;
            try
            {
                now = process.TotalProcessorTime.TotalSeconds;
                memory = process.WorkingSet64;
            }
            catch (Exception e) when (e is InvalidOperationException or System.ComponentModel.Win32Exception)
            {
                // It has just ended.
                break;
            }

            if (seconds != null && LastGroup(report) is var last && last != group)
            {
                group = last;
                began = now;
                wall.Restart();
            }

            double usual = seconds == null || group < 0 ? double.PositiveInfinity : seconds[group];
            string reason = memory > k_Memory ? "too much memory"
                : now - began > Patience + 5 * usual ? "timeout"
                : wall.Elapsed.TotalSeconds > 90 + 30 * usual ? "timeout, waiting"
                : null;
            if (reason == null)
                continue;
            process.Kill(true);
            process.WaitForExit();
            return reason;
        }

        process.WaitForExit();
        return null;
    }

    private static int LastGroup(string report) => Read(report).LastOrDefault()?.Group ?? -1;

    private static List<TestReport> Read(string report)
    {
        if (!File.Exists(report))
            return [];
        using var stream = new FileStream(report, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        string text = new StreamReader(stream).ReadToEnd();
        // The last line may be half written.
        return text[..(text.LastIndexOf('\n') + 1)].Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .Select(line => JsonSerializer.Deserialize<TestReport>(line)).ToList();
    }
}
