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
    /// <summary>The documentation's page of accuracy, whose parts the command <c>figures</c> writes.</summary>
    public sealed class AccuracyPageTests
    {
        private static readonly string s_Folder = Path.Combine(PackageRoot.Find(), "Documentation~");
        private static readonly Lazy<string> s_Page = new Lazy<string>(
            () => File.ReadAllText(Path.Combine(s_Folder, AccuracyFigures.Page)).ReplaceLineEndings("\n"));

        private static IEnumerable<string> Parts => new[] { "errors", "converged values", "winds" };

        [TestCaseSource(nameof(Parts))]
        public void EachTable_HasARowForEachKindOfWing(string part)
        {
            string page = s_Page.Value, begin = PageBlock.Begin(part);
            int from = page.IndexOf(begin, StringComparison.Ordinal) + begin.Length;
            string[] rows = page.Substring(from, page.IndexOf(PageBlock.End(part), StringComparison.Ordinal) - from)
                .Split('\n', StringSplitOptions.RemoveEmptyEntries);

            Assert.That(
                rows.Skip(2).Select(row => string.Join(' ', row.Split('|').Skip(1).Take(2).Select(cell => cell.Trim()))), Is.EqualTo(
                from species in InsectCatalogue.All from wing in species.Wings select $"{species.Name} {wing.Name}"),
                "run the command figures");
        }

        [Test]
        public void ItsPictures_AreThere_AndSmall()
        {
            string[] pictures = Regex.Matches(s_Page.Value, @"\]\((images/[^)]+)\)").Select(match => match.Groups[1].Value).ToArray();

            Assert.That(pictures, Is.EquivalentTo(AccuracyFigures.Files.Skip(1)));
            foreach (string picture in pictures)
                Assert.That(new FileInfo(Path.Combine(s_Folder, picture)).Length, Is.InRange(1_000, 300_000), picture);
        }
    }
}
