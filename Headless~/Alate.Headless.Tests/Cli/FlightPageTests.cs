using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>The documentation's page of flight, whose tables the command <c>figures</c> writes.</summary>
    public sealed class FlightPageTests
    {
        private static readonly Regex s_Number = new Regex(@"−?\d+(\.\d+)?");

        // To a unit of the last digit: other processors round otherwise.
        [Test]
        public void SteadyFlights_AreThoseOfThePage() =>
            Compare("steady flights", FlightFigures.Steady([InsectCatalogue.Find("monarch"), InsectCatalogue.Find("snailfish")]),
                "Monarch");

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void TheMonarchBesideMeasurements_IsThatOfThePage() =>
            Compare("flights beside measurements", FlightFigures.Measured(), "");

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void TheSlowestDragonflyBesideMeasurements_IsThatOfThePage() =>
            Compare("the dragonfly beside measurements", FlightFigures.MeasuredDragonflies([MeasuredDragonfly.Flights[0]]), "", 3);

        private static void Compare(string part, IEnumerable<string[]> made, string only, int count = int.MaxValue)
        {
            string page = File.ReadAllText(Path.Combine(PackageRoot.Find(), "Documentation~", FlightFigures.Page)).ReplaceLineEndings("\n");
            string begin = PageBlock.Begin(part);
            int from = page.IndexOf(begin, StringComparison.Ordinal) + begin.Length;
            string[][] told = page[from..page.IndexOf(PageBlock.End(part), StringComparison.Ordinal)]
                .Split('\n', StringSplitOptions.RemoveEmptyEntries).Where((row, k) => k != 1 && (k == 0 || row.StartsWith("| " + only)))
                .Select(row => row.Split('|')[1..^1].Select(cell => cell.Trim()).ToArray()).Take(count).ToArray();
            string[][] rows = made.ToArray();

            Assert.That(rows, Has.Length.EqualTo(told.Length));
            for (int k = 0; k < rows.Length; k++)
            {
                Assert.That(rows[k], Has.Length.EqualTo(told[k].Length));
                for (int cell = 0; cell < rows[k].Length; cell++)
                {
                    Assert.That(s_Number.Replace(rows[k][cell], "#"), Is.EqualTo(s_Number.Replace(told[k][cell], "#")), "run figures");
                    double[] here = Numbers(rows[k][cell]), there = Numbers(told[k][cell]);
                    for (int number = 0; number < here.Length; number++)
                    {
                        double least = rows[k][cell].Contains('.') ? 0.11 : 1.01;
                        Assert.That(here[number], Is.EqualTo(there[number]).Within(least), $"{told[k][cell]}: run figures");
                    }
                }
            }
        }

        private static double[] Numbers(string cell) => s_Number.Matches(cell)
            .Select(match => double.Parse(match.Value.Replace('−', '-'), CultureInfo.InvariantCulture)).ToArray();

        // ALATE_WRITE_FIGURES=1 writes the page's tables again, as figures does with all pages.
        [Test]
        [Explicit]
        [Category("Long")]
        public void ItsTables_AreThoseOfToday()
        {
            string path = Path.Combine(PackageRoot.Find(), "Documentation~", FlightFigures.Page);
            string page = File.ReadAllText(path).ReplaceLineEndings("\n"), made = FlightFigures.Make(page);
            if (Environment.GetEnvironmentVariable("ALATE_WRITE_FIGURES") == "1")
                File.WriteAllText(path, made);

            Assert.That(page, Is.EqualTo(made), "run the command figures");
        }
    }
}
