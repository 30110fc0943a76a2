using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Alate.Tests.Cli
{
    /// <summary>Options are checked as typed: the message has the option, its value, and the range that holds for the species.</summary>
    public sealed class TypedRangeTests
    {
        private CommandRun m_Run;

        [SetUp]
        public void MakeFolder() => m_Run = new CommandRun();

        [TearDown]
        public void RemoveFolder() => m_Run.Dispose();

        [TestCase(
            "--elasticity must lie between 0.001 and 500000 for firefly; it is 1000000.", "fly", "firefly", "--elasticity", "1000000")]
        [TestCase(
            "--elasticity must lie between 0.00142858 and 1000000 for firefly, expressive; it is 0.001.",
            "fly", "firefly", "--variant", "expressive", "--elasticity", "0.001")]
        [TestCase("--elasticity must lie between 0.001 and 71428.5 for snailfish; it is 100000.", "compare", "snailfish",
            "--elasticity", "100000")]
        [TestCase("--elasticity must lie between 0.002 and 1000000 for fishfly; it is 0.001.", "compare", "monarch", "fishfly",
            "--elasticity", "0.001")]
        [TestCase("FROM must lie between 0.002 and 1000000 for elasticity of fishfly; it is 0.001.", "sweep", "elasticity", "0.001", "1")]
        [TestCase("TO must lie between 0.001 and 500000 for elasticity of firefly; it is 600000.", "sweep", "elasticity", "1", "600000",
            "--species", "firefly")]
        [TestCase("--elasticity must lie between 0.001 and 1000000; it is 2000000.", "fly", "firefly", "--elasticity", "2000000")]
        public void ProductOutOfTheModelsRange_IsToldAsTyped(string said, params string[] arguments) => AssertRefused(said, arguments);

        [TestCase("FROM must lie between -85 and 90 for mean-flap of swallowtail; it is -90.", "mean-flap", "-90", "0", "swallowtail")]
        [TestCase("TO must lie between 1.11629E-09 and 0.673913 for wing-mass of swallowtail; it is 0.9.", "wing-mass", "0.001", "0.9",
            "swallowtail")]
        public void OtherWingOutOfItsRange_IsToldAsTyped(string said, string parameter, string from, string to, string species) =>
            AssertRefused(said, "sweep", parameter, from, to, "--species", species);

        [Test]
        public void NumberMadeOfSeveral_IsToldAsTyped()
        {
            // Air of so much more mass than the wing that it is beyond what the model takes.
            AssertRefused("for wing-mass of monarch; it is 1E-09.", "sweep", "wing-mass", "1e-9", "1e-4", "--species", "monarch");
        }

        [TestCase("fishfly", "standard", "0.1", Explicit = true, Category = "Long")]
        [TestCase("firefly", "standard", "0.1", Category = "Long", Explicit = true)]
        [TestCase("firefly", "expressive", "0.1", Category = "Long", Explicit = true)]
        [TestCase("snailfish", "expressive", "0.5", Category = "Long", Explicit = true)]
        public void BothEndsOfTheToldRange_AreTaken(string species, string variant, string seconds)
        {
            foreach (string typed in new[] { "0.001", "1000000" })
            {
                string value = typed;
                if (Fly(species, variant, value, seconds) != 0)
                {
                    Match told = Regex.Match(m_Run.Errors, @"between (\S+) and (\S+) for " + species);
                    Assert.That(told.Success, m_Run.Errors);
                    value = told.Groups[typed == "0.001" ? 1 : 2].Value;
                    using var again = new CommandRun();
                    int code = again.Run("fly", species, "--variant", variant, "--elasticity", value, "--no-pictures", "--seconds", seconds,
                        "--out", again.Out);
                    Assert.That(code, Is.Zero, again.Errors);
                }
            }
        }

        private int Fly(string species, string variant, string elasticity, string seconds)
        {
            m_Run.Dispose();
            m_Run = new CommandRun();
            return m_Run.Run("fly", species, "--variant", variant, "--elasticity", elasticity, "--no-pictures", "--seconds", seconds,
                "--out", m_Run.Out);
        }

        private void AssertRefused(string said, params string[] arguments)
        {
            int code = m_Run.Run([.. arguments, "--out", m_Run.Out]);

            Assert.That(code, Is.EqualTo(2), m_Run.Errors);
            Assert.That(m_Run.Errors.Split('\n'), Has.Length.EqualTo(2), "one line: " + m_Run.Errors);
            Assert.That(m_Run.Errors, Does.Contain(said));
            Assert.That(Directory.Exists(m_Run.Out), Is.False, "nothing was written");
        }
    }
}
