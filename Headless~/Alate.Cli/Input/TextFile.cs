using System;
using System.IO;
using System.Text;

namespace Alate.Cli.Input;

/// <summary>Reads text files that users name.</summary>
internal static class TextFile
{
    /// <summary>Opens a file and reads it.</summary>
    /// <exception cref="UserException">There is no such file, it cannot be read, or the reader found a
    /// <see cref="FormatException"/>.</exception>
    public static T Read<T>(string path, Func<TextReader, T> read)
    {
        try
        {
            if (Directory.Exists(path))
                throw new UserException($"Cannot read '{path}': it is a folder.");
            if (!File.Exists(path))
                throw new UserException($"Cannot read '{path}': there is no such file.");
            using var reader = new StreamReader(path, new UTF8Encoding(false, true));
            return read(reader);
        }
        catch (DecoderFallbackException)
        {
            throw new UserException($"Cannot read '{path}': it is not a text file.");
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
}
