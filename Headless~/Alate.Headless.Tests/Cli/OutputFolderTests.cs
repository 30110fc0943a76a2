using System.IO;
using System.Text;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    public sealed class OutputFolderTests
    {
        [Test]
        public void CommittedFiles_AreThere_InFoldersMadeForThem()
        {
            using var temporary = new TemporaryFolder();
            using (var folder = OutputFolder.Prepare(temporary.PathOf("a/b"), "one.txt"))
            {
                folder.Write("one.txt", Text("1"));
                folder.Write("deep/two.txt", Text("2"));
                folder.Commit();
            }

            Assert.That(temporary.Content, Is.EqualTo(new[] { "a", "a/b", "a/b/deep", "a/b/deep/two.txt", "a/b/one.txt" }));
            Assert.That(File.ReadAllText(temporary.PathOf("a/b/deep/two.txt")), Is.EqualTo("2"));
        }

        [Test]
        public void WithoutCommit_NothingIsLeft()
        {
            using var temporary = new TemporaryFolder();
            using (var folder = OutputFolder.Prepare(temporary.PathOf("a/b"), "one.txt"))
            {
                folder.Write("one.txt", Text("1"));
                folder.Write("deep/two.txt", Text("2"));
            }

            Assert.That(temporary.Content, Is.Empty);
        }

        [Test]
        public void AWriterThatFails_LeavesTheFilesOfBefore()
        {
            using var temporary = new TemporaryFolder();
            temporary.File("one.txt", "before");
            using (var folder = OutputFolder.Prepare(temporary.Root, "one.txt"))
            {
                folder.Write("one.txt", Text("after"));
                Assert.Throws<UserException>(() => folder.Write("two.txt", _ => throw new IOException("The disk is full.")));
            }

            Assert.That(temporary.Content, Is.EqualTo(new[] { "one.txt" }));
            Assert.That(File.ReadAllText(temporary.PathOf("one.txt")), Is.EqualTo("before"));
        }

        [Test]
        public void CommittedFiles_ReplaceThoseOfBefore()
        {
            using var temporary = new TemporaryFolder();
            temporary.File("one.txt", "a longer text from before");
            using (var folder = OutputFolder.Prepare(temporary.Root, "one.txt"))
            {
                folder.Write("one.txt", Text("after"));
                folder.Commit();
            }

            Assert.That(File.ReadAllText(temporary.PathOf("one.txt")), Is.EqualTo("after"));
        }

        [Test]
        public void AFileInPlaceOfTheFolder_IsRefusedInOneLine()
        {
            using var temporary = new TemporaryFolder();
            string file = temporary.File("taken", "");
            foreach (string path in new[] { file, Path.Combine(file, "below") })
            {
                UserException problem = Assert.Throws<UserException>(() => OutputFolder.Prepare(path, "one.txt"));
                Assert.That(problem.Message, Does.Contain(path).And.Not.Contain("\n"));
            }

            Assert.That(temporary.Content, Is.EqualTo(new[] { "taken" }));
        }

        [Test]
        public void AFolderInPlaceOfAFile_IsRefusedBeforeAnythingIsWritten()
        {
            using var temporary = new TemporaryFolder();
            Directory.CreateDirectory(temporary.PathOf("one.txt"));

            UserException problem = Assert.Throws<UserException>(() => OutputFolder.Prepare(temporary.Root, "one.txt"));
            Assert.That(problem.Message, Does.Contain("one.txt"));
        }

        private static System.Action<Stream> Text(string text) => stream => stream.Write(Encoding.UTF8.GetBytes(text));
    }
}
