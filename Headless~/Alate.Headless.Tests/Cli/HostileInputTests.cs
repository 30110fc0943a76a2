using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Files that are none, values without end, options without values: one line, exit code 2, and nothing is left.</summary>
    public sealed class HostileInputTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [TestCase("pipe")]
        [TestCase("/dev/zero")]
        [TestCase("link")]
        [TestCase("empty")]
        [TestCase("")]
        [TestCase("huge")]
        public void WhatIsNoFileToRead_IsRefused_ByEveryReader(string kind)
        {
            string file = Make(kind), obj = m_Run.Write("wing.obj", OwnWing.Obj()), json = m_Run.Write("wing.json", OwnWing.Skeleton());
            string painted = "vt 0 0\n" + Regex.Replace(OwnWing.Obj(), "^f (.*) (.*) (.*)$", "f $1/1 $2/1 $3/1", RegexOptions.Multiline);
            string library = m_Run.Write("library.obj", $"mtllib {file}\n{painted}"), plain = m_Run.Write("plain.obj", painted);
            string said = kind == "huge" ? "is larger than" : kind == "" ? "needs a name" : "is empty, or no regular file";
            string[] own = ["fly", "--species", "monarch", "--out", m_Run.Out];
            AssertRefused([said], [.. own, "--mesh", file, "--skeleton", json]);
            AssertRefused([said], [.. own, "--mesh", obj, "--skeleton", file]);
            AssertRefused([said], [.. own, "--mesh", plain, "--skeleton", json, "--texture", file]);
            if (kind != "")
                AssertRefused([said], [.. own, "--mesh", library, "--skeleton", json]);
            AssertRefused([said], "fly", "monarch", "--kinematics", file, "--out", m_Run.Out);
            AssertRefused([said], "fly", "monarch", "--free", "--points", file, "--out", m_Run.Out);
            AssertRefused([said], "skeleton", "fit", file, "--out", Path.Combine(m_Run.Out, "fit.json"));
            AssertRefused([said], "skeleton", "from-image", file, "--out", m_Run.Out);
        }

        [Test]
        public void AMeshOfManyLinesThatGoOn_IsReadInTime()
        {
            string mesh = m_Run.Write("long.obj", string.Concat(Enumerable.Repeat("v \\\n", 300000)));
            AssertRefused(["long.obj"], "skeleton", "fit", mesh, "--out", Path.Combine(m_Run.Out, "fit.json"));
        }

        [TestCase("fly", "LONG")]
        [TestCase("fly", "monarch", "LONG")]
        [TestCase("LONG")]
        [TestCase("--LONG")]
        [TestCase("fly", "monarch", "--speed", "LONG")]
        [TestCase("fly", "monarch", "--substeps", "LONG")]
        [TestCase("fly", "monarch", "--wind", "LONG")]
        [TestCase("fly", "monarch", "--elements", "LONG")]
        [TestCase("fly", "monarch", "--preset", "LONG")]
        [TestCase("fly", "monarch", "--view", "LONG")]
        [TestCase("fly", "monarch", "--LONG")]
        [TestCase("fly", "monarch", "--free", "--pilot", "LONG")]
        [TestCase("fly", "monarch", "--free", "--to", "LONG")]
        [TestCase("sweep", "LONG", "0", "1")]
        [TestCase("sweep", "elasticity", "LONG", "1")]
        [TestCase("species", "LONG")]
        [TestCase("compare", "monarch", "LONG")]
        [TestCase("bake", "LONG")]
        [TestCase("trim", "monarch", "--speeds", "LONG")]
        public void AWrongValue_IsQuotedUpToSixtyCharacters(params string[] words)
        {
            string value = "x" + new string('ß', 5000);
            string[] arguments = words.Select(word => word.Replace("LONG", value)).ToArray();
            int code = m_Run.Run(arguments);
            Assert.That(code, Is.EqualTo(2));
            Assert.That(m_Run.Errors.Count(letter => letter == 'ß'), Is.LessThanOrEqualTo(60).And.GreaterThan(50), m_Run.Errors);
            Assert.That(m_Run.Errors, Does.Contain("ß…").And.Not.Contain("\n\n"));
        }

        [Test]
        public void WordsOfFiles_AreQuotedUpToSixtyCharacters()
        {
            string value = new string('y', 100000);
            AssertShort("fly", "monarch", "--free", "--points", m_Run.Write("a.csv", value), "--out", m_Run.Out);
            AssertShort("skeleton", "fit", m_Run.Write("a.obj", "v 0 0 " + value), "--out", Path.Combine(m_Run.Out, "fit.json"));
            string json = m_Run.Write("a.json", OwnWing.Skeleton().Replace("\"chains\"", $"\"{value}\""));
            AssertShort(
                "fly", "--mesh", m_Run.Write("b.obj", OwnWing.Obj()), "--skeleton", json, "--species", "monarch", "--out", m_Run.Out);
            AssertShort("fly", "monarch", "--kinematics", m_Run.Write("b.json", $"{{\"{value}\": 1}}"), "--out", m_Run.Out);
        }

        [TestCase("--speed", "fly", "monarch", "--speed", "--climb", "1")]
        [TestCase("--climb", "fly", "monarch", "--climb", "--no-wave")]
        [TestCase("--pilot", "fly", "monarch", "--free", "--pilot", "--aid", "1")]
        [TestCase("--out", "fly", "monarch", "--out", "--speed", "1")]
        [TestCase("--preset", "fly", "monarch", "--preset", "--rigid")]
        [TestCase("--out", "fly", "monarch", "--seconds", "0.2", "--out", "--rigid")]
        [TestCase("--kinematics", "fly", "monarch", "--kinematics", "--nothing")]
        [TestCase("--speed", "fly", "monarch", "--speed")]
        [TestCase("--json", "species", "--json", "--help")]
        public void AMissingValue_IsBlamedOnItsOption(string option, params string[] words)
        {
            int code = m_Run.Run(words);
            if (words[^1] == "--help" && code == 0)
                return;
            Assert.That((code, m_Run.Errors.Split('\n').Length), Is.EqualTo((2, 2)), m_Run.Errors);
            Assert.That(m_Run.Errors, Does.Match($"^alate: ({option} needs a value|Required argument missing for option: '{option}')"));
        }

        [TestCase("'fly' has no option '--sped'. Did you mean '--speed'?", "fly", "monarch", "--sped", "1")]
        [TestCase("'view' has no option '--no-open'.", "view", "--no-open")]
        [TestCase("There is no scene 'desert'. There are: comparison, garden,", "view", "--scene", "desert")]
        [TestCase("A scene has its own insects", "view", "monarch", "--scene", "garden")]
        [TestCase("A scene has its own insects", "view", "--scene", "garden", "--variant", "flight")]
        [TestCase("'--speed' stands in a wrong place", "fly", "monarch", "--", "--speed")]
        [TestCase("'fly' stands in a wrong place", "--", "fly", "monarch")]
        [TestCase("Unknown species '@more.txt'", "fly", "@more.txt")]
        [TestCase("Unknown command '@/dev/zero'", "@/dev/zero")]
        [TestCase("Cannot write into ' '", "fly", "monarch", "--seconds", "0.2", "--out", " ")]
        [TestCase("a file needs a name", "species", "--json", "")]
        [TestCase("a file needs a name", "bench", "--json", " ")]
        public void WordsThatMeanNothing_AreRefused(string said, params string[] words) => AssertRefused([said], words);

        [TestCase("--points", "nowhere.csv")]
        [TestCase("--to", "0,0,1")]
        [TestCase("--seed", "3")]
        public void APilotThatIsNone_IsBlamedOnItsName(string option, string value) =>
            AssertRefused(
                ["--pilot", "'hawk'", "wander"], "fly", "monarch", "--free", "--pilot", "hawk", option, value, "--out", m_Run.Out);

        [TestCase("species", ">&-", Explicit = true, Category = "Long")]
        [TestCase("--help", ">&-", Explicit = true, Category = "Long")]
        [TestCase("fly monarch --seconds 0.2 --no-pictures --out OUT", ">&-", Explicit = true, Category = "Long")]
        [TestCase("fly monarch --seconds 0.2 --no-pictures --out OUT", ">/dev/full", Explicit = true, Category = "Long")]
        [TestCase("species", ">/dev/full")]
        [TestCase("species --json OUT.json", ">/dev/full", Explicit = true, Category = "Long")]
        public void AnOutputThatTakesNothing_LeavesNothing(string words, string output)
        {
            if (!File.Exists("/dev/full"))
                Assert.Ignore("There is no /dev/full on this system.");
            string[] before = Directory.GetFileSystemEntries(m_Run.Folder);
            (int code, string errors) = CommandProcess.Shell(words.Replace("OUT", m_Run.Out) + " " + output);
            Assert.That(code, Is.EqualTo(2), errors);
            Assert.That(errors, Does.StartWith("alate: Cannot write to the standard output: "));
            Assert.That(errors.Split('\n'), Has.Length.EqualTo(2), errors);
            Assert.That(Directory.GetFileSystemEntries(m_Run.Folder), Is.EqualTo(before));
        }

        [Test]
        public void WhatAKilledRunHasLeft_GoesWithTheNextOne_AndNothingElse()
        {
            using var dead = Process.Start("/bin/true");
            dead.WaitForExit();
            using var alive = Process.Start("/bin/sleep", "60");
            string ours = UnfinishedFiles.Suffix(998), left = OfProcess(dead.Id);
            string[] kept = [m_Run.Write("mine.part", "mine"), m_Run.Write("strip.png" + ours, "ours"),
                m_Run.Write("strip.png" + OfProcess(alive.Id), "another's")];
            m_Run.Write("strip.png" + left, "half");

            Assert.That(m_Run.Run("species", "--json", Path.Combine(m_Run.Folder, "species.json")), Is.Zero, m_Run.Errors);
            alive.Kill();
            Assert.That(Directory.GetFiles(m_Run.Folder, "*.part"), Is.EquivalentTo(kept));

            static string OfProcess(int id) => UnfinishedFiles.Suffix(999).Replace($"-{Environment.ProcessId}-", $"-{id}-");
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void ALinkInTheWorkingFolder_LeadsWhereItLeads()
        {
            Ignore();
            m_Run.Write("wing.obj", OwnWing.Obj());
            m_Run.Write("old.json", "old");
            File.CreateSymbolicLink(Path.Combine(m_Run.Folder, "link.obj"), "wing.obj");
            File.CreateSymbolicLink(Path.Combine(m_Run.Folder, "link.json"), "old.json");
            string fit = $"{CommandProcess.Program} skeleton fit link.obj --out fit",
                species = $"{CommandProcess.Program} species --json link.json";
            using var process = Process.Start(
                new ProcessStartInfo("/bin/sh", ["-c", $"cd '{m_Run.Folder}' && {fit} >/dev/null && {species} >/dev/null"]));
            process.WaitForExit();

            Assert.That(process.ExitCode, Is.Zero);
            Assert.That(Directory.GetFiles(Path.Combine(m_Run.Folder, "fit")), Is.Not.Empty);
            Assert.That(File.ReadAllText(Path.Combine(m_Run.Folder, "old.json")), Does.StartWith("{").Or.StartWith("["));
        }

        private string Make(string kind)
        {
            string path = Path.Combine(m_Run.Folder, kind.Length == 0 ? "none" : kind.TrimStart('/'));
            switch (kind)
            {
                case "empty":
                    return m_Run.Write("empty", "");
                case "":
                    return "";
                case "huge":
                    using (FileStream stream = File.Create(path))
                        stream.SetLength(2L << 30);
                    return path;
                case "link":
                    Ignore();
                    File.CreateSymbolicLink(path, "/dev/zero");
                    return path;
                case "pipe":
                    Ignore();
                    using (var made = Process.Start("mkfifo", path))
                        made.WaitForExit();
                    return path;
                default:
                    Ignore();
                    return kind;
            }
        }

        private static void Ignore()
        {
            if (!File.Exists("/dev/zero"))
                Assert.Ignore("There are no devices on this system.");
        }

        private void AssertShort(params string[] arguments)
        {
            AssertRefused([], arguments);
            Assert.That(m_Run.Errors.Split('\n')[^2].Replace(m_Run.Folder, ""), Has.Length.LessThan(400), "beside the folder");
        }

        private void AssertRefused(string[] said, params string[] arguments)
        {
            string[] before = Directory.GetFileSystemEntries(m_Run.Folder);
            int known = m_Run.Errors.Length;
            int code = m_Run.Run(arguments);
            string errors = m_Run.Errors[known..];
            Assert.That(code, Is.EqualTo(2), errors);
            Assert.That(errors.Split('\n'), Has.Length.EqualTo(2), errors);
            Assert.That(errors, Does.StartWith("alate: "));
            foreach (string part in said)
                Assert.That(errors, Does.Contain(part), string.Join(' ', arguments));
            Assert.That(Directory.GetFileSystemEntries(m_Run.Folder), Is.EquivalentTo(before), "nothing was written");
        }
    }
}
