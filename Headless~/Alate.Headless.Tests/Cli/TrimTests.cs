using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using Alate.Wake;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Files of the command trim.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class TrimTests
    {
        [Test]
        public void TheSourceOfATable_TellsTheOptionsThatAreNotTheDefaults()
        {
            Assert.That(TrimCommand.Asked("--speeds", [0f, 1.5f], [0f, 1.5f]), Is.Empty);
            Assert.That(TrimCommand.Asked("--speeds", [0f, 1.5f], [0f, 1f]), Is.EqualTo(" --speeds 0,1.5"));
            Assert.That(TrimCommand.Asked("--climbs", [-0.25f], []), Is.EqualTo(" --climbs -0.25"));
        }

        private CommandRun m_Run;
        private string[] m_Lines;

        // Two points of which one closes: no monarch climbs by 3 m/s.
        [OneTimeSetUp]
        public void Trim()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run("trim", "monarch", "--speeds", "1.3", "--climbs", "0,3", "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
            m_Lines = File.ReadAllLines(Path.Combine(m_Run.Out, "trim.csv"));
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Folder_HoldsTableAndPicture() =>
            Assert.That(
                Directory.GetFileSystemEntries(m_Run.Out).Select(Path.GetFileName), Is.EquivalentTo(new[] { "trim.csv", "trim.svg" }));

        [Test]
        public void LevelFlight_Closes_WithinHalfAPercent_AndGivesPowerToTheAir() =>
            AssertCloses(m_Lines.Single(line => line.StartsWith("1.3,0,")));

        [Test]
        [Explicit]
        [Category("Long")]
        public void LevelFlights_AtOtherSpeeds_CloseToo()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("trim", "monarch", "--speeds", "0.5,1,1.6", "--climbs", "0", "--out", run.Out), Is.Zero, run.Errors);
            string[] lines = File.ReadAllLines(Path.Combine(run.Out, "trim.csv"));
            Assert.That(lines, Has.Length.EqualTo(4));
            foreach (string line in lines.Skip(1))
                AssertCloses(line);
        }

        private void AssertCloses(string line)
        {
            Assert.That(Cell(line, "closes"), Is.EqualTo("yes"), line);
            foreach (string residual in new[] { "lift_residual", "thrust_residual", "moment_residual" })
                Assert.That(Number(line, residual), Is.EqualTo(0.0).Within(0.005), residual);
            Assert.That(Number(line, "power_mw"), Is.InRange(0.5, 50.0));
            Assert.That(Number(line, "pitch_bob_deg"), Is.InRange(3.0, 20.0));
        }

        [Test]
        public void APointThatDoesNotClose_SaysWhatIsMissing()
        {
            string line = m_Lines.Single(row => row.StartsWith("1.3,3,"));

            Assert.That(Cell(line, "closes"), Is.EqualTo("no"));
            Assert.That(line, Does.Contain("lift is").And.Contain("thrust").And.Contain("pitching moment"));
        }

        [Test]
        public void TheTerminal_TellsTheInsectItsMassWingsAndBeat_AndTheRowsOfTheTable()
        {
            string[] lines = m_Run.Output.ReplaceLineEndings("\n").Split('\n');
            using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
            int head = Array.FindIndex(lines, line => line.StartsWith("Monarch: "));

            Assert.That(lines[head], Is.EqualTo(FormattableString.Invariant(
                $"Monarch: {1000000 * model.Mass:0.##} mg, wings {1000 * model.Length:0.#} mm, beat {model.Frequency:0.##} Hz")));
            Assert.That(model.Mass, Is.InRange(2e-4, 1e-3), "half a gramme");
            Assert.That(lines[head + 1], Is.EqualTo(string.Join("  ", m_Lines[0].Split(',')[..11])));
            for (int k = 1; k < m_Lines.Length; k++)
            {
                string[] cells = lines[head + 1 + k].Split(' ', StringSplitOptions.RemoveEmptyEntries), own = m_Lines[k].Split(',');
                int filled = own[..11].Count(cell => cell.Length > 0);
                Assert.That(cells[..filled], Is.EqualTo(own[..11].Where(cell => cell.Length > 0)));
                Assert.That(lines[head + 1 + k], own[2] == "yes" ? Does.EndWith("  ") : Does.Contain("lift is"));
            }

            Assert.That(lines, Does.Contain($"{Path.Combine(m_Run.Out, "trim.svg")}, {Path.Combine(m_Run.Out, "trim.csv")}"));
        }

        [Test]
        public void TheSourceOfATable_TellsTheAirOfItsTrims() => Assert.That(
            new[] { TrimCommand.Asked(null), TrimCommand.Asked(new TrimWake()), TrimCommand.Asked(new TrimWake { HasWideCores = true }) },
            Is.EqualTo(new[] { " --still-air", "", " --wide-cores" }));

        [Test]
        public void WideCores_AreNotThoseOfStillAir()
        {
            using var run = new CommandRun();
            Assert.That(run.Run("trim", "monarch", "--still-air", "--wide-cores", "--out", run.Out), Is.EqualTo(2));
            Assert.That(run.Errors.Trim(), Does.EndWith("give one of them.").And.Contain("--wide-cores").And.Contain("--still-air"));
            Assert.That(Directory.Exists(run.Out), Is.False);
        }

        [Test]
        public void WithWideCores_ASwallowtailFliesSlowlyInItsOwnAir()
        {
            // Not into the folder whose pages are looked at: that of one point is empty.
            using var run = new CommandRun();
            string wide = Path.Combine(run.Folder, "wide"), slender = Path.Combine(run.Folder, "slender");
            string[] slow = ["trim", "swallowtail", "--speeds", "0.15", "--climbs", "0", "--out"];
            Assert.That(run.Run([.. slow, wide, "--wide-cores"]), Is.Zero, run.Errors);
            string[] lines = File.ReadAllLines(Path.Combine(wide, "trim.csv"));

            Assert.That(run.Output, Does.Not.Contain("another one in each beat"));
            Assert.That(lines, Has.Length.EqualTo(2));
            AssertCloses(lines[1]);
            Assert.That(run.Run([.. slow, slender]), Is.EqualTo(2), "slender cores: a wake that does not repeat");
            Assert.That(run.Errors, Does.Contain("0.15 m/s ahead, 0 m/s up: does not close in the air of its wake."));
        }

        [Test]
        public void Picture_HasACurveOfThePower()
        {
            var svg = XElement.Load(Path.Combine(m_Run.Out, "trim.svg"));
            Assert.That(svg.Descendants().Select(part => part.Value), Has.Some.EqualTo("Power to the air, mW"));
        }

        private double Number(string line, string column) => double.Parse(Cell(line, column), CultureInfo.InvariantCulture);

        private string Cell(string line, string column) => line.Split(',')[Array.IndexOf(m_Lines[0].Split(','), column)];
    }
}
