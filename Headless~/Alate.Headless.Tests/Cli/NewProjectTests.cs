using System.IO;
using System.Text.Json;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>The Unity project that hosts the package.</summary>
    public sealed class NewProjectTests
    {
        [Test]
        public void Project_HostsThisPackageWithItsTests([Values] bool folderExists)
        {
            using var run = new CommandRun();
            if (folderExists)
                Directory.CreateDirectory(run.Out);

            Assert.That(run.Run("new-project", run.Out), Is.Zero, run.Errors);

            JsonElement manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(run.Out, "Packages", "manifest.json"))).RootElement;
            string path = manifest.GetProperty("dependencies").GetProperty("com.alate.insect-wings").GetString();
            Assert.That(path, Does.StartWith("file:"));
            string package = Path.Combine(path.Substring("file:".Length), "package.json");
            Assert.That(File.ReadAllText(package), Does.Contain("\"com.alate.insect-wings\""));
            Assert.That(manifest.GetProperty("testables")[0].GetString(), Is.EqualTo("com.alate.insect-wings"));
            Assert.That(manifest.GetProperty("dependencies").TryGetProperty("com.unity.test-framework", out _), Is.True);
            string version = File.ReadAllText(Path.Combine(run.Out, "ProjectSettings", "ProjectVersion.txt"));
            Assert.That(version, Does.Match("^m_EditorVersion: 2022\\.3\\.\\d+f1\n$"));
            Assert.That(Directory.Exists(Path.Combine(run.Out, "Assets")));
            Assert.That(Directory.GetFiles(run.Out, "*.part", SearchOption.AllDirectories), Is.Empty);
        }

        [Test]
        public void FolderWithAFileInIt_IsLeftAlone()
        {
            using var run = new CommandRun();
            Directory.CreateDirectory(run.Out);
            File.WriteAllText(Path.Combine(run.Out, ".hidden"), "");

            Assert.That(run.Run("new-project", run.Out), Is.EqualTo(2));
            Assert.That(Directory.GetFileSystemEntries(run.Out), Has.Length.EqualTo(1));
            Assert.That(run.Errors, Does.Contain("not empty"));
        }
    }
}
