namespace Alate.Cli;

/// <summary>Reads text files that users name.</summary>
internal static class TextFile
{
    /// <summary>Opens a file and reads it.</summary>
    /// <param name="path">Its path.</param>
    /// <param name="read">Reads the text.</param>
    /// <param name="most">Largest size, bytes.</param>
    /// <exception cref="UserException">There is no such file, it cannot be read, or the reader found a
    /// <see cref="FormatException"/>.</exception>
    public static T Read<T>(string path, Func<TextReader, T> read, long most = InputFile.Text)
    {
        try
        {
            using var reader = new StreamReader(InputFile.Open(path, most), new UTF8Encoding(false, true));
            return read(reader);
        }
        catch (DecoderFallbackException)
        {
            throw new UserException($"Cannot read '{path}': it is not a text file in UTF-8.");
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
}
