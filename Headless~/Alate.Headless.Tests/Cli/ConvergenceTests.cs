using System.Globalization;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Files that the command <c>convergence</c> writes. The cost depends on the machine and is not checked.</summary>
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public sealed class ConvergenceTests
    {
        private CommandRun m_Run;
        private string[][] m_Rows;

        [OneTimeSetUp]
        public void MeasureAMonarch()
        {
            m_Run = new CommandRun();
            int code = m_Run.Run("convergence", "monarch", "Monarch", "--out", m_Run.Out);
            Assert.That(code, Is.Zero, m_Run.Errors);
            m_Rows = File.ReadAllLines(Path.Combine(m_Run.Out, "convergence.csv")).Select(line => line.Split(',')).ToArray();
        }

        [OneTimeTearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [Test]
        public void Folder_HoldsThePictureAndTheTable() => Assert.That(
            Directory.GetFileSystemEntries(m_Run.Out).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "convergence.svg", "convergence.csv" }));

        [Test]
        public void Table_HasARowForEachSchemeAndNumberOfSubsteps_AndOneForVersion01()
        {
            Assert.That(string.Join(',', m_Rows[0]), Is.EqualTo(
                "species,variant,wing,model,scheme,substeps,joint_error_pct,cost_over_version_0_1,is_default"));
            Assert.That(m_Rows.Skip(1).Select(row => string.Join(' ', row.Take(6))), Is.EqualTo(
                (from scheme in new[] { "second-order", "backward-euler" }
                 from substeps in new[] { 12, 16, 24, 32, 48, 96 }
                 select $"monarch standard wing now {scheme} {substeps}").Append("monarch standard wing 0.1 backward-euler 24")));
        }

        [TestCase("second-order")]
        [TestCase("backward-euler")]
        public void Error_FallsWithMoreSubsteps(string scheme)
        {
            Assert.That(Errors(scheme), Is.Ordered.Descending);
            Assert.That(Errors(scheme)[5], Is.LessThan(0.25 * Errors(scheme)[0]));
        }

        [Test]
        public void SecondOrder_IsNearerToItsLimitThanBackwardEuler()
        {
            double[] second = Errors("second-order"), first = Errors("backward-euler");

            Assert.That(second.Zip(first, (a, b) => a / b), Is.All.LessThan(0.5));
        }

        [Test]
        public void Picture_HasBothSchemes_TheDefaults_AndVersion01()
        {
            var svg = XElement.Load(Path.Combine(m_Run.Out, "convergence.svg"));
            XNamespace space = "http://www.w3.org/2000/svg";
            string[] texts = svg.Elements(space + "text").Select(text => text.Value).ToArray();

            Assert.That(texts,
                Is.SupersetOf(new[] { "Monarch", "second order (default)", "backward Euler", "default substeps", "version 0.1", "wing" }));
            Assert.That(texts, Has.None.EqualTo("hind wing"));
            Assert.That(svg.Elements(space + "path").Count(path => path.Attribute("clip-path") != null), Is.EqualTo(2));
        }

        [Test]
        public void Terminal_ShowsTheValuesBesideTheirLimits()
        {
            Assert.That(m_Run.Output, Does.Contain("(default)").And.Contain("at 480").And.Contain("lift over weight at pitch 30°").And
                .Contain("convergence.csv"));
        }

        private double[] Errors(string scheme) => m_Rows.Where(row => row[3] == "now" && row[4] == scheme)
            .Select(row => double.Parse(row[6], CultureInfo.InvariantCulture)).ToArray();
    }
}
