using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Cli;
using NUnit.Framework;
using Unity.StandIns;

namespace Alate.Tests.Cli
{
    /// <summary>Files that a comparison writes.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class CompareTests
    {
        private CommandRun m_Run;
        private string[][] m_Rows;

        [OneTimeSetUp]
        public void CompareTwoSpecies()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run("compare", "monarch", "fishfly", "Monarch", "--phases", "2", "--elasticity", "4", "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
            m_Rows = File.ReadAllLines(Path.Combine(m_Run.Out, "compare.csv")).Select(line => line.Split(',')).ToArray();
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Folder_HoldsAPictureOfEachSpeciesOnce_AndTheTable() => Assert.That(
            Directory.GetFileSystemEntries(m_Run.Out).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "monarch.png", "fishfly.png", "compare.csv", "free-flight.csv" }));

        [Test]
        public void Table_HasARowForEachColumnAndKindOfWing()
        {
            Assert.That(m_Rows.Skip(1).Select(row => $"{row[0]} {row[2]} {row[3]}"), Is.EqualTo(
                from wing in new[] { "monarch wing", "fishfly fore wing", "fishfly hind wing" }
                from column in new[] { "rigid", "no-wave", "full", "elasticity-4" }
                select $"{wing} {column}"));
        }

        [TestCase("twist_pp_deg")]
        [TestCase("tip_bend_pp_deg")]
        public void ColumnsDeformMore_TheMoreOfTheModelTheyHave(string measure)
        {
            double[] monarch = Of("monarch", measure);

            Assert.That(monarch[0], Is.EqualTo(0.0).Within(0.01), "rigid");
            Assert.That(monarch[1], Is.GreaterThan(5.0), "no wave");
            Assert.That(monarch[2], Is.GreaterThan(monarch[1]), "full");
            Assert.That(monarch[3], Is.LessThan(monarch[2]), "four times as stiff");
        }

        [Test]
        public void DistanceFromTheFullModel_IsNoughtForItself_AndLargestForTheRigidWing()
        {
            double[] mean = Of("monarch", "distance_from_full_mean_pct"), most = Of("monarch", "distance_from_full_max_pct");

            Assert.That(mean[2], Is.Zero);
            Assert.That(most[2], Is.Zero);
            Assert.That(mean[0], Is.EqualTo(mean.Max()).And.InRange(3.0, 30.0));
            Assert.That(most[0], Is.GreaterThan(mean[0]));
        }

        [Test]
        public void Picture_HasFourColumns_TwoPhases_AndTheNumbers()
        {
            string[] texts = PngTexts.Of(Path.Combine(m_Run.Out, "monarch.png"));

            Assert.That(texts,
                Is.SupersetOf(new[] { "Monarch", "Rigid wing", "No deformation wave", "Full model", "Elasticity × 4" }));
            int[] phases = [.. texts.Where(text => Regex.IsMatch(text, @"^\d+°$")).Select(text => int.Parse(text[..^1]))];
            Assert.That(phases, Is.EqualTo(new[] { phases[0], (phases[0] + 180) % 360 }));
            Assert.That(texts, Does.Contain(Of("monarch", "twist_pp_deg")[2].ToString("0.0", CultureInfo.InvariantCulture)));
            Assert.That(new FileInfo(Path.Combine(m_Run.Out, "monarch.png")).Length, Is.LessThan(300_000));
        }

        [Test]
        public void TheFullModelsWings_AreOutlinedInTheOtherColumns()
        {
            var picture = PngFile.Read(File.ReadAllBytes(Path.Combine(m_Run.Out, "monarch.png")));
            // Behind 62 units of labels four panels of 236, one and a half pixels a unit.
            int[] blue = [.. Enumerable.Range(0, 4).Select(column => Enumerable.Range(0, picture.Pixels.Length).Count(k =>
                k % picture.Width / 1.5 > 62 + 236 * column && k % picture.Width / 1.5 < 62 + 236 * (column + 1)
                && picture.Pixels[k].b > picture.Pixels[k].r + 60))];

            Assert.That(blue[2], Is.Zero, "the full model");
            Assert.That(new[] { blue[0], blue[1], blue[3] }, Is.All.GreaterThan(400));
        }

        [Test]
        public void FreeFlight_CarriesItsWeight_AndBobs_WhereTheFlightOnTheSpotIsHeld()
        {
            string[][] rows = File.ReadAllLines(Path.Combine(m_Run.Out, "free-flight.csv")).Select(line => line.Split(',')).ToArray();
            double Of(string species, string flight, string measure) =>
                double.Parse(rows.Single(row => row[0] == species && row[1] == flight)[Array.IndexOf(rows[0], measure)],
                    CultureInfo.InvariantCulture);

            Assert.That(rows, Has.Length.EqualTo(1 + 2 * 2));
            foreach (string species in new[] { "monarch", "fishfly" })
            {
                Assert.That(Of(species, "free", "lift_over_weight"), Is.EqualTo(1.0).Within(0.01), species);
                Assert.That(Of(species, "free", "speed_m_s"), Is.EqualTo(Of(species, "on the spot", "speed_m_s")).Within(0.05), species);
                Assert.That(Of(species, "on the spot", "pitch_bob_deg"), Is.Zero, species);
                Assert.That(Of(species, "free", "power_w"), Is.GreaterThan(0.0), species);
            }

            Assert.That(Of("monarch", "free", "pitch_bob_deg"), Is.InRange(6.0, 10.0), "8 ± 2° at 1.3 m/s");
            Assert.That(m_Run.Output, Does.Contain("Monarch: by its own wings"));
        }

        [TestCase("monarch", "Monarch", "wing")]
        [TestCase("fishfly", "Fishfly", "fore wing", "hind wing")]
        public void Picture_SaysTheNumbersOfTheTable_ColumnByColumn(string species, string name, params string[] wings)
        {
            string[] texts = PngTexts.Of(Path.Combine(m_Run.Out, species + ".png"));
            (string Title, string Key)[] measures =
            [
                ("twist", "twist_pp_deg"), ("camber", null), ("tip bend", "tip_bend_pp_deg"), ("lag", "lag_deg"),
                    ("stretch", "edge_stretch_max_pct"),
                ("off full", "distance_from_full_mean_pct"),
            ];
            double Told(string text) => double.Parse(text.Replace('−', '-'), CultureInfo.InvariantCulture);
            string[] titles = ["Rigid wing", "No deformation wave", "Full model", "Elasticity × 4"];
            Assert.That(texts[0], Is.EqualTo($"{name}: {string.Join(", ", titles)}"));
            Assert.That(texts[1], Is.EqualTo(name));
            Assert.That(texts[2], Does.Match(@"^[\d.]+ Hz, at [\d.]+ m/s, seen from the front left$"));
            // Two phases of four columns each name their row.
            int at = Array.FindLastIndex(texts, text => Regex.IsMatch(text, @"^\d+°$")) + 1;
            for (int column = 0; column < 4; column++)
            {
                Assert.That(texts, Does.Contain(titles[column]));
                if (wings.Length > 1)
                {
                    Assert.That(texts[at..(at + 2)], Is.EqualTo(wings));
                    at += 2;
                }

                foreach ((string title, string key) in measures)
                {
                    Assert.That(texts[at++], Is.EqualTo(title));
                    for (int wing = 0; wing < wings.Length; wing++)
                    {
                        string[] row = m_Rows.Where(cells => cells[0] == species && cells[2] == wings[wing]).ElementAt(column);
                        double Of(string measure) => double.Parse(row[Array.IndexOf(m_Rows[0], measure)], CultureInfo.InvariantCulture);
                        double value = key == null ? Of("camber_max_pct") - Of("camber_min_pct") : Of(key);
                        Assert.That(Told(texts[at++]), Is.EqualTo(value).Within(0.0502), $"{title} of the {wings[wing]}");
                        MeasureBound bound = key == "tip_bend_pp_deg" ? null : MeasureBound.Find(key);
                        bool isOutside = bound != null && (Math.Round(value, 1) < bound.Low || Math.Round(value, 1) > bound.High);
                        Assert.That(texts[at] == "†", Is.EqualTo(isOutside), $"{title} of the {wings[wing]}: {value}");
                        at += isOutside ? 1 : 0;
                    }
                }

                Assert.That(texts[at++], Is.EqualTo("lift / weight"));
                string[] first = m_Rows.Where(cells => cells[0] == species).ElementAt(column);
                Assert.That(Told(texts[at++]), Is.EqualTo(double.Parse(first[Array.IndexOf(m_Rows[0], "lift_over_weight")],
                    CultureInfo.InvariantCulture)).Within(0.00502));
            }

            Assert.That(texts[at..], Has.Length.EqualTo(3), "what the words below mean");
            Assert.That(texts[^2], Does.EndWith("twist 10–50°, lag 10–40°, stretch < 6 %."));
            Assert.That(texts[^1], Does.StartWith("Blue lines"));
        }

        [TestCase("monarch", "Monarch: wing", "wing")]
        [TestCase("fishfly", "Fishfly: hind wing", "hind wing")]
        public void TheTerminalsTables_HaveTheNumbersOfTheFile(string species, string heading, string wing)
        {
            Dictionary<string, string[]> rows = TerminalTable.Behind(m_Run.Output, heading).ToDictionary(row => row[0]);
            string[][] own = [.. m_Rows.Where(cells => cells[0] == species && cells[2] == wing)];
            Assert.That(rows[""][1..], Is.EqualTo(new[] { "Rigid wing", "No deformation wave", "Full model", "Elasticity × 4", "usual" }));
            foreach (WingMeasure measure in WingMeasure.All)
                AssertRow(measure.Title, measure.Key, MeasureBound.Find(measure.Key)?.Range ?? "");
            AssertRow("off the full model, mean, % of length", "distance_from_full_mean_pct", "");
            AssertRow("off the full model, most, % of length", "distance_from_full_max_pct", "");
            if (wing == "wing")
                AssertRow("lift over weight", "lift_over_weight", "");
            else
                Assert.That(rows.ContainsKey("lift over weight"), Is.False, "of all wings, told with the first");
            Assert.That(rows.ContainsKey(MeasureBound.Find("camber_pct").Title), Is.True, "a range of both cambers");

            void AssertRow(string title, string key, string usual)
            {
                for (int column = 0; column < 4; column++)
                {
                    double value = double.Parse(own[column][Array.IndexOf(m_Rows[0], key)], CultureInfo.InvariantCulture);
                    Assert.That(double.Parse(rows[title][1 + column].Replace("†", ""), CultureInfo.InvariantCulture),
                        Is.EqualTo(value).Within(0.00502), title);
                }

                Assert.That(rows[title][5], Is.EqualTo(usual));
            }
        }

        [Test]
        public void Terminal_ShowsTheDifferences()
        {
            Assert.That(
                m_Run.Output, Does.Contain("Full model").And.Contain("twist").And.Contain("Fishfly: hind wing").And.Contain("compare.csv"));
            Assert.That(m_Run.Output, Does.Contain("usual").And.Contain("10–50 *").And.Contain("0.00 †").And.Not.Match(@"-0\.00\b"),
                "a rigid wing neither twists nor lags");
        }

        private double[] Of(string species, string measure)
        {
            int column = Array.IndexOf(m_Rows[0], measure);
            return m_Rows.Where(row => row[0] == species).Select(row => double.Parse(row[column], CultureInfo.InvariantCulture)).ToArray();
        }
    }
}
