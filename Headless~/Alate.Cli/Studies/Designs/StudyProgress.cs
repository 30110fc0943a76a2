namespace Alate.Cli;

/// <summary>Number of runs that are done, as their files grow: each byte is read once.</summary>
/// <param name="folder">Folder of the study.</param>
internal sealed class StudyProgress(string folder)
{
    private readonly Dictionary<string, long> m_Read = [];
    private readonly byte[] m_Buffer = new byte[1 << 16];
    private int m_Lines;

    /// <summary>Rows that are whole by now, without the first line of each file.</summary>
    public int Count()
    {
        foreach (string file in StudyRows.Files(folder))
        {
            m_Read.TryGetValue(file, out long read);
            using var stream = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
            stream.Position = Math.Min(read, stream.Length);
            for (int count = stream.Read(m_Buffer); count > 0; count = stream.Read(m_Buffer))
                m_Lines += m_Buffer.AsSpan(0, count).Count((byte)'\n');
            m_Read[file] = stream.Position;
        }

        return Math.Max(0, m_Lines - m_Read.Values.Count(read => read > 0));
    }
}
