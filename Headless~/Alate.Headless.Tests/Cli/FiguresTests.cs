using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>The documentation's page of species and the command that writes its parts.</summary>
    public sealed class FiguresTests
    {
        private static readonly string s_Folder = Path.Combine(PackageRoot.Find(), "Documentation~");
        private static readonly Lazy<string> s_Page = new Lazy<string>(
            () => File.ReadAllText(Path.Combine(s_Folder, "species.md")).ReplaceLineEndings("\n"));

        private static IEnumerable<InsectDefinition> All => InsectCatalogue.All;

        [Test]
        public void EveryPictureOfThePage_IsThere_AndSmall()
        {
            string[] pictures = Regex.Matches(s_Page.Value, @"\]\((images/[^)]+)\)").Select(match => match.Groups[1].Value).ToArray();

            Assert.That(pictures, Has.Length.EqualTo(2 + 2 * InsectCatalogue.All.Count));
            foreach (string picture in pictures)
                Assert.That(new FileInfo(Path.Combine(s_Folder, picture)).Length, Is.InRange(1_000, 300_000), picture);
        }

        [TestCaseSource(nameof(All))]
        public void ThePagesSources_AreThoseOfTheSpecies(InsectDefinition species)
        {
            Assert.That(Part("sources of " + species.Name), Is.EqualTo(MarkdownTable.Write(SpeciesTable.Sources(species))),
                "run the command figures");
        }

        [TestCaseSource(nameof(All))]
        public void ThePagesNumbers_AreThoseMeasuredNow(InsectDefinition species)
        {
            var measured = FlightSummary.Of(TetheredFlight.Fly(
                new FlightPlan
                {
                    Species = species.Name,
                    Speed = FlightPlan.CruiseOf(
                    species),
                    Substeps = FiguresCommand.MeasuredSubsteps
                }));
            string[] rows = Part("numbers").Split('\n')
                .Where(row => row.StartsWith($"| {species.Name} | standard |", StringComparison.Ordinal)).ToArray();

            Assert.That(rows, Has.Length.EqualTo(measured.Wings.Count));
            for (int k = 0; k < rows.Length; k++)
            {
                double twist = double.Parse(rows[k].Split('|')[5].Replace("†", ""), System.Globalization.CultureInfo.InvariantCulture);
                Assert.That(twist, Is.EqualTo(measured.Wings[k].TwistPpDeg).Within(0.5), "run the command figures");
            }
        }

        [Test]
        public void APart_IsReplaced_AndTheRestOfThePageStays()
        {
            string page = "a\n" + PageBlock.Begin("x") + "old\n" + PageBlock.End("x") + "\nb\n";

            Assert.That(PageBlock.Replace(page, "x", "new\n"), Is.EqualTo(page.Replace("old", "new")));
            Assert.That(() => PageBlock.Replace(page, "y", ""), Throws.InstanceOf<UserException>().With.Message.Contains("y:"));
        }

        private static string Part(string name)
        {
            int from = s_Page.Value.IndexOf(PageBlock.Begin(name), StringComparison.Ordinal) + PageBlock.Begin(name).Length;
            return s_Page.Value.Substring(from, s_Page.Value.IndexOf(PageBlock.End(name), StringComparison.Ordinal) - from);
        }
    }
}
