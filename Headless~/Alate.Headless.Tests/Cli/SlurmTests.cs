using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>A study on a Slurm of this machine: an array of jobs that is cancelled, submitted again and merged.</summary>
public sealed class SlurmTests
{
    private const string k_Study = """
        { "version": 1, "insect": "painted-lichen-moth", "options": ["--speed", "0", "--pitch", "30"],
          "parameters": [
            { "key": "insect.beat.frequencyHertz", "from": 20, "to": 30, "steps": 20 },
            { "key": "elasticity", "from": 0.5, "to": 2, "steps": 20, "scale": "logarithmic" } ] }
        """;

    [Test]
    [Explicit]
    [Category("Long")]
    public void AnArrayOfEight_CancelledAndSubmittedAgain_MakesTheSameTable()
    {
        if (Shell("sinfo -h -t idle,mixed,allocated | grep -q .") != 0)
            Assert.Ignore("No Slurm runs here (sinfo).");
        using var run = new CommandRun();
        string file = run.Write("slurm-test.study.json", k_Study), shared = Path.Combine(run.Folder, "shared");
        Assert.That(run.Run("study", file, "--out", shared, "--slurm", "8"), Is.Zero, run.Errors);

        Submit(shared);
        Wait(() => Rows(shared) >= 20, "no job began");
        Assert.That(Shell("scancel -n slurm-test"), Is.Zero);
        Wait(Ended, "jobs were not cancelled");
        int before = Rows(shared);
        Assert.That(before, Is.LessThan(400), "all was done before it was cancelled");
        Assert.That(run.Run("study", "merge", file, shared, "--out", run.Out), Is.EqualTo(2), "too few runs");

        Submit(shared);
        Wait(Ended, "jobs did not end");
        Assert.That(run.Run("study", "merge", file, shared, "--out", run.Out), Is.Zero, run.Errors);
        string whole = Path.Combine(run.Folder, "whole");
        Assert.That(run.Run("study", file, "--out", whole, "--workers", "1"), Is.Zero, run.Errors);
        Assert.That(File.ReadAllBytes(Path.Combine(run.Out, "study.csv")).AsSpan()
            .SequenceEqual(File.ReadAllBytes(Path.Combine(whole, "study.csv"))));
    }

    private static void Submit(string folder) => Assert.That(Shell($"sbatch '{Path.Combine(folder, "study.sbatch")}'"), Is.Zero);

    private static bool Ended() => Shell("squeue -h -n slurm-test | grep -q .") != 0;

    private static int Rows(string folder) => Directory.GetFiles(folder, "rows-*.jsonl").Sum(file => Math.Max(0, Lines(file) - 1));

    private static int Lines(string file)
    {
        using var stream = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd().Count(letter => letter == '\n');
    }

    private static void Wait(Func<bool> ended, string problem)
    {
        for (int k = 0; k < 600; k++)
        {
            if (ended())
                return;
            Thread.Sleep(500);
        }

        Assert.Fail(problem);
    }

    private static int Shell(string words)
    {
        using var process = Process.Start(
            new ProcessStartInfo("/bin/sh", ["-c", words]) { RedirectStandardOutput = true, RedirectStandardError = true });
        process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return process.ExitCode;
    }
}
