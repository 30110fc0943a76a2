using System.Threading;

namespace Alate.Cli;

/// <summary>
/// A folder that gets all of its files or none: they are written under other names and take their own at <see cref="Commit"/>. Without it,
/// disposal and <see cref="Interruption"/> remove what was written, and the folders that were made.
/// </summary>
internal sealed class OutputFolder : IDisposable
{
    private static int s_Folders;

    private readonly string m_What;
    private readonly List<string> m_MadeFolders = [];
    private readonly List<(string Written, string Final)> m_Files = [];
    private readonly HashSet<string> m_Swept = [];
    private readonly string m_Suffix = UnfinishedFiles.Suffix(Interlocked.Increment(ref s_Folders));
    private bool m_Committed, m_Held;

    private OutputFolder(string root, string what)
    {
        Root = root;
        m_What = what;
        lock (Interruption.Files)
            Interruption.Add(this);
    }

    /// <summary>The full path.</summary>
    public string Root { get; private set; }

    /// <summary>Makes the folder where there is none and tries whether files of these names can be written into it.</summary>
    /// <exception cref="UserException">They cannot.</exception>
    public static OutputFolder Prepare(string given, params string[] names)
    {
        if (FileProblem.IsNoName(given))
            throw new UserException($"Cannot write into '{given}': that is no name of a folder.");
        var folder = new OutputFolder(given, $"into '{given}'");
        try
        {
            folder.Try(() =>
            {
                folder.Root = Path.GetFullPath(given);
                folder.Make(folder.Root);
                folder.Sweep(folder.Root);
                string probe = Path.Combine(folder.Root, "probe" + folder.m_Suffix);
                lock (Interruption.Files)
                {
                    File.WriteAllText(probe, "");
                    File.Delete(probe);
                }
            });
            foreach (string name in names)
            {
                if (Directory.Exists(Path.Combine(folder.Root, name)))
                    throw new UserException($"Cannot write '{name}' into '{given}': there is a folder of that name.");
            }

            return folder;
        }
        catch
        {
            folder.Dispose();
            throw;
        }
    }

    /// <summary>The folder of a single file, which is there already.</summary>
    /// <param name="file">The file.</param>
    /// <param name="given">What the user calls it.</param>
    public static OutputFolder Around(string file, string given) => new(Path.GetDirectoryName(Path.GetFullPath(file)), $"'{given}'");

    /// <summary>Writes a file, under another name as yet; folders within it are made.</summary>
    /// <exception cref="UserException">It cannot be written.</exception>
    public void Write(string name, Action<Stream> write) => Try(() =>
    {
        using FileStream stream = Open(Path.Combine(Root, name));
        write(stream);
    });

    /// <summary>Makes a folder within it.</summary>
    /// <exception cref="UserException">It cannot be made.</exception>
    public void MakeFolder(string name) => Try(() => Make(Path.Combine(Root, name)));

    /// <summary>Gives all files their names; at the end of the command where that holds folders back.</summary>
    /// <exception cref="UserException">One cannot be renamed.</exception>
    public void Commit()
    {
        m_Held = HeldFolders.TryHold(this);
        if (!m_Held)
            Rename();
    }

    /// <summary>Gives all files their names now.</summary>
    /// <exception cref="UserException">One cannot be renamed.</exception>
    internal void Rename()
    {
        m_Held = false;
        lock (Interruption.Files)
        {
            Try(() =>
            {
                foreach ((string written, string final) in m_Files)
                    File.Move(written, final, overwrite: true);
            });
            m_Committed = true;
        }
    }

    /// <summary>Removes what was not committed.</summary>
    public void Dispose()
    {
        if (!m_Held)
            Remove();
    }

    /// <summary>Removes what was not renamed.</summary>
    internal void Remove()
    {
        lock (Interruption.Files)
        {
            Interruption.Remove(this);
            if (m_Committed)
                return;
            foreach ((string written, _) in m_Files)
                Quietly(() => File.Delete(written));
            for (int k = m_MadeFolders.Count - 1; k >= 0; k--)
            {
                string made = m_MadeFolders[k];
                Quietly(() => Directory.Delete(made));
            }
        }
    }

    // A file that is still open can be deleted.
    private FileStream Open(string final)
    {
        lock (Interruption.Files)
        {
            MakeAll(Path.GetDirectoryName(final));
            Sweep(Path.GetDirectoryName(final));
            m_Files.Add((final + m_Suffix, final));
            return new FileStream(final + m_Suffix, FileMode.Create, FileAccess.Write, FileShare.Read | FileShare.Delete);
        }
    }

    private void Sweep(string folder)
    {
        if (m_Swept.Add(folder))
            UnfinishedFiles.Sweep(folder);
    }

    private void Make(string folder)
    {
        lock (Interruption.Files)
            MakeAll(folder);
    }

    private void MakeAll(string folder)
    {
        if (Directory.Exists(folder))
            return;
        if (File.Exists(folder))
            throw new IOException($"{folder} is a file, not a folder.");
        string parent = Path.GetDirectoryName(folder);
        if (!string.IsNullOrEmpty(parent))
            MakeAll(parent);
        Directory.CreateDirectory(folder);
        m_MadeFolders.Add(folder);
    }

    private void Try(Action action)
    {
        try
        {
            action();
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            throw new UserException($"Cannot write {m_What}: {FileProblem.Reason(problem)}");
        }
    }

    private static void Quietly(Action action)
    {
        try
        {
            action();
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            // What cannot be removed stays; the user has been told the first problem.
        }
    }
}
