using System.Diagnostics;
using System.IO;
using System.Text;
using System.Threading;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>A run that the user stops, as a process of its own.</summary>
    public sealed class InterruptionTests
    {
        private const int k_Patience = 60000;

        private TemporaryFolder m_Folder;

        [SetUp]
        public void MakeFolder() => m_Folder = new TemporaryFolder();

        [TearDown]
        public void RemoveFolder() => m_Folder.Dispose();

        [TestCase("INT", 130)]
        [TestCase("TERM", 143, Explicit = true, Category = "Long")]
        public void StoppedRun_LeavesNoFile_NoFolder_AndItsExitCode(string signal, int expected)
        {
            NeedsFile("/bin/kill", "/usr/bin/kill");
            using Process process = Start(
                "/bin/sh", "-c", $"exec {CommandProcess.Program} gallery --width 3000 --out '{m_Folder.PathOf("a/b")}'");
            WaitFor(() => Directory.Exists(m_Folder.PathOf("a/b")));

            using (Process kill = Start("/bin/sh", "-c", $"kill -{signal} {process.Id}"))
                kill.WaitForExit();

            Assert.That(process.WaitForExit(k_Patience), "it ends");
            Assert.That(process.ExitCode, Is.EqualTo(expected));
            Assert.That(m_Folder.Content, Is.Empty);
        }

        [Test]
        public void StoppedRun_KeepsTheFilesOfBefore()
        {
            NeedsFile("/bin/kill", "/usr/bin/kill");
            string file = m_Folder.File("insects.png", "before");
            using Process process = Start("/bin/sh", "-c", $"exec {CommandProcess.Program} gallery --width 3000 --out '{m_Folder.Root}'");
            WaitFor(() => m_Folder.Content.Length > 1);

            using (Process kill = Start("/bin/sh", "-c", $"kill -INT {process.Id}"))
                kill.WaitForExit();

            Assert.That(process.WaitForExit(k_Patience), "it ends");
            Assert.That(m_Folder.Content, Is.EqualTo(new[] { "insects.png" }));
            Assert.That(File.ReadAllText(file), Is.EqualTo("before"));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void CtrlC_ShowsTheCursorAgain()
        {
            const string hide = "\u001b[?25l", show = "\u001b[?25h";
            NeedsFile("/usr/bin/script");
            string command = $"{CommandProcess.Program} fly monarch --seconds 900 --out '{m_Folder.PathOf("out")}'";
            using Process process = Start("/usr/bin/script", "-qec", command, "/dev/null");
            var output = new StringBuilder();
            process.OutputDataReceived += (_, line) => Append(output, line.Data);
            process.BeginOutputReadLine();
            WaitFor(() => Text(output).Contains(hide));

            process.StandardInput.Write('\u0003');
            process.StandardInput.Flush();

            Assert.That(process.WaitForExit(k_Patience), "it ends");
            process.WaitForExit();
            string text = Text(output);
            Assert.That(text.LastIndexOf(show, System.StringComparison.Ordinal),
                Is.GreaterThan(text.LastIndexOf(hide, System.StringComparison.Ordinal)), text);
            Assert.That(process.ExitCode, Is.EqualTo(130));
            Assert.That(m_Folder.Content, Is.Empty);
        }

        // In the background of a shell Ctrl-C is ignored by all that is started, so the signal's own meaning is set again where that can be
        // done.
        private static Process Start(string program, params string[] arguments)
        {
            bool resets = File.Exists("/usr/bin/env");
            var start = new ProcessStartInfo(resets ? "/usr/bin/env" : program)
            {
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                WorkingDirectory = Path.GetTempPath(),
            };
            start.Environment["TERM"] = "xterm-256color";
            foreach (string word in resets ? new[] { "--default-signal=INT", program } : [])
                start.ArgumentList.Add(word);
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            return Process.Start(start);
        }

        private static void NeedsFile(params string[] files)
        {
            if (!System.Array.Exists(files, File.Exists))
                Assert.Ignore($"There is no {files[0]} on this system.");
        }

        private static void WaitFor(System.Func<bool> condition)
        {
            var clock = Stopwatch.StartNew();
            while (!condition())
            {
                Assert.That(clock.ElapsedMilliseconds, Is.LessThan(k_Patience), "it begins");
                Thread.Sleep(5);
            }
        }

        private static void Append(StringBuilder text, string line)
        {
            lock (text)
                text.AppendLine(line);
        }

        private static string Text(StringBuilder text)
        {
            lock (text)
                return text.ToString();
        }
    }
}
