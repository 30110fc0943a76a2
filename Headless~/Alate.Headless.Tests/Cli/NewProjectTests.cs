using System.IO;
using System.Linq;
using System.Text.Json;
using Alate.Cli;
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
        public void AProject_IsFourFiles_EachWithWhatUnityAndGitNeed()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("new-project", run.Out), Is.Zero, run.Errors);
            string Text(params string[] path) => File.ReadAllText(Path.Combine([run.Out, .. path]));
            string package = PackageRoot.Find();
            JsonElement manifest = JsonDocument.Parse(Text("Packages", "manifest.json")).RootElement,
                own = JsonDocument.Parse(File.ReadAllText(Path.Combine(package, "Packages", "manifest.json"))).RootElement;

            Assert.That(Directory.GetFiles(run.Out, "*",
                SearchOption.AllDirectories).Select(file => Path.GetRelativePath(run.Out, file).Replace('\\', '/')),
                Is.EquivalentTo(new[] { "Packages/manifest.json", "ProjectSettings/ProjectVersion.txt", "Assets/README.md",
                    ".gitignore" }));
            foreach (JsonProperty dependency in manifest.GetProperty("dependencies").EnumerateObject())
            {
                string expected = dependency.Name == "com.alate.insect-wings"
                    ? "file:" + package.Replace('\\', '/') : own.GetProperty("dependencies").GetProperty(dependency.Name).GetString();
                Assert.That(dependency.Value.GetString(), Is.EqualTo(expected), dependency.Name);
            }

            Assert.That(manifest.GetProperty("dependencies").EnumerateObject().Count(),
                Is.EqualTo(own.GetProperty("dependencies").EnumerateObject().Count()));
            Assert.That(Text("Packages", "manifest.json"), Does.EndWith("}\n").And.Contain("\n  \"dependencies\""), "indented");
            Assert.That(Text("ProjectSettings", "ProjectVersion.txt"), Is.EqualTo($"m_EditorVersion: {UnityProject.UnityVersion}\n"));
            foreach (string made in new[] { "Library/", "Temp/", "Logs/", "UserSettings/", "obj/" })
                Assert.That(Text(".gitignore").Split('\n'), Does.Contain(made));
            Assert.That(Text("Assets", "README.md"), Does.StartWith("# Assets\n").And.Contain("GameObject > Alate"));
            Assert.That(run.Output.ReplaceLineEndings("\n"), Is.EqualTo($"Made a Unity project in {Path.GetFullPath(run.Out)}.\n"
                + $"Open it with Unity {UnityProject.UnityVersion} or newer; the tests are in Window > General > Test Runner.\n"));
        }

        [Test]
        public void AFileInThePlaceOfTheFolder_IsNamed_AndAnEmptyFolderIsTaken()
        {
            using var run = new CommandRun();
            string file = run.Write("taken", "text");

            Assert.That(run.Run("new-project", file), Is.EqualTo(2));
            Assert.That(run.Errors.Trim(), Is.EqualTo($"alate: '{file}' is a file; name a new or empty folder."));
            Assert.That(File.ReadAllText(file), Is.EqualTo("text"));
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
