using System;
using System.IO;
using System.Text;
using Alate.Cli;
using Alate.Cli.Output;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>All files or none.</summary>
    public sealed class OutputFolderTests
    {
        [Test]
        public void UncommittedFolder_VanishesWithAllThatWasMade()
        {
            using var run = new CommandRun();
            using (OutputFolder folder = OutputFolder.Prepare(Path.Combine(run.Out, "a", "b")))
            {
                folder.Write("c/file", stream => stream.WriteByte(1));
                Assert.That(Directory.Exists(run.Out));
            }

            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void FailureInTheMiddle_LeavesTheOldFiles()
        {
            using var run = new CommandRun();
            Directory.CreateDirectory(run.Out);
            File.WriteAllText(Path.Combine(run.Out, "one"), "old");

            Assert.Throws<UserException>(() =>
            {
                using OutputFolder folder = OutputFolder.Prepare(run.Out);
                folder.Write("one", stream => stream.Write(Encoding.UTF8.GetBytes("new")));
                folder.Write("two", stream => throw new IOException("no space left"));
                folder.Commit();
            });

            Assert.That(Directory.GetFileSystemEntries(run.Out), Has.Length.EqualTo(1));
            Assert.That(File.ReadAllText(Path.Combine(run.Out, "one")), Is.EqualTo("old"));
        }

        [Test]
        public void CommittedFiles_HaveTheirNames()
        {
            using var run = new CommandRun();
            using (OutputFolder folder = OutputFolder.Prepare(run.Out))
            {
                folder.Write("one", stream => stream.WriteByte((byte)'1'));
                Assert.That(File.Exists(Path.Combine(run.Out, "one")), Is.False);
                folder.Commit();
            }

            Assert.That(File.ReadAllText(Path.Combine(run.Out, "one")), Is.EqualTo("1"));
        }
    }
}
