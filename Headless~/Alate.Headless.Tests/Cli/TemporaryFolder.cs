using System;
using System.IO;
using System.Linq;

namespace Alate.Tests.Cli
{
    /// <summary>An empty folder that goes with what is in it.</summary>
    internal sealed class TemporaryFolder : IDisposable
    {
        public TemporaryFolder()
        {
            Root = Path.Combine(Path.GetTempPath(), "alate-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Root);
        }

        public string Root { get; }

        /// <summary>All files and folders within it, paths from the folder on, in order.</summary>
        public string[] Content =>
            Directory.EnumerateFileSystemEntries(Root, "*", SearchOption.AllDirectories)
                .Select(path => Path.GetRelativePath(Root, path).Replace('\\', '/'))
                .OrderBy(path => path, StringComparer.Ordinal)
                .ToArray();

        public string PathOf(string name) => Path.Combine(Root, name);

        /// <summary>Writes a file and tells its path.</summary>
        public string File(string name, string text)
        {
            System.IO.File.WriteAllText(PathOf(name), text);
            return PathOf(name);
        }

        public void Dispose() => Directory.Delete(Root, true);
    }
}
