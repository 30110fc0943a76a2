namespace Alate.Cli;

/// <summary>Files of an insect that is made many times: what follows from them alone is made once.</summary>
/// <param name="files">Reads them.</param>
internal sealed class KeptFiles(FileSource files) : FileSource
{
    private readonly Dictionary<object, object> m_Made = [];

    public override bool Contains(string path) => files.Contains(path);

    public override T ReadText<T>(string path, Func<TextReader, T> read) => files.ReadText(path, read);

    public override T ReadMesh<T>(string path, Func<TextReader, T> read) => files.ReadMesh(path, read);

    public override byte[] ReadPicture(string path) => files.ReadPicture(path);

    public override T Make<T>(object key, Func<T> make)
    {
        if (!m_Made.TryGetValue(key, out object made))
            m_Made[key] = made = make();
        return (T)made;
    }
}
