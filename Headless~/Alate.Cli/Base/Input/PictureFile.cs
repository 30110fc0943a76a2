using Alate.Authoring;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A PNG or JPEG file that a user names, turned as its EXIF says.</summary>
internal sealed class PictureFile
{
    private static readonly (string Format, int Offset, byte[] Start)[] s_OtherFormats =
    [
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

    /// <summary>The picture as a PNG file: that of the user, where it is one and upright.</summary>
    public byte[] Bytes { get; }

    public WingPicture Picture { get; }

    /// <summary>Reads a file.</summary>
    /// <exception cref="UserException">There is no such file, it cannot be read, or it is no picture of a fit size.</exception>
    public static PictureFile Read(string path) => Of(path, () => ReadAll(path));

    /// <summary>Reads a picture that lies within another file.</summary>
    /// <param name="path">That file, for messages.</param>
    /// <param name="bytes">The picture.</param>
    /// <exception cref="UserException">It is no picture of a fit size.</exception>
    public static PictureFile Within(string path, byte[] bytes) => Of(path, () => bytes);

    private static PictureFile Of(string path, Func<byte[]> read)
    {
        try
        {
            byte[] bytes = read();
            if (OtherFormat(bytes) is string format)
                throw new UserException($"Cannot read '{path}': it is a {format}; convert it to PNG or JPEG.");
            return bytes.AsSpan().StartsWith(JpegFile.Start) ? OfJpeg(path, bytes) : OfPng(path, bytes);
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

    private static PictureFile OfJpeg(string path, byte[] bytes)
    {
        JpegFile jpeg = Decode(path, () => JpegFile.Read(bytes, WingPicture.MaxSide));
        int width = jpeg.Width, height = jpeg.Height;
        Color32[] pixels = ExifTurn.Upright(ExifTurn.Of(jpeg.Exif.Span), ref width, ref height, jpeg.Pixels);
        return new PictureFile(path, Png(width, height, pixels), new WingPicture(width, height, pixels));
    }

    private static PictureFile OfPng(string path, byte[] bytes)
    {
        PngFile png = Decode(path, () => PngFile.Read(bytes));
        int width = png.Width, height = png.Height;
        Color32[] pixels = ExifTurn.Upright(ExifTurn.Of(ExifTurn.InPng(bytes)), ref width, ref height, png.Pixels);
        return new PictureFile(
            path, pixels == png.Pixels ? bytes : Png(width, height, pixels), new WingPicture(width, height, pixels));
    }

    /// <summary>PNG file of a picture, whose rows begin with the highest.</summary>
    public static byte[] Png(int width, int height, Color32[] pixels)
    {
        var upwards = new Color32[pixels.Length];
        for (int row = 0; row < height; row++)
            Array.Copy(pixels, row * width, upwards, (height - 1 - row) * width, width);
        var texture = new Texture2D(width, height);
        texture.SetPixels32(upwards);
        byte[] png = texture.EncodeToPNG();
        UnityEngine.Object.DestroyImmediate(texture);
        return png;
    }

    private static T Decode<T>(string path, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (FormatException problem)
        {
            throw new UserException($"Cannot read '{path}': {problem.Message}");
        }
    }
}
