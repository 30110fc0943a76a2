using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>
    /// The page <c>command-line.md</c> has every command and option of <c>--help</c>, with their defaults and ranges, and no others.
    /// </summary>
    public sealed class CommandLineManualTests
    {
        private static readonly string s_Page = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", "command-line.md"))
            .ReplaceLineEndings("\n").Replace('−', '-');

        private static readonly string[] s_Commands = Names("").SelectMany(WithThoseBelow).ToArray();

        [Test]
        public void EveryCommandOfTheHelp_HasItsPlaceOnThePage_AndNoOther()
        {
            string[] headings = Regex.Matches(s_Page, "^##+ (.+)$", RegexOptions.Multiline)
                .Select(heading => heading.Groups[1].Value).ToArray();

            Assert.That(headings, Is.EquivalentTo(s_Commands));
        }

        [TestCaseSource(nameof(s_Commands))]
        public void Options_AreThoseOfTheHelp_WithTheirDefaults(string command)
        {
            string[] page = Rows(command).Select(row => $"{row[0]} [{row[2]}]").ToArray();
            string[] help = Options(command).Select(option => $"{option.Name} [{option.Default}]").ToArray();

            Assert.That(page, Is.EquivalentTo(help));
        }

        [TestCaseSource(nameof(s_Commands))]
        public void Ranges_AreThoseOfTheHelp(string command)
        {
            var rows = Rows(command).ToDictionary(row => row[0]);
            foreach ((string name, string values, string text, _) in Options(command))
            {
                Match range = Regex.Match(text, @"-?[\d.]+ to -?[\d.]*\d");
                if (range.Success)
                    Assert.That(rows[name][1], Does.EndWith(range.Value), name);
                if (values.Contains('|') && !values.Contains('N'))
                    Assert.That(rows[name][1].Replace(", ", "|"), Is.EqualTo(values), name);
            }
        }

        [TestCaseSource(nameof(s_Commands))]
        public void Arguments_AreNamedOnThePage(string command)
        {
            string usage = Regex.Match(Help(command), @"Usage:\n\s+\S+ (.*)").Groups[1].Value;
            foreach (Match argument in Regex.Matches(usage.Split(" [options]")[0], @"<([^>]+)>"))
                Assert.That(Section(command.Split(' ')[0]), Does.Match($"`[^`]*{Regex.Escape(argument.Groups[1].Value)}"), command);
        }

        private static IEnumerable<string> WithThoseBelow(string command) =>
            Names(command).Select(name => $"{command} {name}").Prepend(command);

        // The commands that the help of a command lists.
        private static string[] Names(string command) =>
            Regex.Matches(Part(Help(command), "Commands:"), @"^  (\S+)", RegexOptions.Multiline)
                .Select(line => line.Groups[1].Value).ToArray();

        private static IEnumerable<(string Name, string Values, string Text, string Default)> Options(string command)
        {
            foreach (Match line in Regex.Matches(
                Part(Help(command), "Options:"), @"^  (--\S+)(?: <([^>]+)>)?  +(.*)$", RegexOptions.Multiline))
            {
                Match fallback = Regex.Match(line.Groups[3].Value, @"\[default: (.*)\]$");
                yield return (line.Groups[1].Value, line.Groups[2].Value, line.Groups[3].Value, fallback.Groups[1].Value);
            }
        }

        private static string Help(string command)
        {
            using var run = new CommandRun();
            Assert.That(run.Run([.. command.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]), Is.Zero, run.Errors);
            return run.Output.ReplaceLineEndings("\n");
        }

        private static string Part(string help, string heading)
        {
            int start = help.IndexOf(heading + "\n", StringComparison.Ordinal);
            return start < 0 ? "" : help[start..].Split("\n\n")[0];
        }

        // The rows of a command's table of options, without the quotes of code.
        private static IEnumerable<string[]> Rows(string command) => Section(command).Split('\n').Where(line => line.StartsWith("| `--"))
            .Select(line => line.Trim('|').Split('|').Select(cell => cell.Replace("`", "").Trim()).ToArray());

        // From its heading to the next.
        private static string Section(string command)
        {
            Match section = Regex.Match(
                s_Page, $"^##+ {Regex.Escape(command)}\n(.*?)(?=^##|\\z)", RegexOptions.Multiline | RegexOptions.Singleline);
            Assert.That(section.Success, $"'{command}' has no heading on the page");
            return section.Groups[1].Value;
        }
    }
}
