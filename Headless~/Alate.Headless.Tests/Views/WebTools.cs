using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Threading.Tasks;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Views
{
    /// <summary>
    /// Programs that tests of web pages and 3D files need: Chromium (Debian: chromium), Node and what Headless~/Web/package.json names.
    /// </summary>
    internal static class WebTools
    {
        private const int k_Seconds = 120;

        public const string Chromium = "/usr/bin/chromium";

        /// <summary>Chromium's options for WebGL 2 without a screen or a graphics card.</summary>
        public static readonly string[] Options = { "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader" };

        /// <summary>Folder of the scripts.</summary>
        public static string Folder => Path.Combine(PackageRoot.Find(), "Headless~", "Web");

        /// <summary>The package three of npm.</summary>
        public static string Three => Path.Combine(Folder, "node_modules", "three");

        /// <summary>Skips the test where Chromium is missing.</summary>
        public static void NeedChromium()
        {
            if (!File.Exists(Chromium))
                Assert.Ignore("chromium is not installed.");
        }

        /// <summary>Skips the test where the packages of npm are missing.</summary>
        public static void NeedThree()
        {
            if (!Directory.Exists(Three))
                Assert.Ignore("The packages of Headless~/Web are not installed (npm ci).");
        }

        /// <summary>Skips the test where Node or its packages are missing.</summary>
        public static void NeedNode()
        {
            NeedThree();
            NeedPlainNode();
        }

        /// <summary>Skips the test where Node is missing.</summary>
        public static void NeedPlainNode()
        {
            string path = Environment.GetEnvironmentVariable("PATH") ?? "";
            if (!path.Split(Path.PathSeparator)
                .Any(folder => File.Exists(Path.Combine(folder, "node")) || File.Exists(Path.Combine(folder, "node.exe"))))
            {
                Assert.Ignore("node is not installed.");
            }
        }

        /// <summary>Opens a page in Chromium and reads what it writes into its element "result".</summary>
        /// <param name="page">Path of the page.</param>
        /// <param name="folder">Folder for what the browser keeps.</param>
        public static JsonElement Show(string page, string folder)
        {
            var start = new ProcessStartInfo(Chromium) { RedirectStandardOutput = true, RedirectStandardError = true };
            string[] arguments =
            {
                "--user-data-dir=" + Path.Combine(folder, "profile"),
                "--virtual-time-budget=20000", "--dump-dom", "file://" + page,
            };
            foreach (string argument in Options.Concat(arguments))
                start.ArgumentList.Add(argument);

            using var browser = Process.Start(start);
            browser.ErrorDataReceived += (_, _) => { };
            browser.BeginErrorReadLine();
            string shown = browser.StandardOutput.ReadToEnd();
            Assert.That(browser.WaitForExit(1000 * k_Seconds), Is.True);
            Match result = Regex.Match(shown, "<pre id=\"result\">(.*?)</pre>", RegexOptions.Singleline);
            Assert.That(result.Success, Is.True, shown.Length > 500 ? shown[..500] : shown);
            return JsonDocument.Parse(result.Groups[1].Value).RootElement;
        }

        /// <summary>Runs a script of the folder.</summary>
        /// <returns>The exit code and what it printed.</returns>
        public static async Task<(int Code, string Output)> Run(string script, params string[] arguments)
        {
            var start =
                new ProcessStartInfo("node") { RedirectStandardOutput = true, RedirectStandardError = true, WorkingDirectory = Folder };
            foreach (string argument in arguments.Prepend(script))
                start.ArgumentList.Add(argument);
            using var process = Process.Start(start);
            Task<string> output = process.StandardOutput.ReadToEndAsync(), errors = process.StandardError.ReadToEndAsync();
            await process.WaitForExitAsync();
            return (process.ExitCode, await output + await errors);
        }
    }
}
