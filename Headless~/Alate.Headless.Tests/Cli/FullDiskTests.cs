using System;
using System.IO;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>A disk that is full: one line, exit code 2, nothing half written. <c>/dev/full</c> is such a disk.</summary>
    public sealed class FullDiskTests
    {
        private const string k_Full = "/dev/full";

        [SetUp]
        public void NeedsAFullDisk()
        {
            if (!File.Exists(k_Full))
                Assert.Ignore($"There is no {k_Full} on this system.");
        }

        [Test]
        public void SpeciesJson_OnAFullDisk_IsOneLine()
        {
            using var run = new CommandRun();

            int code = run.Run("species", "--json", k_Full);

            Assert.That(code, Is.EqualTo(2));
            Assert.That(run.Errors, Does.StartWith($"alate: Cannot write '{k_Full}': ").And.Contain("No space left"));
            Assert.That(run.Errors.Split('\n'), Has.Length.EqualTo(2), run.Errors);
            Assert.That(run.Output, Is.Empty);
        }

        [Test]
        public void BenchJson_OnAFullDisk_IsOneLine()
        {
            UserException problem = Assert.Throws<UserException>(() => BenchCommand.Run(k_Full, Measured));

            Assert.That(problem.Message, Does.StartWith($"Cannot write '{k_Full}': ").And.Contain("No space left").And.Not.Contain("\n"));
        }

        [Test]
        public void BenchJson_ThatCannotBe_IsRefusedBeforeTheMeasurements()
        {
            using var folder = new TemporaryFolder();

            Assert.Throws<UserException>(() => BenchCommand.Run(folder.Root, _ => throw new InvalidOperationException("measured")));
        }

        [Test]
        public void BenchJson_IsWritten_WithItsExitCode()
        {
            using var folder = new TemporaryFolder();

            Assert.That(BenchCommand.Run(folder.PathOf("bench.json"), Measured), Is.EqualTo(1));

            Assert.That(File.ReadAllText(folder.PathOf("bench.json")), Is.EqualTo("{}"));
            Assert.That(folder.Content, Is.EqualTo(new[] { "bench.json" }));
        }

        [Test]
        public void AFileThatIsNotFinished_StaysAsItWas()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("species.json", "before");

            Assert.Throws<IOException>(() => OutputFile.Write(file, stream =>
            {
                stream.WriteByte(1);
                throw new IOException("No space left on device");
            }));

            Assert.That(File.ReadAllText(file), Is.EqualTo("before"));
            Assert.That(folder.Content, Is.EqualTo(new[] { "species.json" }));
        }

        [Test]
        public void ALinkedFile_IsWrittenWhereItLies()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("species.json", "before");
            File.CreateSymbolicLink(folder.PathOf("link.json"), file);

            OutputFile.Write(folder.PathOf("link.json"), stream => stream.Write("after"u8));

            Assert.That(File.ReadAllText(file), Is.EqualTo("after"));
            Assert.That(new FileInfo(folder.PathOf("link.json")).LinkTarget, Is.Not.Null);
        }

        [Test]
        public void ALinkToADevice_IsWrittenTo_NotReplaced()
        {
            using var folder = new TemporaryFolder();
            File.CreateSymbolicLink(folder.PathOf("link.json"), k_Full);

            UserException problem = Assert.Throws<UserException>(
                () => OutputFile.Write(folder.PathOf("link.json"), stream => stream.Write("after"u8)));

            Assert.That(problem.Message, Does.Contain("No space left"));
            Assert.That(new FileInfo(folder.PathOf("link.json")).LinkTarget, Is.EqualTo(k_Full));
        }

        [Test]
        public void AFileInSharedMemory_IsAnOrdinaryOne()
        {
            if (!Directory.Exists("/dev/shm"))
                Assert.Ignore("There is no /dev/shm on this system.");
            string file = $"/dev/shm/alate-{Guid.NewGuid():N}.json";
            try
            {
                OutputFile.Write(file, stream => stream.Write("a long one"u8));
                OutputFile.Write(file, stream => stream.Write("short"u8));

                Assert.That(File.ReadAllText(file), Is.EqualTo("short"));
            }
            finally
            {
                File.Delete(file);
            }
        }

        [TestCase("species > /dev/full", Explicit = true, Category = "Long")]
        [TestCase("species monarch > /dev/full", Explicit = true, Category = "Long")]
        [TestCase("--help > /dev/full", Explicit = true, Category = "Long")]
        [TestCase("--version > /dev/full", Explicit = true, Category = "Long")]
        [TestCase("swim 2> /dev/full")]
        public void StandardOutputOnAFullDisk_IsOneLine(string command)
        {
            (int code, string errors) = CommandProcess.Shell(command);

            Assert.That(code, Is.EqualTo(2), errors);
            Assert.That(errors.Split('\n'), Has.Length.LessThanOrEqualTo(2), errors);
            if (!command.Contains("2>"))
                Assert.That(errors, Does.StartWith("alate: Cannot write to the standard output: No space left"));
        }

        private static int Measured(Stream stream)
        {
            stream.Write("{}"u8);
            return 1;
        }
    }
}
