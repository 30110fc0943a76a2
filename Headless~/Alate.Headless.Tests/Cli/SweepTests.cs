using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Files that a sweep writes.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class SweepTests
    {
        private CommandRun m_Run;
        private string[][] m_Rows;

        [OneTimeSetUp]
        public void SweepAFishfly()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run("sweep", "chord-delay", "0", "0.2", "--steps", "3", "--wave", "both", "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
            m_Rows = File.ReadAllLines(Path.Combine(m_Run.Out, "sweep.csv")).Select(line => line.Split(',')).ToArray();
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Table_HasARowForEachValue_KindOfWing_AndWave()
        {
            Assert.That(m_Rows[0].Take(4), Is.EqualTo(new[] { "chord_delay", "wave", "wing", "frequency_hz" }));
            Assert.That(m_Rows.Skip(1).Select(row => string.Join(' ', row.Take(3))), Is.EqualTo(
                from wave in new[] { "on", "off" }
                from value in new[] { "0", "0.1", "0.2" }
                from wing in new[] { "fore wing", "hind wing" }
                select $"{value} {wave} {wing}"));
        }

        [Test]
        public void TheWave_ChangesTheTwist_AndWithoutItItsDelayDoesNothing()
        {
            double[] twist = m_Rows.Skip(1).Where(row => row[2] == "fore wing")
                .Select(row => double.Parse(row[4], CultureInfo.InvariantCulture)).ToArray();

            Assert.That(twist.Take(3), Is.Ordered);
            Assert.That(twist[2], Is.GreaterThan(1.3 * twist[0]));
            Assert.That(twist.Skip(3).Distinct().Count(), Is.EqualTo(1));
        }

        [Test]
        public void Picture_HasAColumnForEachValue_ARowForEachPhase_AndSixCharts()
        {
            var svg = XElement.Load(Path.Combine(m_Run.Out, "sweep.svg"));
            XNamespace space = "http://www.w3.org/2000/svg";
            string[] texts = svg.Elements(space + "text").Select(text => text.Value).ToArray();

            string[] labels = PngTexts.Of(Path.Combine(m_Run.Out, "sweep.png"));
            Assert.That(labels.Where(text => text.EndsWith("°") && !text.Contains(',')),
                Is.EqualTo(Enumerable.Repeat(new[] { "0°", "90°", "180°", "270°" }, 2).SelectMany(row => row)));
            Assert.That(labels, Does.Contain("with the deformation wave").And.Contain("without the deformation wave"));
            Assert.That(texts, Is.SupersetOf(new[] { "twist, peak to peak, °", "lag of the tip, °", "fore wing", "hind wing", "0.1" }));
            // Each chart: two kinds of wings with and without the wave; the lift is that of all wings.
            Assert.That(svg.Elements(space + "path").Count(path => path.Attribute("d").Value.Contains('L')), Is.EqualTo(5 * 4 + 2));
        }

        [Test]
        public void TheTerminalsTable_HasTheNumbersOfTheFile_RoundedAndMarked()
        {
            string[][] rows = TerminalTable.Behind(m_Run.Output, "Fishfly: chord-delay, half beats");
            (string Title, string Key)[] columns =
                [("twist °", "twist_pp_deg"), ("tip bend °", "tip_bend_max_deg"), ("lag °", "lag_deg"),
                    ("stretch %", "edge_stretch_max_pct")];

            Assert.That(rows[1][3..8], Is.EqualTo(new[] { "10–50 *", "2–15 *", "< 46", "10–40 *", "< 6 *" }));
            Assert.That(rows, Has.Length.EqualTo(2 + 12));
            for (int k = 1; k < m_Rows.Length; k++)
            {
                string[] told = rows[k + 1];
                double Of(string key) => double.Parse(m_Rows[k][Array.IndexOf(m_Rows[0], key)], CultureInfo.InvariantCulture);
                Assert.That(told[..3], Is.EqualTo(m_Rows[k][..3]));
                foreach ((string title, string key) in columns)
                {
                    int column = Array.FindIndex(rows[0], cell => cell == title);
                    var bound = MeasureBound.Find(key);
                    double value = Of(key);
                    Assert.That(double.Parse(told[column].Replace("†", "").Replace('−', '-'), CultureInfo.InvariantCulture),
                        Is.EqualTo(value).Within(0.0501), key);
                    Assert.That(told[column].Contains('†'), Is.EqualTo(Math.Round(value, 1) < bound.Low || Math.Round(value,
                        1) > bound.High), key);
                }

                double camber = Math.Max(Of("camber_max_pct"), -Of("camber_min_pct"));
                Assert.That(double.Parse(told[4].Replace("†", ""), CultureInfo.InvariantCulture), Is.EqualTo(camber).Within(0.0501));
                Assert.That(double.Parse(told[8], CultureInfo.InvariantCulture), Is.EqualTo(Of("camber_load_pp_pct")).Within(0.0501));
                Assert.That(told[9].Length == 0, Is.EqualTo(told[2] == "hind wing"));
                if (told[9].Length > 0)
                    Assert.That(double.Parse(told[9], CultureInfo.InvariantCulture), Is.EqualTo(Of("lift_over_weight")).Within(0.00501));
            }
        }

        [Test]
        public void Terminal_ShowsTheMeasures()
        {
            Assert.That(
                m_Run.Output, Does.Contain("twist °").And.Contain("off │ hind wing").And.Contain("sweep.svg").And.Contain("sweep.png"));
            Assert.That(
                m_Run.Output, Does.Contain("usual").And.Contain("10–50 *").And.Contain("1.0 †").And.Contain("no published range is known"),
                "a wing without a wave hardly lags");
        }

        [TestCase(0.25, 4, 5, new[] { 0.25, 0.5, 1.0, 2.0, 4.0 })]
        [TestCase(4, 0.25, 3, new[] { 4.0, 1.0, 0.25 })]
        [TestCase(1, 2, 3, new[] { 1.0, 1.5, 2.0 })]
        public void Values_AreEven_OrOfEqualRatiosOverAWideRange(double from, double to, int steps, double[] expected)
        {
            var plan = new SweepPlan(
                FlownParameters.Find("elasticity"), from, to, steps, new FlightPlan { Species = "fishfly" }, SweepWaves.On);

            Assert.That(plan.Values, Is.EqualTo(expected).Within(1e-9));
        }

        [Test]
        public void WholeNumbers_StayWhole()
        {
            var plan = new SweepPlan(
                FlownParameters.Find("substeps-per-beat"), 12, 13, 5, new FlightPlan { Species = "fishfly" }, SweepWaves.On);

            Assert.That(plan.Values, Is.EqualTo(new[] { 12.0, 13.0 }));
        }

        [TestCase("elasticity", 0, 1)]
        [TestCase("chord-delay", 0, 3)]
        [TestCase("pitch", -91, 0)]
        [TestCase("wind", 1, 1)]
        public void ValuesThatCannotBe_AreRefused_WithTheParametersName(string parameter, double from, double to)
        {
            using var run = new CommandRun();

            int code = run.Run("sweep", parameter, from.ToString(CultureInfo.InvariantCulture), to.ToString(CultureInfo.InvariantCulture));

            Assert.That(code, Is.EqualTo(2));
            Assert.That(run.Errors, Does.Contain(parameter));
        }
    }
}
