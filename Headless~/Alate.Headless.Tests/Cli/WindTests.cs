using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli
{
    /// <summary>Files that the command <c>wind</c> writes, and the winds it blows.</summary>
    public sealed class WindTests
    {
        private CommandRun m_Run;
        private string[][] m_Rows;

        [OneTimeSetUp]
        public void BlowOnAMonarchAndASnailfish()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run("wind", "monarch", "snailfish", "--speeds", "10,0,10", "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
            m_Rows = Rows(m_Run);
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Folder_HoldsThePictureAndTheTable() => Assert.That(
            Directory.GetFileSystemEntries(m_Run.Out).Select(Path.GetFileName), Is.EquivalentTo(new[] { "wind.svg", "wind.csv" }));

        [Test]
        public void Table_HasARowForEachModelAndSpeedOnce_ATenthInWater()
        {
            Assert.That(string.Join(',', m_Rows[0]), Is.EqualTo(
                "species,variant,wing,model,air,wind_m_s,edge_stretch_max_pct,edge_stretch_p99_pct,"
                + "worst_from,head_wind_tip_bend_max_deg,resets"));
            Assert.That(m_Rows.Skip(1).Select(row => string.Join(' ', row.Take(6))), Is.EqualTo(
                from wing in new[] { "monarch standard wing", "snailfish standard fin" }
                from model in new[] { "now", "0.1" }
                from share in new[] { 0, 1 }
                select $"{wing} {model} steady {share * (wing.StartsWith("snailfish") ? 1 : 10)}"));
        }

        [Test]
        public void TenMetresASecond_TearVersion01_AndNotTheWingOfToday()
        {
            double[] monarch = m_Rows.Where(row => row[0] == "monarch")
                .Select(row => double.Parse(row[6], CultureInfo.InvariantCulture)).ToArray();

            Assert.That(monarch[1], Is.InRange(monarch[0], 15.0));
            Assert.That(monarch[3], Is.GreaterThan(30.0));
        }

        [Test]
        public void WorstSide_IsNamed_WhereThereIsWind()
        {
            Assert.That(m_Rows.Skip(1).Where(row => row[5] == "0").Select(row => row[8]), Is.All.Empty);
            Assert.That(m_Rows.Skip(1).Where(row => row[5] != "0").Select(row => row[8]).Distinct(),
                Is.SubsetOf(WindDirection.All.Select(side => side.Name)));
        }

        [Test]
        public void Picture_HasAChartForEachSpecies_AndTheLimits()
        {
            var svg = XElement.Load(Path.Combine(m_Run.Out, "wind.svg"));
            XNamespace space = "http://www.w3.org/2000/svg";
            string[] texts = svg.Elements(space + "text").Select(text => text.Value).ToArray();

            Assert.That(texts,
                Is.SupersetOf(new[] { "Monarch", "Snailfish, in water", "limit of the largest: 10, 12, 15 %", "largest, version 0.1" }));
            // In each: limits, the largest of both models, and a percentile.
            Assert.That(svg.Elements(space + "path").Count(path => path.Attribute("clip-path") != null), Is.EqualTo(2 * 4));
        }

        [Test]
        public void Terminal_ShowsTheWorstSide_AndTheBendOfTheTip()
        {
            Assert.That(
                m_Run.Output, Does.Contain("worst from").And.Contain("tip bend").And.Contain("Snailfish: fin").And.Contain("wind.csv"));
        }

        [Test, Explicit, Category("Long")]
        public void Gusts_AreSaidInTheTable()
        {
            using var run = new CommandRun();

            Assert.That(
                run.Run("wind", "snailfish", "--speeds", "3", "--gusts", "--variant", "expressive", "--out", run.Out), Is.Zero, run.Errors);
            Assert.That(Rows(run).Skip(1).Select(row => $"{row[1]} {row[4]}"), Is.All.EqualTo("expressive gusts"));
        }

        [Test]
        public void Sides_AreTheNeighboursOfACubesCentre_WithNamesOfTheirOwn()
        {
            IReadOnlyList<WindDirection> sides = WindDirection.All;

            Assert.That(sides.Select(side => side.Name).Distinct().Count(), Is.EqualTo(26));
            Assert.That(sides.Select(side => math.length(ToVector(side.Velocity(2.0)))), Is.All.EqualTo(2f).Within(1e-5f));
            Assert.That(WindDirection.HeadWind.Name, Is.EqualTo("ahead"));
            Assert.That(WindDirection.HeadWind.Velocity(2.0), Is.EqualTo(new[] { 0.0, 0.0, -2.0 }).Within(1e-6));
        }

        [TestCase(0.0, 0.0)]
        [TestCase(2.0, 1.0)]
        [TestCase(2.5, 0.0)]
        [TestCase(3.0, 1.0)]
        [TestCase(3.75, 0.0)]
        [TestCase(4.0, 1.0)]
        [TestCase(5.4, 1.0)]
        [TestCase(5.5, 0.0)]
        public void Gusts_RiseTwiceSmoothly_AndOnceAtOnce(double beats, double share) =>
            Assert.That(GustProfile.ShareAt(beats), Is.EqualTo(share).Within(1e-9));

        [TestCase(0.03, 2.1, 0.02, 5)]
        [TestCase(1, 1, 1, 2)]
        [TestCase(0.2, 0.5, 0.2, 0.5)]
        public void LogarithmicAxis_EndsAtRoundNumbers(double least, double most, double from, double to)
        {
            var axis = ChartAxis.Logarithmic(least, most);

            Assert.That(new[] { axis.From, axis.To }, Is.EqualTo(new[] { from, to }).Within(1e-9));
            Assert.That(axis.Ticks.Select(axis.Fraction), Is.Ordered.Ascending.And.All.InRange(0f, 1f));
        }

        private static string[][] Rows(CommandRun run) =>
            File.ReadAllLines(Path.Combine(run.Out, "wind.csv")).Select(line => line.Split(',')).ToArray();

        private static float3 ToVector(double[] velocity) => new float3((float)velocity[0], (float)velocity[1], (float)velocity[2]);
    }
}
