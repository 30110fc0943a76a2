using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;

namespace Alate.Tests.Cli;

/// <summary>Laws of the designs of studies, and of what is made of their runs.</summary>
public sealed class StudyDesignLaws
{
    [Test]
    public void TheSobolSequence_BeginsAsItsAuthorsPrintIt()
    {
        var sequence = new SobolSequence(3);
        double[][] points = Enumerable.Range(0, 8).Select(_ => sequence.Next()).ToArray();
        Assert.That(points, Is.EqualTo(new double[][]
        {
            [0, 0, 0], [0.5, 0.5, 0.5], [0.75, 0.25, 0.25], [0.25, 0.75, 0.75], [0.375, 0.375, 0.625], [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875], [0.125, 0.625, 0.375],
        }));
    }

    [Test]
    public void AnyPowerOfTwoOfItsPoints_HasOneInEachEqualPart_OfEachDimension([Values(16, 256)] int count)
    {
        var sequence = new SobolSequence(SobolSequence.MostDimensions);
        double[][] points = Enumerable.Range(0, count).Select(_ => sequence.Next()).ToArray();
        for (int k = 0; k < SobolSequence.MostDimensions; k++)
        {
            IEnumerable<int> parts = points.Select(point => (int)(point[k] * count));
            Assert.That(parts.Order(), Is.EqualTo(Enumerable.Range(0, count)), $"dimension {k}");
        }

        for (int k = 1; count == 256 && k < SobolSequence.MostDimensions; k++)
        {
            for (int other = 0; other < k; other++)
                Assert.That(points.Count(point => point[k] != point[other]), Is.AtLeast(count / 2), $"{other} and {k} are alike");
        }
    }

    // In two dimensions a net: one point in each of the rectangles of one area, whatever their shape.
    [Test]
    public void ItsFirstTwoDimensions_AreANet()
    {
        var sequence = new SobolSequence(2);
        double[][] points = Enumerable.Range(0, 64).Select(_ => sequence.Next()).ToArray();
        for (int across = 1; across <= 64; across *= 2)
        {
            Assert.That(points.Select(point => ((int)(point[0] * across), (int)(point[1] * (64 / across)))).Distinct().Count(),
                Is.EqualTo(64), $"{across} columns");
        }
    }

    [Test]
    public void ALatinHypercube_HasOnePointInEachEqualPart_OfEachDimension_AndChangesWithItsSeed([Values(1u, 2u, 77u)] uint seed)
    {
        double[][] points = StudyDesign.Hypercube(50, 4, seed);
        for (int k = 0; k < 4; k++)
            Assert.That(points.Select(point => (int)(point[k] * 50)).Order(), Is.EqualTo(Enumerable.Range(0, 50)));
        Assert.That(points, Is.EqualTo(StudyDesign.Hypercube(50, 4, seed)).And.Not.EqualTo(StudyDesign.Hypercube(50, 4, seed + 1)));
        Assert.That(points.Select(point => (int)(point[0] * 50)), Is.Not.EqualTo(points.Select(point => (int)(point[1] * 50))));
    }

    [Test]
    public void AGrid_TakesEachValueWithEach_TheLastFastest()
    {
        double[][] points = StudyDesign.Points(StudyDesign.Grid, 0, 1, [Parameter(1, 2), Parameter(3, 4, 5)]);
        Assert.That(points, Is.EqualTo(new double[][] { [1, 3], [1, 4], [1, 5], [2, 3], [2, 4], [2, 5] }));
        Assert.That(StudyDesign.Runs(StudyDesign.Grid, 0, [Parameter(1, 2), Parameter(3, 4, 5)]), Is.EqualTo(6));
        Assert.That(StudyDesign.Runs(StudyDesign.Grid, 0, Enumerable.Repeat(Parameter(new double[1000]), 10).ToList()), Is.Positive);
    }

    [TestCase(StudyDesign.LatinHypercube)]
    [TestCase(StudyDesign.Sobol)]
    [TestCase(StudyDesign.Saltelli)]
    public void Values_LieBetweenTheirEnds_AtEqualRatiosWhereThatIsAsked(string design)
    {
        var ratio = new StudyParameter("elasticity", 0.1, 10, true, false, []);
        var whole = new StudyParameter("substeps", 24, 96, false, true, []);
        double[][] points = StudyDesign.Points(design, 64, 1, [ratio, whole]);
        Assert.That(points, Has.Length.EqualTo(StudyDesign.Runs(design, 64, [ratio, whole])));
        Assert.That(points.Select(point => point[0]), Has.All.InRange(0.1, 10));
        Assert.That(points.Count(point => point[0] < 1), Is.EqualTo(points.Length / 2).Within(2));
        Assert.That(points.Select(point => point[1]), Has.All.InRange(24, 96));
        Assert.That(points.Select(point => point[1] % 1), Has.All.Zero);
    }

    // Ishigami and Homma 1990; the indices are integrals that can be done by hand.
    [Test]
    public void ShareOfTheVariance_OfIshigamisFunction_AreThoseOfItsIntegrals()
    {
        const double k_A = 7, k_B = 0.1;
        double pi4 = Math.Pow(Math.PI, 4), pi8 = pi4 * pi4;
        double one = 0.5 * Math.Pow(1 + k_B * pi4 / 5, 2), two = k_A * k_A / 8, both = k_B * k_B * pi8 * (1.0 / 18 - 1.0 / 50);
        double all = one + two + both;
        double[] values = StudyDesign.SaltelliPoints(4096, 3).Select(share =>
        {
            double[] x = Array.ConvertAll(share, one => Math.PI * (2 * one - 1));
            return Math.Sin(x[0]) + k_A * Math.Pow(Math.Sin(x[1]), 2) + k_B * Math.Pow(x[2], 4) * Math.Sin(x[0]);
        }).ToArray();
        Sensitivity[] found = Sensitivity.Of(values, 3);
        Assert.That(found.Select(share => share.First), Is.EqualTo(new[] { one / all, two / all, 0 }).Within(0.01));
        Assert.That(found.Select(share => share.Total), Is.EqualTo(new[] { (one + both) / all, two / all, both / all }).Within(0.01));
    }

    // A sphere, an ellipsoid whose axes differ by a thousand and are turned, and a bent valley.
    [TestCase("sphere", 2, 300)]
    [TestCase("sphere", 6, 900)]
    [TestCase("ellipsoid", 4, 2600)]
    [TestCase("valley", 2, 700)]
    [TestCase("corner", 3, 600)]
    public void ASearch_FindsTheLowestPoint(string landscape, int dimensions, int runs)
    {
        foreach (uint seed in new uint[] { 1, 2, 3 })
        {
            var strategy = new EvolutionStrategy(dimensions, seed);
            double best = double.PositiveInfinity;
            for (int run = 0; run < runs; run += strategy.Size)
            {
                double[] heights = Array.ConvertAll(strategy.Ask(), point => Height(landscape, point));
                best = Math.Min(best, heights.Min());
                strategy.Tell(Enumerable.Range(0, heights.Length).OrderBy(k => heights[k]).ToArray());
            }

            Assert.That(best, Is.LessThan(1e-8), $"seed {seed}");
        }
    }

    // Orders alone count: heights that are stretched or shifted give the same points.
    [Test]
    public void ASearch_AsksForTheSame_WhateverTheScaleOfWhatItMeasures()
    {
        EvolutionStrategy one = new EvolutionStrategy(3, 5), other = new EvolutionStrategy(3, 5);
        for (int generation = 0; generation < 20; generation++)
        {
            double[][] points = one.Ask(), same = other.Ask();
            Assert.That(points, Is.EqualTo(same));
            Assert.That(points.SelectMany(point => point), Has.All.InRange(0, 1));
            one.Tell(Enumerable.Range(0, points.Length).OrderBy(k => Height("sphere", points[k])).ToArray());
            other.Tell(Enumerable.Range(0, points.Length).OrderBy(k => Math.Exp(3 * Height("sphere", points[k])) - 7).ToArray());
        }
    }

    [Test]
    public void AxesOfAMatrix_MakeItAgain([Range(1, 8)] int size)
    {
        var random = new Random(size);
        double[,] matrix = new double[size, size], axes = new double[size, size];
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j <= i; j++)
                matrix[i, j] = matrix[j, i] = random.NextDouble() - 0.5;
        }

        double[] values = new double[size];
        SymmetricMatrix.Diagonalize(matrix, axes, values);
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j < size; j++)
            {
                double made = Enumerable.Range(0, size).Sum(k => axes[i, k] * values[k] * axes[j, k]),
                    product = Enumerable.Range(0, size).Sum(k => axes[k, i] * axes[k, j]);
                Assert.That(made, Is.EqualTo(matrix[i, j]).Within(1e-12));
                Assert.That(product, Is.EqualTo(i == j ? 1 : 0).Within(1e-12));
            }
        }
    }

    [Test]
    public void AGoal_TakesBoundsFirst_ThenTheMeasure_AndMissingNumbersLast()
    {
        var goal = new StudyGoal("lift", true, [new StudyBound("power", double.NegativeInfinity, 10), new StudyBound("twist", 1, 2)]);
        StudyRow[] rows =
        [
            new(0, [9, 11, 1.5], null), new(1, [5, 10, 1], null), new(2, [6, 1, 2], null), new(3, [99, 10, 4], null),
            new(4, [double.NaN, 0, 1.5], "no"), new(5, [6, 1, 2], null),
        ];
        Assert.That(goal.Order(rows, ["lift", "power", "twist"]), Is.EqualTo(new[] { 2, 5, 1, 0, 3, 4 }));
        Assert.That(rows.Select(row => goal.Holds(row, ["lift", "power", "twist"])),
            Is.EqualTo(new[] { false, true, true, false, false, true }));
    }

    // Over the size of the end that is missed; of an end at nought in units.
    [TestCase(1, 2, 1.5, 0)]
    [TestCase(4, 8, 3, 0.25)]
    [TestCase(4, 8, 10, 0.25)]
    [TestCase(-4, 8, -6, 0.5)]
    [TestCase(0, 8, -3, 3)]
    public void ABound_TellsByWhatShareItIsMissed(double least, double most, double value, double missed) =>
        Assert.That(new StudyBound("lift", least, most).MissedBy(value), Is.EqualTo(missed));

    [Test]
    public void AMeasure_IsOfTheFirstWing_OrOfTheWingBeforeTheDot()
    {
        InsectDefinition dragonfly = InsectCatalogue.Find("dragonfly");
        string ofWing = StudyMeasure.Names.Last();

        Assert.That(StudyMeasure.Find(ofWing, dragonfly).Name, Is.EqualTo(ofWing));
        Assert.That(StudyMeasure.Find($"{dragonfly.Wings[1].Name}.{ofWing}", dragonfly), Is.Not.Null);
        Assert.That(StudyMeasure.Find("." + ofWing, dragonfly), Is.Null, "no wing has that name");
        Assert.That(StudyMeasure.Find("fin." + ofWing, dragonfly), Is.Null);
        Assert.That(StudyMeasure.Names.Select(name => StudyMeasure.Find(name, dragonfly).Title), Is.Unique);
        Assert.That(StudyMeasure.Find("hind wing.lag_deg", dragonfly).Title, Is.EqualTo("hind wing: lag of the trailing edge, °"));
        Assert.That(StudyMeasure.Find("positive_power_w", dragonfly).Title, Is.EqualTo("positive power, W"));
    }

    private static double Height(string landscape, double[] point)
    {
        double[] x = Array.ConvertAll(point, share => share - 0.37);
        return landscape switch
        {
            "sphere" => x.Sum(axis => axis * axis),
            "corner" => point.Sum(),
            "valley" => Math.Pow(4 * x[0] - 0.4, 2) + 100 * Math.Pow(4 * x[1] - 0.1 - 2 * (4 * x[0] - 0.4) * (4 * x[0]), 2),
            _ => Enumerable.Range(0, x.Length).Sum(k => Math.Pow(1e6, k / (x.Length - 1.0))
                * Math.Pow(x[k] + 0.5 * x[(k + 1) % x.Length], 2)),
        };
    }

    [Test]
    public void TheBestCompromises_AreThoseThatNoOtherBeats([Range(1, 5)] int seed)
    {
        var random = new Random(seed);
        double[] most = Enumerable.Range(0, 60).Select(_ => (double)random.Next(12)).ToArray(),
            least = Enumerable.Range(0, 60).Select(k => k % 9 == 0 ? double.NaN : random.Next(12)).ToArray();
        List<int> front = ParetoFront.Of(most, least);
        IEnumerable<int> flown = Enumerable.Range(0, 60).Where(k => double.IsFinite(least[k]));
        Assert.That(front.Select(k => (most[k], least[k])).Order(), Is.EqualTo(flown.Where(k => !flown.Any(other =>
                most[other] >= most[k] && least[other] <= least[k] && (most[other] > most[k] || least[other] < least[k])))
            .Select(k => (most[k], least[k])).Distinct().Order()));
        Assert.That(front.Select(k => most[k]), Is.Ordered.Descending);
    }

    [Test]
    public void Parts_HoldEachRunOnce_AndSoDoTheirWorkers([Values(1, 2, 7, 13)] int count, [Values(1, 3)] int workers)
    {
        IEnumerable<StudyShard> parts = Enumerable.Range(1, count).Select(number => new StudyShard(number, count));
        Assert.That(parts.SelectMany(part => part.Runs(50)).Order(), Is.EqualTo(Enumerable.Range(0, 50)));
        foreach (StudyShard part in parts)
        {
            Assert.That(part.Split(workers).SelectMany(worker => worker.Runs(50)).Order(), Is.EqualTo(part.Runs(50)));
            Assert.That(StudyShard.TryParse(part.ToString(), out StudyShard read) && read == part);
        }
    }

    [TestCase("0/3")]
    [TestCase("4/3")]
    [TestCase("1")]
    [TestCase("1/2/3")]
    [TestCase("-1/3")]
    [TestCase("a/b")]
    [TestCase("1/100001")]
    public void APartThatIsNone_IsRefused(string text) => Assert.That(StudyShard.TryParse(text, out _), Is.False);

    private static StudyParameter Parameter(params double[] values) => new("speed", values.Min(), values.Max(), false, false, values);
}
