using Alate.Authoring;
using Unity.StandIns;

namespace Alate.Cli;

/// <summary>A PNG file that a user names.</summary>
internal sealed class PictureFile
{
    private static readonly (string Format, int Offset, byte[] Start)[] s_OtherFormats =
    [
        ("JPEG", 0, [0xFF, 0xD8, 0xFF]),
        ("GIF", 0, [.. "GIF8"u8]),
        ("BMP", 0, [.. "BM"u8]),
        ("TIFF", 0, [.. "II*\0"u8]),
        ("TIFF", 0, [.. "MM\0*"u8]),
        ("WebP", 8, [.. "WEBP"u8]),
        ("HEIF picture", 4, [.. "ftyp"u8]),
    ];

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
            byte[] bytes = ReadAll(path);
            if (OtherFormat(bytes) is string format)
                throw new UserException($"Cannot read '{path}': it is a {format}; convert it to PNG.");
            PngFile png = Decode(path, bytes);
            return new PictureFile(path, bytes, new WingPicture(png.Width, png.Height, png.Pixels));
        }
        catch (FormatException problem)
        {
            throw new UserException($"{path}: {problem.Message}");
        }
        catch (Exception problem) when (FileProblem.Is(problem))
        {
            throw new UserException($"Cannot read '{path}': {problem.Message}");
        }
    }

    private static byte[] ReadAll(string path)
    {
        using FileStream file = InputFile.Open(path, InputFile.Picture);
        byte[] bytes = new byte[file.Length];
        file.ReadExactly(bytes);
        return bytes;
    }

    // By its first bytes, whatever its name says; null for a PNG and for what is no picture at all.
    private static string OtherFormat(byte[] bytes)
    {
        foreach ((string format, int offset, byte[] start) in s_OtherFormats)
        {
            if (bytes.AsSpan(Math.Min(offset, bytes.Length)).StartsWith(start))
                return format;
        }

        return null;
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
