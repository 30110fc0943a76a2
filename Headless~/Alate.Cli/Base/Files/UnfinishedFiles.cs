using System.ComponentModel;
using System.Diagnostics;
using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>
/// Names of files that are not finished, <c>NAME.MACHINE-PROCESS-RUN.part</c>, by which a run knows those that another one left behind when
/// it was killed.
/// </summary>
internal static partial class UnfinishedFiles
{
    /// <summary>Age from which a file of another machine is taken for one that was left behind.</summary>
    private static readonly TimeSpan s_Old = TimeSpan.FromDays(1);

    private static readonly string s_Machine = Hash(Environment.MachineName), s_Run = Guid.NewGuid().ToString("N")[..16];

    /// <summary>Ending of the names of this run's files; each number has another one.</summary>
    public static string Suffix(int number) => $".{s_Machine}-{Environment.ProcessId}-{s_Run}{number:x}.part";

    /// <summary>Removes what runs that are no more have left in a folder; what cannot be removed stays.</summary>
    public static void Sweep(string folder)
    {
        try
        {
            foreach (string file in Directory.EnumerateFiles(folder, "*.part"))
            {
                Match name = Ending().Match(file);
                if (name.Success && IsLeft(file, name.Groups[1].Value, int.Parse(name.Groups[2].ValueSpan), name.Groups[3].Value))
                    File.Delete(file);
            }
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            // They do no harm but for the room they take.
        }
    }

    private static bool IsLeft(string file, string machine, int process, string run)
    {
        DateTime written = File.GetLastWriteTime(file);
        if (machine != s_Machine)
            return DateTime.Now - written > s_Old;
        if (process == Environment.ProcessId)
            return !run.StartsWith(s_Run, StringComparison.Ordinal);
        try
        {
            using var running = Process.GetProcessById(process);
            return running.StartTime > written;
        }
        catch (Exception problem) when (problem is ArgumentException or InvalidOperationException)
        {
            return true;
        }
        catch (Win32Exception)
        {
            // Somebody else's.
            return false;
        }
    }

    // FNV-1a: names of machines may have any characters.
    private static string Hash(string text)
    {
        uint hash = 2166136261;
        foreach (byte letter in Encoding.UTF8.GetBytes(text))
            hash = (hash ^ letter) * 16777619;
        return hash.ToString("x8");
    }

    [GeneratedRegex(@"\.([0-9a-f]{8})-([0-9]{1,9})-([0-9a-f]{17,32})\.part$")]
    private static partial Regex Ending();
}
