using System.Threading;

namespace Alate.Cli;

/// <summary>
/// Files with the rows of a study in its folder: one for each shard, whose first line names the study. A row stands there as soon as its
/// run is done, so that a study that was killed goes on where it was.
/// </summary>
internal static class StudyRows
{
    private const string k_Begin = "rows-", k_End = ".jsonl";

    /// <summary>Seconds that a file may be held by a run that is ending.</summary>
    private const double k_Patience = 10;

    /// <summary>All rows in folders, by their run.</summary>
    /// <exception cref="UserException">One belongs to another study.</exception>
    public static SortedDictionary<int, StudyRow> Read(StudyPlan plan, params string[] folders)
    {
        var rows = new SortedDictionary<int, StudyRow>();
        foreach (string file in folders.SelectMany(Files))
        {
            foreach (StudyRow row in Lines(file, plan).Skip(1).Select(line => StudyRow.Read(line, plan.File.Measures.Count)))
            {
                if (row != null && row.Run >= 0 && row.Run < plan.Points.Length)
                    rows.TryAdd(row.Run, row);
            }
        }

        return rows;
    }

    /// <summary>Files with rows in a folder, by name.</summary>
    public static IEnumerable<string> Files(string folder) => Directory.Exists(folder)
        ? Directory.GetFiles(folder, k_Begin + "*" + k_End).Order(StringComparer.Ordinal)
        : [];

    /// <summary>Flies the runs of a shard that have no row yet, and writes each behind the rows of the shard.</summary>
    /// <param name="plan">The study.</param>
    /// <param name="folder">Its folder, which is there.</param>
    /// <param name="shard">Its runs.</param>
    /// <param name="progress">Told the runs done.</param>
    /// <exception cref="UserException">The folder holds another study, or another process flies the same shard.</exception>
    public static void Fly(StudyPlan plan, string folder, StudyShard shard, Action<int> progress)
    {
        string path = Path.Combine(folder, $"{k_Begin}{shard.Number}-of-{shard.Count}{k_End}");
        using FileStream held = Hold(path);
        using var file = new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite);
        SortedDictionary<int, StudyRow> known = Read(plan, folder);
        CutUnfinishedLine(file);
        if (file.Length == 0)
            Write(file, Encoding.UTF8.GetBytes(Heading(plan) + "\n"));
        int done = 0;
        foreach (int run in shard.Runs(plan.Points.Length))
        {
            plan.Search?.Extend(plan.Points, known);
            if (!known.ContainsKey(run))
            {
                known[run] = plan.Fly(run);
                Write(file, known[run].Line());
            }

            progress(++done);
        }
    }

    private static string Heading(StudyPlan plan) => $"{{\"study\":\"{plan.Hash}\"}}";

    // Lines that are whole; those of another process may be written meanwhile.
    private static string[] Lines(string path, StudyPlan plan)
    {
        string text;
        using (var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete))
        {
            using var reader = new StreamReader(file);
            text = reader.ReadToEnd();
        }

        string[] lines = text[..(text.LastIndexOf('\n') + 1)].Split('\n', StringSplitOptions.RemoveEmptyEntries);
        return lines.Length == 0 || lines[0] == Heading(plan)
            ? lines
            : throw new UserException($"'{path}' holds rows of another study, or of another version of it: its file, its insect or a file "
                + "that it reads has changed since. Take another folder, or remove those rows.");
    }

    // A file of its own: where the rows themselves were held, nobody could read them meanwhile.
    private static FileStream Hold(string path)
    {
        DateTime until = DateTime.UtcNow.AddSeconds(k_Patience);
        while (true)
        {
            try
            {
                return new FileStream(
                    path + ".lock", FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, 1, FileOptions.DeleteOnClose);
            }
            catch (IOException) when (File.Exists(path + ".lock"))
            {
                if (DateTime.UtcNow > until)
                    throw new UserException($"Another run of this study writes '{path}'.");
                Thread.Sleep(100);
            }
        }
    }

    private static void CutUnfinishedLine(FileStream file)
    {
        byte[] all = new byte[file.Length];
        file.Position = 0;
        file.ReadExactly(all);
        file.SetLength(Array.LastIndexOf(all, (byte)'\n') + 1);
        file.Position = file.Length;
    }

    private static void Write(FileStream file, byte[] line)
    {
        file.Write(line);
        file.Flush();
    }
}
