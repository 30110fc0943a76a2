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
            string[] lines = Part("numbers").Split('\n');
            string[][] rows = lines.Where(row => row.StartsWith($"| {species.Name} | standard |", StringComparison.Ordinal))
                .Select(Cells).ToArray();
            string[][] now = SpeciesTable.Measured([measured]).Select(row => row.ToArray()).ToArray();

            Assert.That(now[..2], Is.EqualTo(new[] { Cells(lines[0]), Cells(lines[2]) }), "headings");
            Assert.That(rows, Has.Length.EqualTo(measured.Wings.Count));
            Assert.That(now, Has.Length.EqualTo(2 + rows.Length));
            for (int k = 0; k < rows.Length; k++)
            {
                Assert.That(now[2 + k][..3], Is.EqualTo(rows[k][..3]));
                for (int cell = 3; cell < rows[k].Length; cell++)
                {
                    double[] here = Numbers(now[2 + k][cell]), there = Numbers(rows[k][cell]);
                    Assert.That(here, Has.Length.EqualTo(there.Length), $"{now[0][cell]}: {now[2 + k][cell]}");
                    for (int number = 0; number < here.Length; number++)
                        Assert.That(here[number], Is.EqualTo(there[number]).Within(0.5), "run the command figures");
                }
            }
        }

        [Test]
        public void MarksAndSigns_OfThePagesNumbers_AreThoseOfItsCells()
        {
            FlightRecord flight = MonarchFlight.Level;
            string[][] rows = SpeciesTable.Measured([FlightSummary.Of(flight)]).Select(row => row.ToArray()).ToArray();
            WingSummary wing = FlightSummary.Of(flight).Main;
            var told = rows[0].Zip(rows[2]).ToDictionary(cell => cell.First, cell => cell.Second);

            Assert.That((told["species"], told["variant"], told["wing"]), Is.EqualTo(("monarch", "standard", wing.Name)));
            foreach ((string name, double value) in new[]
            {
                ("Hz", wing.FrequencyHz), ("twist p-p °", wing.TwistPpDeg), ("tip bend max °", wing.TipBendMaxDeg),
                ("tip bend p-p °", wing.TipBendPpDeg), ("tip lag °", wing.TipLagDeg), ("lag °", wing.LagDeg),
                ("stretch max %", wing.EdgeStretchMaxPct), ("stretch p99 %", wing.EdgeStretchP99Pct),
                ("lift / weight", FlightSummary.Of(flight).LiftOverWeight),
            })
            {
                Assert.That(Numbers(told[name])[0], Is.EqualTo(value).Within(0.0501), name);
            }

            Assert.That(Numbers(told["camber %"]), Is.EqualTo(new[] { wing.CamberMinPct, wing.CamberMaxPct }).Within(0.0501));
        }

        private static string[] Cells(string row) => row.Split('|')[1..^1].Select(cell => cell.Trim()).ToArray();

        private static double[] Numbers(string cell) => Regex.Matches(cell, @"−?\d+(\.\d+)?")
            .Select(match => double.Parse(match.Value.Replace('−', '-'), System.Globalization.CultureInfo.InvariantCulture)).ToArray();

        [Test]
        public void PlansOfThePictures_AreThoseOfThePicturesThatLieThere()
        {
            string images = Path.Combine(s_Folder, "images");
            FilmPlan film = FiguresCommand.HeroFilm;
            var shown = new ApngPlayer(File.ReadAllBytes(Path.Combine(images, "monarch-film.png")));
            Assert.That((shown.Frames.Count, shown.Width), Is.EqualTo((film.Beats * film.Frames, film.Width)));
            Assert.That((film.Flight.Species, film.Turn), Is.EqualTo(("monarch", 360.0)), "the camera goes around");
            Assert.That(film.Flight.Variant, Is.EqualTo(InsectVariant.Expressive), "the front page: the softer variants");

            film = FiguresCommand.OwnFilm(InsectCatalogue.Find("firefly"));
            shown = new ApngPlayer(File.ReadAllBytes(Path.Combine(images, "mymoth-film.png")));
            Assert.That((shown.Frames.Count, shown.Width), Is.EqualTo((film.Beats * film.Frames, film.Width)));
            Assert.That(film.Flight.Definition.Name, Is.EqualTo("firefly"));

            SweepPlan sweep = FiguresCommand.SweptElasticity;
            string[] told = PngTexts.Of(Path.Combine(images, "sweep-elasticity.png"));
            Assert.That(told, Is.SupersetOf(sweep.Values.Select(Alate.Drawing.LineChart.Label)));
            Assert.That(told[0], Is.EqualTo($"Fishfly: {sweep.Parameter.Title}"));
            Assert.That((sweep.Values.Count, sweep.Waves, sweep.Flight.Species), Is.EqualTo((5, SweepWaves.Both, "fishfly")));
            Assert.That(sweep.Flight.Substeps, Is.GreaterThan(96), "the page: in 96 substeps and fewer the last number has not converged");

            ComparisonPlan comparisons = FiguresCommand.Comparisons;
            Assert.That(comparisons.Flights.Select(flight => flight.Species), Is.EqualTo(InsectCatalogue.Names));
            int[] phases = [.. PngTexts.Of(Path.Combine(images, "compare-monarch.png"))
                .Where(text => Regex.IsMatch(text, @"^\d+°$")).Select(text => int.Parse(text[..^1]))];
            Assert.That(phases, Is.EqualTo(
                Enumerable.Range(0, comparisons.Phases).Select(k => (phases[0] + 360 * k / comparisons.Phases) % 360)));
            FreePlan flight = FiguresCommand.Wandering;
            Assert.That(PngTexts.Of(Path.Combine(images, "flight-monarch.png"))[0],
                Does.StartWith($"{flight.Insect.DisplayName}: {flight.Seconds} s by its own wings, "));
            Assert.That(comparisons.Columns, Is.EqualTo(ComparisonColumn.All));
            byte[] gallery = File.ReadAllBytes(Path.Combine(images, "insects.png"));
            Assert.That(gallery[18] << 8 | gallery[19], Is.EqualTo(FiguresCommand.GalleryWidth));
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void ThePicturesThatLieThere_AreThoseThatTheCommandMakes()
        {
            using var command = new CommandRun();
            foreach (string file in Directory.EnumerateFiles(s_Folder, "*", SearchOption.AllDirectories))
            {
                string copy = Path.Combine(command.Folder, Path.GetRelativePath(s_Folder, file));
                Directory.CreateDirectory(Path.GetDirectoryName(copy));
                File.Copy(file, copy);
            }

            Assert.That(command.Run("figures", "--pictures", command.Folder), Is.Zero, command.Errors);
            IEnumerable<string> others = Directory.EnumerateFiles(command.Folder, "*", SearchOption.AllDirectories)
                .Select(file => Path.GetRelativePath(command.Folder, file))
                .Where(file => !File.ReadAllBytes(Path.Combine(command.Folder, file))
                    .SequenceEqual(File.ReadAllBytes(Path.Combine(s_Folder, file))));
            Assert.That(others, Is.Empty, "run figures");
        }

        [Test]
        [Explicit]
        [Category("Long")]
        public void TheOwnInsectOfTheFrontPage_FliesWithoutTearing()
        {
            FlightSummary summary = FiguresCommand.UseOwn(s_Folder, moth =>
                FlightSummary.Of(TetheredFlight.Fly(FlightPlan.Cruise(moth, InsectVariant.Standard))));
            Assert.That(summary.Wings.Max(wing => wing.EdgeStretchMaxPct), Is.LessThan(10));
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
