using System;
using System.IO;
using System.Text.RegularExpressions;
using Alate.Cli;
using Alate.Editor;
using NUnit.Framework;

namespace Alate.Tests.Editor
{
    /// <summary>The manual of the skeleton tool says what the tool does.</summary>
    public sealed class AuthoringManualTests
    {
        private static readonly string s_Manual = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", "authoring.md"));

        [Test]
        public void EveryCommand_HasALineWithItsKey()
        {
            foreach (EditCommand command in SkeletonCommands.All)
            {
                Assert.That(s_Manual, Does.Match($@"(?m)^\| {Regex.Escape(command.Name)} \| {Regex.Escape(command.Shortcut)} ?\| \S"),
                    command.Name);
            }
        }

        [Test]
        public void NoLine_IsOfACommandThatIsNotThere()
        {
            int begin = s_Manual.IndexOf("| command | key |", StringComparison.Ordinal),
                end = s_Manual.IndexOf("\n\n", begin, StringComparison.Ordinal);
            int lines = s_Manual[begin..end].Split('\n').Length - 2;

            Assert.That(lines, Is.EqualTo(SkeletonCommands.All.Count));
        }

        [Test]
        public void Switches_AreNamedWithTheirKeys()
        {
            Assert.That(s_Manual, Does.Contain($"**{SkeletonKeys.Beat}** shows or hides the beat"));
            Assert.That(s_Manual, Does.Contain($"**Shift+{SkeletonKeys.Symmetry}** switches symmetric editing"));
        }

        [Test]
        public void EveryProblem_HasARemedy([Values] SkeletonProblemKind kind) => Assert.That(s_Manual, Does.Contain(kind.ToString()));

        [Test]
        public void Limits_AreThoseOfTheCode()
        {
            Assert.That(s_Manual, Does.Contain($"farther than {100f * RigProblems.FarDistance:0} % of the wing's length"));
            Assert.That(s_Manual, Does.Contain($"more than {100f * RigProblems.HeldShare:0} % of the area"));
            Assert.That(s_Manual, Does.Contain($"five times the mean, or {100f * RigProblems.MassShare:0} % of the wing"));
            Assert.That(s_Manual, Does.Contain($"{BeatPreview.Patches} patches"));
            Assert.That(RigProblems.MassOverMean, Is.EqualTo(5f));
            Assert.That(BeatPreview.SettleBeats, Is.EqualTo(3));
        }
    }
}
