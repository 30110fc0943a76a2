using System.Globalization;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Files that a comparison writes.</summary>
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
                Is.SupersetOf(new[] { "Monarch", "Rigid wing", "No deformation wave", "Full model", "Elasticity × 4", "0°", "180°" }));
            Assert.That(texts, Does.Contain(Of("monarch", "twist_pp_deg")[2].ToString("0.0", CultureInfo.InvariantCulture)));
            Assert.That(new FileInfo(Path.Combine(m_Run.Out, "monarch.png")).Length, Is.LessThan(300_000));
        }

        [Test]
        public void FreeFlight_CarriesItsWeight_AndBobs_WhereTheFlightOnTheSpotIsHeld()
        {
            string[][] rows = File.ReadAllLines(Path.Combine(m_Run.Out, "free-flight.csv")).Select(line => line.Split(',')).ToArray();
            double Of(string species, string flight, string measure) =>
                double.Parse(rows.Single(row => row[0] == species && row[1] == flight)[System.Array.IndexOf(rows[0], measure)],
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

        [Test]
        public void Terminal_ShowsTheDifferences()
        {
            Assert.That(
                m_Run.Output, Does.Contain("Full model").And.Contain("twist").And.Contain("Fishfly: hind wing").And.Contain("compare.csv"));
            Assert.That(m_Run.Output, Does.Contain("usual").And.Contain("10–50 *").And.Contain("0.00 †").And.Not.Contain("-0.00"),
                "a rigid wing neither twists nor lags");
        }

        private double[] Of(string species, string measure)
        {
            int column = System.Array.IndexOf(m_Rows[0], measure);
            return m_Rows.Where(row => row[0] == species).Select(row => double.Parse(row[column], CultureInfo.InvariantCulture)).ToArray();
        }
    }
}
