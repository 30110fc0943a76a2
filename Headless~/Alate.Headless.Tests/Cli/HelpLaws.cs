using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Laws of the help: every command has examples that are commands, every range is the one that is held.</summary>
public sealed class HelpLaws
{
    private static readonly string[] s_Commands =
        [.. Names("").SelectMany(name => Names(name).Select(below => $"{name} {below}").Prepend(name))];

    // Arguments that are sound, so that what is refused is the option.
    private static readonly Dictionary<string, string[]> s_Arguments = new()
    {
        ["film"] = ["monarch"],
        ["trim"] = ["monarch"],
        ["compare"] = ["monarch"],
        ["sweep"] = ["pitch", "0", "10"],
        ["skeleton fit"] = ["none.obj"],
        ["skeleton from-image"] = ["none.png"],
        ["bake"] = ["monarch"],
        ["fly"] = ["monarch"],
    };

    [TestCaseSource(nameof(s_Commands))]
    public void EachCommand_HasExamples_ThatBeginWithItsName_AndHaveItsOptionsAlone(string command)
    {
        string help = Help(command);
        Match part = Regex.Match(help, @"^Examples?:\n((?:  .+\n)+)", RegexOptions.Multiline);
        Assert.That(part.Success, Is.True, help);
        string[] examples = [.. part.Groups[1].Value.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line.Trim())];
        foreach (string example in examples)
        {
            Assert.That(example, Does.StartWith(command.Split(' ')[0]));
            foreach (Match option in Regex.Matches(example, @"--[a-z-]+"))
            {
                string named = Regex.Match(example, @"^\w[\w-]*( (fit|from-image|new))?").Value;
                Assert.That(Help(named), Does.Contain($"  {option.Value}"), example);
            }
        }
    }

    [Test]
    public void EachCommand_IsFoundByItsOwnName()
    {
        foreach ((string name, Func<TextWriter, System.CommandLine.Command> create) in Program.s_Commands)
            Assert.That(create(TextWriter.Null).Name, Is.EqualTo(name));
    }

    [Test]
    public void TheProgramsOwnHelp_HasTheFirstExampleOfEachCommand()
    {
        string help = Help("");
        foreach (string name in Names(""))
        {
            string first = Regex.Match(Help(name), @"^Examples?:\n(.+)\n", RegexOptions.Multiline).Groups[1].Value;
            Assert.That(help, Does.Contain(first + "\n"), name);
        }
    }

    [TestCaseSource(nameof(s_Commands))]
    public void ARangeOfTheHelp_IsTheOneThatIsHeld(string command)
    {
        foreach (Match option in Regex.Matches(Help(command), @"^  (--\S+) <([^>]+)> +(.*)$", RegexOptions.Multiline))
        {
            string name = option.Groups[1].Value, text = option.Groups[3].Value;
            Match range = Regex.Match(text, @"(-?[\d.]+) to (-?[\d.]*\d)");
            if (!range.Success || name is "--elements" or "--seed" || text.Contains("pixels from the picture's"))
                continue;
            double min = Number(range.Groups[1].Value), max = Number(range.Groups[2].Value), step = Math.Max(1e-6 * Math.Abs(max), 1e-3);
            bool isWhole = option.Groups[2].Value == "N";
            int values = option.Groups[2].Value.Contains("X,Y,Z") ? 3 : 1;
            foreach (double beyond in isWhole ? new[] { min - 1, max + 1 } : [min - step, max + step])
            {
                using var run = new CommandRun();
                string typed = string.Join(',', Enumerable.Repeat(beyond.ToString("0.##########", CultureInfo.InvariantCulture), values));
                string[] words = [.. command.Split(' '), .. s_Arguments.GetValueOrDefault(command, []), name, typed];
                Assert.That(run.Run(words), Is.EqualTo(2), string.Join(' ', words));
                Assert.That(run.Errors, Does.Contain(FormattableString.Invariant($"between {min} and {max}")), string.Join(' ', words));
            }
        }
    }

    // A slip of one letter leads to the command that was meant.
    [TestCaseSource(nameof(s_Commands))]
    public void ACommandWithAWrongLetter_IsGuessed(string command)
    {
        string[] words = command.Split(' ');
        string name = words[^1];
        foreach (string slip in new[] { "x" + name, name + "q", name[1..], name[..^1], name[..1] + "qq"[..1] + name[2..] })
        {
            // Without its first letter "bake" is as near to "wake".
            // What stands behind "study" may be a file.
            if (command == "study merge" || slip.Length < 3 || s_Commands.Count(known => known.Split(' ')[^1].EndsWith(slip)) > 1)
                continue;
            using var run = new CommandRun();
            Assert.That(run.Run([.. words[..^1], slip]), Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain($"Unknown command '{slip}'. Did you mean '{command}'?"));
        }
    }

    [TestCase("flyyy", "fly")]
    [TestCase("flyyyyy", null)]
    [TestCase("gallllry", "gallery")]
    [TestCase("GALLERY", "gallery")]
    [TestCase("something", null)]
    public void AGuess_IsAtMostAQuarterOfTheLettersAndOneOff(string typed, string guess)
    {
        using var run = new CommandRun();
        Assert.That(run.Run(typed), Is.EqualTo(2));
        Assert.That(run.Errors, guess == null ? Does.Not.Contain("Did you mean") : Does.Contain($"Did you mean '{guess}'?"));
    }

    [Test]
    public void MoreNumbersThanAreTaken_AreRefused_WithHowManyMayBe()
    {
        using var run = new CommandRun();
        string many = string.Join(',', Enumerable.Range(0, 13));
        Assert.That(run.Run("trim", "monarch", "--speeds", many), Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain($"--speeds takes 1 to 12 numbers with commas, not '{many}'."));
    }

    [Test]
    public void TheVersion_IsThatOfThePackage()
    {
        using var run = new CommandRun();
        Assert.That(run.Run("--version"), Is.Zero);
        string version = Regex.Match(File.ReadAllText(Path.Combine(PackageRoot.Find(), "package.json")),
            "\"version\": \"([^\"]+)\"").Groups[1].Value;
        Assert.That(run.Output.Trim(), Is.EqualTo(version));
    }

    private static string[] Names(string command)
    {
        string help = Help(command);
        int start = help.IndexOf("Commands:\n", StringComparison.Ordinal);
        return start < 0 ? [] : [.. Regex.Matches(help[start..].Split("\n\n")[0], @"^  (\S+)",
            RegexOptions.Multiline).Select(line => line.Groups[1].Value)];
    }

    private static string Help(string command)
    {
        using var run = new CommandRun();
        Assert.That(run.Run([.. command.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]), Is.Zero, run.Errors);
        return run.Output.ReplaceLineEndings("\n");
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
