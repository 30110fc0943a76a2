using System.IO;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using OwnWing = Alate.Tests.Cli.OwnWing;

namespace Alate.Tests.Files
{
    /// <summary>Insect files as the editor reads them.</summary>
    public sealed class DiskFilesTests
    {
        private string m_Folder;

        [SetUp]
        public void MakeAFolder() => m_Folder = Directory.CreateTempSubdirectory("alate-files-").FullName;

        [TearDown]
        public void RemoveIt() => Directory.Delete(m_Folder, true);

        [Test]
        public void AnInsect_IsThatOfTheCommandLine()
        {
            Write("wing.obj", OwnWing.Obj());
            Write("wing.json", OwnWing.Skeleton());
            string file = Write("own.insect.json", """
                { "version": 1, "name": "own", "like": "firefly", "massMilligrams": 12.5,
                  "wings": { "fore wing": { "mesh": "wing.obj", "skeleton": "wing.json", "lengthMillimetres": 14 } } }
                """);

            InsectDefinition here = InsectFile.Read(file), there = InsectFile.Read(file, InputFiles.Instance);

            Assert.That(InsectFileText.Write(here), Is.EqualTo(InsectFileText.Write(there)));
            Assert.That(here.Wings[0].CreateSurface(WingSide.Right).positions,
                Is.EqualTo(there.Wings[0].CreateSurface(WingSide.Right).positions));
        }

        [TestCase("no.obj", null, "Cannot read '*': there is no such file.")]
        [TestCase("no.obj", "", "Cannot read '*': it is empty.")]
        [TestCase("no.obj", "v 1\n", "*: line 1: 'v' has 1 numbers, not three.")]
        public void WhatCannotBeRead_IsSaidInOneLineWithItsPath(string name, string content, string told)
        {
            string file = content == null ? Path.Combine(m_Folder, name) : Write(name, content);
            var files = new DiskFiles();

            Assert.That(Assert.Throws<UserException>(() => files.ReadMesh(file, ObjReader.Read)).Message,
                Is.EqualTo(told.Replace("*", file)));
            Assert.That(files.Paths, Is.EqualTo(new[] { file }));
        }

        [Test]
        public void WhatIsNoPictureOrNoText_IsRefused()
        {
            string file = Write("a.png", "GIF89a");
            byte[] jpeg = [0xFF, 0xD8, 0xFF, 0xE0, 1], latin = [(byte)'#', 0xE9];
            var files = new DiskFiles();

            Assert.That(Assert.Throws<UserException>(() => files.ReadPicture(file)).Message,
                Is.EqualTo($"Cannot read '{file}': it is neither a PNG nor a JPEG picture."));
            File.WriteAllBytes(file, jpeg);
            Assert.That(files.ReadPicture(file), Is.EqualTo(jpeg));
            File.WriteAllBytes(file, latin);
            Assert.That(Assert.Throws<UserException>(() => files.ReadText(file, text => text.ReadToEnd())).Message,
                Is.EqualTo($"Cannot read '{file}': it is not a text file in UTF-8."));
        }

        [Test]
        public void AFileThatIsTooLarge_IsNotRead()
        {
            string file = Path.Combine(m_Folder, "large.json");
            using (FileStream large = File.Create(file))
                large.SetLength((16L << 20) + 1);

            Assert.That(Assert.Throws<UserException>(() => InsectFile.Read(file)).Message,
                Is.EqualTo($"Cannot read '{file}': it is larger than 16 MiB."));
        }

        private string Write(string name, string content)
        {
            string file = Path.Combine(m_Folder, name);
            File.WriteAllText(file, content);
            return file;
        }
    }
}
