using System;
using System.IO;

namespace Alate.Cli;

/// <summary>Describes the system's errors for files that cannot be written.</summary>
internal static class FileProblem
{
    /// <summary>Returns true where an exception is the system's answer about a file.</summary>
    public static bool Is(Exception problem) =>
        problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;

    /// <summary>The reason for the user. What some file systems say of a file that cannot be made is that it cannot be found.</summary>
    public static string Reason(Exception problem) => problem switch
    {
        FileNotFoundException or DirectoryNotFoundException => "no file can be made there.",
        ArgumentException => "that is no name of a folder.",
        _ => problem.Message,
    };
}
