using System.Diagnostics;
using System.IO;
using Alate.Cli;

namespace Alate.Tests.Cli
{
    /// <summary>The command line as a process of its own.</summary>
    internal static class CommandProcess
    {
        /// <summary>Command by which a shell starts the program.</summary>
        public static string Program => $"dotnet '{typeof(KnownSpecies).Assembly.Location}'";

        /// <summary>Runs the program in a shell with these words behind its name.</summary>
        /// <returns>The exit code and what came out on the standard error.</returns>
        public static (int Code, string Errors) Shell(string words)
        {
            using var process = Process.Start(new ProcessStartInfo("/bin/sh", ["-c", $"{Program} {words}"])
            {
                RedirectStandardError = true,
                RedirectStandardOutput = true,
                WorkingDirectory = Path.GetTempPath(),
            });
            process.OutputDataReceived += (_, _) => { };
            process.BeginOutputReadLine();
            string errors = process.StandardError.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, errors);
        }
    }
}
