using System.Threading;

namespace Alate.Cli;

/// <summary>
/// Finished folders of a command that has more to say: they get their files when it has said all, and none where its standard output takes
/// nothing.
/// </summary>
internal sealed class HeldFolders : IDisposable
{
    private static readonly AsyncLocal<HeldFolders> s_Current = new();

    private readonly List<OutputFolder> m_Folders = [];

    private HeldFolders()
    {
    }

    /// <summary>Holds back the folders that are committed from now on, in this flow of control.</summary>
    public static HeldFolders Begin() => s_Current.Value = new HeldFolders();

    /// <summary>Holds a folder that is finished back; false where nothing is held back.</summary>
    public static bool TryHold(OutputFolder folder)
    {
        HeldFolders held = s_Current.Value;
        if (held == null)
            return false;
        lock (Interruption.Files)
            held.m_Folders.Add(folder);
        return true;
    }

    /// <summary>Gives all files their names.</summary>
    /// <exception cref="UserException">One cannot be renamed.</exception>
    public void Commit()
    {
        foreach (OutputFolder folder in m_Folders)
            folder.Rename();
    }

    /// <summary>Removes what was not committed.</summary>
    public void Dispose()
    {
        s_Current.Value = null;
        foreach (OutputFolder folder in m_Folders)
            folder.Remove();
    }
}
