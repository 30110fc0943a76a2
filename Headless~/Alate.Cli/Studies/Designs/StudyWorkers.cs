using System.Diagnostics;
using System.Threading;

namespace Alate.Cli;

/// <summary>Processes that fly a study side by side: each flies a shard, and ends with the process that began it.</summary>
internal static class StudyWorkers
{
    /// <summary>Variable of the environment of a worker.</summary>
    private const string k_Worker = "ALATE_STUDY_WORKER";

    private const int k_Poll = 200;

    // Settings of .NET that no file of the program can give it. A worker flies the same again and again: its code is compiled once, and
    // what a flight leaves behind is collected rarely.
    private static readonly (string Name, string Value)[] s_Runtime =
    [
        ("DOTNET_TieredCompilation", "0"), ("DOTNET_EnableWriteXorExecute", "0"), ("DOTNET_GCgen0size", "0x2000000"),
    ];

    /// <summary>Ends this process, where it is a worker, with the one that began it.</summary>
    public static void EndWithParent()
    {
        if (Environment.GetEnvironmentVariable(k_Worker) != "1")
            return;
        new Thread(WaitForEnd) { IsBackground = true }.Start();
    }

    // The other end of the input closes however that process ends.
    private static void WaitForEnd()
    {
        while (Console.In.Read() >= 0)
        {
        }

        Environment.Exit(1);
    }

    /// <summary>Flies shards, each in a process.</summary>
    /// <param name="file">The study file.</param>
    /// <param name="folder">Its folder.</param>
    /// <param name="shards">One a process.</param>
    /// <param name="poll">Called again and again meanwhile.</param>
    /// <exception cref="UserException">A process failed.</exception>
    public static void Fly(string file, string folder, IEnumerable<StudyShard> shards, Action poll)
    {
        List<Process> workers = [];
        try
        {
            workers.AddRange(shards.Select(shard => Start(file, folder, shard)));
            while (workers.Exists(worker => !worker.HasExited))
            {
                workers.Find(worker => !worker.HasExited)?.WaitForExit(k_Poll);
                poll();
                if (workers.Find(worker => worker.HasExited && worker.ExitCode != 0) is { } failed)
                    throw new UserException($"A worker failed with exit code {failed.ExitCode}: {Words(failed)}");
            }

            if (workers.Find(worker => worker.ExitCode != 0) is { } late)
                throw new UserException($"A worker failed with exit code {late.ExitCode}: {Words(late)}");
        }
        finally
        {
            foreach (Process worker in workers)
            {
                if (!worker.HasExited)
                    worker.Kill();
                worker.Dispose();
            }
        }
    }

    private static string Words(Process worker)
    {
        string words = worker.StandardError.ReadToEnd().Trim();
        return words.StartsWith("alate: ", StringComparison.Ordinal) ? words[7..] : words.Length == 0 ? "it said nothing." : words;
    }

    private static Process Start(string file, string folder, StudyShard shard)
    {
        string program = typeof(StudyWorkers).Assembly.Location, host = Environment.ProcessPath;
        bool isHosted = Path.GetFileNameWithoutExtension(host) == "dotnet";
        string[] words = ["study", file, "--out", folder, "--shard", shard.ToString(), "--workers", "1"];
        var start = new ProcessStartInfo(isHosted ? host : "dotnet", [program, .. words])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment[k_Worker] = "1";
        foreach ((string name, string value) in s_Runtime)
            start.Environment.TryAdd(name, value);
        var worker = Process.Start(start);
        worker.OutputDataReceived += (_, _) => { };
        worker.BeginOutputReadLine();
        return worker;
    }
}
