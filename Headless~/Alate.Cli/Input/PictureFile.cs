using System;
using System.IO;
using Unity.StandIns;

namespace Alate.Cli.Input;

/// <summary>A PNG file that a user names.</summary>
internal sealed class PictureFile
{
    /// <summary>Longest file that is read, bytes.</summary>
    private const long k_Longest = 1L << 30;

    private PictureFile(string path, byte[] bytes, WingPicture picture)
    {
        Path = path;
        Bytes = bytes;
        Picture = picture;
    }

    public string Path { get; }

    /// <summary>The file as it is.</summary>
    public byte[] Bytes { get; }

    public WingPicture Picture { get; }

    /// <summary>Reads a file.</summary>
    /// <exception cref="UserException">There is no such file, it cannot be read, or it is no PNG picture of a fit size.</exception>
    public static PictureFile Read(string path)
    {
        try
        {
            if (Directory.Exists(path))
                throw new UserException($"Cannot read '{path}': it is a folder.");
            if (!File.Exists(path))
                throw new UserException($"Cannot read '{path}': there is no such file.");
            if (new FileInfo(path).Length > k_Longest)
                throw new UserException($"Cannot read '{path}': it is larger than a gibibyte.");
            byte[] bytes = File.ReadAllBytes(path);
            PngFile png = Decode(path, bytes);
            return new PictureFile(path, bytes, new WingPicture(png.Width, png.Height, png.Pixels));
        }
        catch (FormatException problem)
        {
            throw new UserException($"{path}: {problem.Message}");
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new UserException($"Cannot read '{path}': {problem.Message}");
        }
    }

    private static PngFile Decode(string path, byte[] bytes)
    {
        try
        {
            return PngFile.Read(bytes);
        }
        catch (FormatException problem)
        {
            throw new UserException($"Cannot read '{path}': {problem.Message}");
        }
    }
}
