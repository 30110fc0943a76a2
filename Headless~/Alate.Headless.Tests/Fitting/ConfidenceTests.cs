using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Authoring;
using Alate.Cli;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Alate.Tests
{
    /// <summary>
    /// Rate at which guesses of a confidence are right: over drawn wings of four kinds, turned and mirrored at random, without any hint.
    /// </summary>
    public abstract class ConfidenceLaws
    {
        private const float k_Near = 0.2f;

        private static readonly double[] s_Bounds = [0, 0.5, 0.6, 0.7, 0.8, 1.001];

        private readonly int m_Wings;
        private readonly List<(double Confidence, bool IsRight)> m_Fits = [], m_Traces = [];
        private readonly Dictionary<OutlineKind, int> m_TracedHinges = [];

        /// <param name="wings">Number of wings of each kind.</param>
        protected ConfidenceLaws(int wings) => m_Wings = wings;

        [OneTimeSetUp]
        public void GuessAll()
        {
            foreach (OutlineKind kind in Enum.GetValues<OutlineKind>())
            {
                for (int seed = 0; seed < m_Wings; seed++)
                    Guess(kind, seed);
            }
        }

        [Test]
        public void Confidence_IsHowOftenHingeAndLeadingEdgeAreRight() => AssertCalibrated(m_Fits);

        [Test]
        public void ConfidenceOfAHingeGuessedInAPicture_IsHowOftenItIsRight() => AssertCalibrated(m_Traces);

        [Test]
        public void AMoreConfidentFit_IsRightMoreOften()
        {
            double sure = Share(m_Fits.Where(fit => fit.Confidence >= 0.7)), unsure = Share(m_Fits.Where(fit => fit.Confidence < 0.6));

            Assert.That(sure, Is.GreaterThan(unsure + 0.15));
        }

        [TestCase(OutlineKind.Butterfly, 85)]
        [TestCase(OutlineKind.HindWing, 70)]
        [TestCase(OutlineKind.Slender, 50)]
        [TestCase(OutlineKind.Oval, 75)]
        public void HingeGuessedFromAnOutline_IsRightSoOften(OutlineKind kind, int least) =>
            Assert.That(100.0 * m_TracedHinges[kind] / m_Wings, Is.GreaterThanOrEqualTo(least), kind.ToString());

        private static void AssertCalibrated(List<(double Confidence, bool IsRight)> guesses)
        {
            foreach ((string Name, List<(double Confidence, bool IsRight)> Guesses) bin in Bins(guesses)
                .Where(bin => bin.Guesses.Count >= 30))
            {
                double told = bin.Guesses.Average(guess => guess.Confidence);
                Assert.That(Share(bin.Guesses), Is.EqualTo(told).Within(0.2), $"{bin.Name}: {bin.Guesses.Count} guesses");
            }
        }

        /// <summary>Rows of the manual's table.</summary>
        protected IEnumerable<string> Rows() => Bins(m_Fits).Zip(
            Bins(m_Traces), (fit, trace) => $"| {fit.Name} | {Cell(fit.Guesses)} | {Cell(trace.Guesses)} |");

        private static string Cell(IReadOnlyCollection<(double, bool IsRight)> guesses) =>
            guesses.Count == 0 ? "none" : FormattableString.Invariant($"{100.0 * Share(guesses):0} % of {guesses.Count}");

        private static IEnumerable<(string Name, List<(double Confidence, bool IsRight)> Guesses)> Bins(
            List<(double Confidence, bool IsRight)> guesses)
        {
            for (int k = 0; k + 1 < s_Bounds.Length; k++)
            {
                double low = s_Bounds[k], high = s_Bounds[k + 1];
                string name = FormattableString.Invariant($"{low:0.0} to {Math.Min(high, 1.0):0.0}");
                yield return (name, guesses.Where(guess => guess.Confidence >= low && guess.Confidence < high).ToList());
            }
        }

        private static double Share(IEnumerable<(double, bool IsRight)> guesses) => guesses.Average(guess => guess.IsRight ? 1.0 : 0.0);

        private void Guess(OutlineKind kind, int seed)
        {
            var random = new Random(seed);
            Vector2[] outline = InsectOutlines.Make(kind, seed);
            var wing = new DrawnInsectWing(outline, 360f * (float)random.NextDouble(), random.Next(2) == 0);
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.forward = null;
            hints.isOriginUnknown = true;
            SkeletonFit fit = SkeletonFitter.Fit(wing.Surface, hints);
            m_Fits.Add((fit.Confidence, fit.Skeleton.GetJoint(0, 0).magnitude < k_Near && wing.Leads(fit.Skeleton)));

            (PlanPoint Place, double Confidence) end = PointedEnd.Of(wing.Plan);
            bool isNear = Math.Sqrt(end.Place.LengthSquared) < k_Near;
            m_Traces.Add((end.Confidence, isNear));
            m_TracedHinges[kind] = m_TracedHinges.GetValueOrDefault(kind) + (isNear ? 1 : 0);
        }
    }

    /// <summary>Confidence over a few wings of each kind.</summary>
    public sealed class ConfidenceTests : ConfidenceLaws
    {
        public ConfidenceTests()
            : base(wings: 10)
        {
        }
    }

    /// <summary>Confidence over as many wings of each kind as the manual's table tells of.</summary>
    [Explicit]
    [Category("Long")]
    public sealed class ToldConfidenceTests : ConfidenceLaws
    {
        public ToldConfidenceTests()
            : base(wings: 100)
        {
        }

        [Test]
        public void TheManualsTable_HasTheseShares()
        {
            string[] rows = File.ReadLines(Path.Combine(PackageRoot.Find(), "Documentation~", "results.md"))
                .SkipWhile(line => !line.StartsWith("| confidence | ")).Skip(2).TakeWhile(line => line.StartsWith('|')).ToArray();

            Assert.That(rows, Is.EqualTo(Rows().ToArray()), "the rows are:\n" + string.Join("\n", Rows()));
        }
    }
}
