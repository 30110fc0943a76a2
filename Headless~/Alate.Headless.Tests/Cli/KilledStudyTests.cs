using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Studies that are killed, resumed and flown in parts, against one that is flown at once.</summary>
public sealed class KilledStudyTests
{
    [Test]
    [Explicit]
    [Category("Long")]
    public void AThousandRuns_KilledTenTimes_AndFlownInSevenParts_AreTheSameTable()
    {
        using var run = new CommandRun();
        string file = run.Write("s.study.json", StudyCommandTests.k_Study
            .Replace("\"values\": [20, 30]", "\"from\": 20, \"to\": 30, \"steps\": 25")
            .Replace("\"steps\": 2,", "\"steps\": 40,"));
        Assert.That(run.Run("study", file, "--out", run.Out, "--workers", "2"), Is.Zero, run.Errors);
        byte[] whole = File.ReadAllBytes(Path.Combine(run.Out, "study.csv"));
        Assert.That(whole.AsSpan().Count((byte)'\n'), Is.EqualTo(1001));

        string killed = Path.Combine(run.Folder, "killed");
        var random = new Random(26);
        int rows = 0;
        for (int kills = 0; kills < 10; kills++)
        {
            using var process = Process.Start(new ProcessStartInfo("/bin/sh",
                ["-c", $"exec {CommandProcess.Program} study '{file}' --out '{killed}' --workers 2 >/dev/null"]));
            // Wherever it is then, some dozens of rows later: time would be too short for one machine and too long for another.
            for (int wanted = rows + random.Next(1, 90); RowsIn(killed) < wanted && !process.HasExited;)
                Thread.Sleep(random.Next(1, 20));
            Assert.That(process.HasExited, Is.False, $"done after {kills} kills");
            process.Kill();
            process.WaitForExit();
            Assert.That(RowsIn(killed), Is.InRange(rows + 1, 999), "rows were lost, or all were flown");
            rows = RowsIn(killed);
        }

        Assert.That(run.Run("study", file, "--out", killed, "--workers", "2"), Is.Zero, run.Errors);
        Assert.That(File.ReadAllBytes(Path.Combine(killed, "study.csv")).AsSpan().SequenceEqual(whole), "killed");

        string[] parts = Enumerable.Range(1, 7).Select(part => Path.Combine(run.Folder, "part" + part)).ToArray();
        for (int part = 1; part <= 7; part++)
            Assert.That(run.Run("study", file, "--out", parts[part - 1], "--shard", part + "/7"), Is.Zero, run.Errors);
        string merged = Path.Combine(run.Folder, "merged");
        Assert.That(run.Run(["study", "merge", file, .. parts, "--out", merged]), Is.Zero, run.Errors);
        Assert.That(File.ReadAllBytes(Path.Combine(merged, "study.csv")).AsSpan().SequenceEqual(whole), "merged");
    }

    // Rows that parts have written so far, whole ones.
    private static int RowsIn(string folder)
    {
        if (!Directory.Exists(folder))
            return 0;
        return Directory.GetFiles(folder, "rows-*.jsonl").Sum(path =>
        {
            using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
            using var reader = new StreamReader(stream);
            return reader.ReadToEnd().Count(letter => letter == '\n');
        });
    }
}
