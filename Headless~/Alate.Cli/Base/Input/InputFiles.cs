namespace Alate.Cli;

/// <summary>Reads the files of an insect as every other file that users name, and turns pictures as cameras say.</summary>
internal sealed class InputFiles : FileSource
{
    private InputFiles()
    {
    }

    /// <summary>The only one.</summary>
    public static InputFiles Instance { get; } = new();

    public override bool Contains(string path) => File.Exists(path);

    public override T ReadText<T>(string path, Func<TextReader, T> read) => TextFile.Read(path, read);

    public override T ReadMesh<T>(string path, Func<TextReader, T> read) => TextFile.Read(path, read, InputFile.Mesh);

    public override byte[] ReadPicture(string path) => PictureFile.Read(path).Bytes;
}
