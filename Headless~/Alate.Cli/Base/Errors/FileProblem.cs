namespace Alate.Cli;

/// <summary>Describes the system's errors for files that cannot be read or written.</summary>
internal static class FileProblem
{
    /// <summary>Returns true where an exception is the system's answer about a file; one of the program's own making is not.</summary>
    public static bool Is(Exception problem) => problem is IOException or UnauthorizedAccessException;

    /// <summary>The reason for the user. What some file systems say of a file that cannot be made is that it cannot be found.</summary>
    public static string Reason(Exception problem) =>
        problem is FileNotFoundException or DirectoryNotFoundException ? "no file can be made there." : problem.Message;

    /// <summary>Returns true for a name that no system takes, which is found before the system is asked.</summary>
    public static bool IsNoName(string path) => string.IsNullOrWhiteSpace(path) || path.Contains('\0');
}
