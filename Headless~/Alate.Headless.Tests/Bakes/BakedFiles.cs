using System;
using System.Collections.Generic;
using Alate.Tests.Cli;
using NUnit.Framework;

namespace Alate.Tests.Bakes
{
    /// <summary>Files that the command <c>bake</c> wrote, each once for all tests of a fixture.</summary>
    internal sealed class BakedFiles : IDisposable
    {
        private readonly Dictionary<string, string> m_Folders = new Dictionary<string, string>();
        private readonly TemporaryFolder m_Root = new TemporaryFolder();

        /// <summary>The folder that a command wrote into.</summary>
        /// <param name="arguments">Behind <c>bake</c>.</param>
        public string Folder(string arguments)
        {
            if (m_Folders.TryGetValue(arguments, out string folder))
                return folder;
            folder = m_Root.PathOf(m_Folders.Count.ToString());
            using var run = new CommandRun();
            Assert.That(run.Run([.. $"bake {arguments}".Split(' '), "--out", folder]), Is.Zero, run.Errors);
            m_Folders.Add(arguments, folder);
            return folder;
        }

        public void Dispose() => m_Root.Dispose();
    }
}
