using System;
using System.IO;
using System.Linq;
using Alate.Cli;

namespace Alate.Tests.Cli
{
    /// <summary>A run of the command line within this process, in a folder of its own that is removed afterwards.</summary>
    internal sealed class CommandRun : IDisposable
    {
        private readonly StringWriter m_Output = new StringWriter(), m_Errors = new StringWriter();

        public CommandRun()
        {
            Folder = Path.Combine(Path.GetTempPath(), "alate-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Folder);
        }

        /// <summary>Folder for the test's files.</summary>
        public string Folder { get; }

        /// <summary>Folder into which the tests let commands write; missing before.</summary>
        public string Out => Path.Combine(Folder, "out");

        public string Output => m_Output.ToString();

        public string Errors => m_Errors.ToString();

        /// <summary>Runs a command; every SVG page that it leaves in <see cref="Out"/> holds what is drawn on it.</summary>
        /// <returns>The exit code.</returns>
        public int Run(params string[] arguments)
        {
            int code = Program.Run(arguments, m_Output, m_Errors);
            if (code == 0 && Directory.Exists(Out))
            {
                foreach (string page in Directory.EnumerateFiles(Out, "*.svg").Where(page => Path.GetFileName(page) != "icon.svg"))
                    SvgBounds.AssertAllIsOnThePage(page);
            }

            return code;
        }

        /// <summary>Writes a file into the folder.</summary>
        /// <returns>Its path.</returns>
        public string Write(string name, string content)
        {
            string path = Path.Combine(Folder, name);
            File.WriteAllText(path, content);
            return path;
        }

        public void Dispose() => Directory.Delete(Folder, true);
    }
}
