using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Samples;
using MathNet.Numerics.Statistics;
using NUnit.Framework;

namespace Alate.Tests.Samples;

/// <summary>The votes of the comparison sample and what they mean.</summary>
public sealed class StudyStatisticsTests
{
    [Test]
    public void StudentT_IsMathNets(
        [Values(1, 2, 3, 10, 159, 5000)] int degreesOfFreedom, [Values(0, 0.01, 0.5, 1, 1.96, 3, 12, 40)] double t)
    {
        double expected = 2 * BelowOf(-t, degreesOfFreedom);
        Assert.That(Alate.Samples.StudentT.TwoTailed(t, degreesOfFreedom), Is.EqualTo(expected).Within(1e-12 + 1e-9 * expected));
        Assert.That(
            Alate.Samples.StudentT.TwoTailed(-t, degreesOfFreedom), Is.EqualTo(Alate.Samples.StudentT.TwoTailed(t, degreesOfFreedom)));
    }

    [Test]
    public void TTest_OfRandomSamples_IsMathNets()
    {
        var random = new Random(7);
        for (int round = 0; round < 200; round++)
        {
            double[] sample = [.. Enumerable.Range(0, random.Next(2, 60)).Select(_ => random.NextDouble() * 4 - 1)];
            double expected = random.NextDouble();
            var test = new OneSampleTTest(sample, expected);
            double t = (sample.Mean() - expected) / (sample.StandardDeviation() / Math.Sqrt(sample.Length));
            Assert.That(test.T, Is.EqualTo(t).Within(1e-9).Percent);
            Assert.That(test.P, Is.EqualTo(2 * BelowOf(-Math.Abs(t), sample.Length - 1)).Within(1e-9));
        }
    }

    [TestCase(152, 8)]
    [TestCase(144, 16)]
    [TestCase(136, 24)]
    public void TheVotesOfThePaper_AreBeyondChance(int forOne, int forOther)
    {
        double[] votes = [.. Enumerable.Repeat(1.0, forOne), .. Enumerable.Repeat(0.0, forOther)];
        Assert.That(new OneSampleTTest(votes, 0.5).P, Is.LessThan(0.001));
    }

    [Test]
    public void EvenVotes_AreChance_AndUnanimousOnesAreNot()
    {
        Assert.That(new OneSampleTTest([1, 0, 1, 0], 0.5).P, Is.EqualTo(1).Within(1e-12));
        Assert.That(new OneSampleTTest([1, 1, 1], 0.5).P, Is.Zero);
        Assert.That(new OneSampleTTest([0.5, 0.5], 0.5).P, Is.EqualTo(1).Within(1e-12));
        Assert.That(() => new OneSampleTTest([1], 0.5), Throws.ArgumentException.With.Message.Contains("2 values"));
        Assert.That(() => Alate.Samples.StudentT.TwoTailed(double.NaN, 3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => Alate.Samples.StudentT.TwoTailed(1, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void AStudy_ShowsEveryPairOfEverySpeciesOnce_OnRandomSides()
    {
        string[] species = ["a", "b", "c", "d"];
        ComparisonColumn[] methods = [ComparisonColumn.RigidWing, ComparisonColumn.NoWave, ComparisonColumn.FullModel];
        int fullOnTheLeft = 0, fullShown = 0;
        var orders = new HashSet<string>();
        for (int seed = 0; seed < 100; seed++)
        {
            var study = new PairStudy(species, methods, "x", new Random(seed));
            Assert.That(study.Count, Is.EqualTo(12));
            var votes = new List<Vote>();
            while (!study.IsOver)
                votes.Add(study.Choose(left: true));
            orders.Add(string.Join(" ", votes.Select(vote => vote.Species + vote.Left + vote.Right)));
            foreach (string kind in species)
            {
                for (int one = 0; one < 3; one++)
                {
                    for (int other = one + 1; other < 3; other++)
                    {
                        Assert.That(votes.Count(vote => vote.Species == kind && vote.IsBetween(methods[one].Name, methods[other].Name)),
                            Is.EqualTo(1));
                    }
                }
            }

            Assert.That(votes.All(vote => vote.Chosen == vote.Left), Is.True);
            fullShown += votes.Count(vote => vote.Left == "full" || vote.Right == "full");
            fullOnTheLeft += votes.Count(vote => vote.Left == "full");
            Assert.That(() => study.Choose(true), Throws.InvalidOperationException);
        }

        Assert.That(orders, Has.Count.EqualTo(100));
        Assert.That(fullOnTheLeft / (double)fullShown, Is.EqualTo(0.5).Within(0.06));
    }

    [Test]
    public void Votes_AreReadAsTheyWereWritten()
    {
        var file = new VoteFile(Path.Combine(Path.GetTempPath(), Path.GetRandomFileName(), "votes.csv"));
        Assert.That(file.Read(), Is.Empty);
        Vote[] given = [new("p1", "monarch", "full", "rigid", "full"), new("p1", "firefly", "no-wave", "full", "no-wave"),
            new("p2", "monarch", "rigid", "full", "full")];
        foreach (Vote vote in given)
            file.Add(vote);
        Assert.That(file.Read(), Is.EqualTo(given));

        var result = new PairResult(ComparisonColumn.FullModel, ComparisonColumn.RigidWing, file.Read());
        Assert.That((result.VotesForOne, result.Count), Is.EqualTo((2, 2)));
        Assert.That(result.ToString(), Is.EqualTo("Full model 2 : 0 Rigid wing, p < 0.001"));

        File.AppendAllText(file.Path, "2026-01-01,p3,monarch,full,rigid,other\n");
        Assert.That(file.Read, Throws.InstanceOf<FormatException>().With.Message.Contains("line 5").And.Message.Contains("other"));
        Directory.Delete(Path.GetDirectoryName(file.Path), true);
    }

    private static double BelowOf(double t, double degreesOfFreedom) =>
        MathNet.Numerics.Distributions.StudentT.CDF(0, 1, degreesOfFreedom, t);
}
