using System;
using System.Linq;
using NUnit.Framework;

namespace Alate.Tests.Insects;

/// <summary>Budget of the wings' time over crowds whose cost is that of their levels of detail, with frames that jitter.</summary>
public sealed class DetailBudgetTests
{
    private const int k_Insects = 300, k_Settle = 1500, k_Watch = 600;

    // Milliseconds of an insect: full, fewer substeps, coarse patches, waves only, at rest.
    private static readonly float[] s_Costs = [0.04f, 0.03f, 0.02f, 0.009f, 0f];

    [Test]
    public void TheTime_IsTheBudgets_WhereLevelsCanReachIt([Range(1, 3)] int seed, [Values(0.9f, 0.7f, 0.5f, 0.4f)] float share)
    {
        var crowd = new Crowd(seed);
        double free = crowd.Settle(0f), bound = crowd.Settle(share * (float)free);
        Assert.That(bound, Is.InRange(0.85 * share * free, 1.1 * share * free));
        Assert.That(
            crowd.Settle(0f), Is.InRange(0.95 * free, free), "without a bound all is as before, but for sizes near a level's threshold");
    }

    [Test]
    public void AHalvedBudget_HalvesTheTime([Range(1, 3)] int seed)
    {
        var crowd = new Crowd(seed);
        float budget = 0.8f * (float)crowd.Settle(0f);
        double whole = crowd.Settle(budget), half = crowd.Settle(0.5f * budget);
        Assert.That(half / whole, Is.EqualTo(0.5).Within(0.15 * 0.5));
    }

    [Test]
    public void TheNearest_KeepsItsDetail_FarOnesHaveLess_AndNobodyRests([Range(1, 3)] int seed)
    {
        var crowd = new Crowd(seed);
        crowd.Settle(0f);
        WingDetail[] own = [.. crowd.Details];
        crowd.Settle(0.01f);
        Assert.That(crowd.Details[crowd.Nearest], Is.EqualTo(own[crowd.Nearest]));
        Assert.That(crowd.Details.Zip(own).All(both => both.First >= both.Second));
        Assert.That(crowd.Details.Zip(own).All(both => both.First != WingDetail.Frozen || both.Second == WingDetail.Frozen));
        Assert.That(crowd.Details.Count(detail => detail == WingDetail.WavesOnly), Is.GreaterThan(k_Insects / 2));
    }

    [Test]
    public void LevelsAreKept_OnceTheBudgetIsMet([Range(1, 3)] int seed)
    {
        var crowd = new Crowd(seed);
        crowd.Settle(0.6f * (float)crowd.Settle(0f));
        Assert.That(crowd.Switches, Is.LessThan(0.01 * k_Insects * k_Watch / 60), "one insect of a hundred a second");
    }

    // One that comes nearer than the nearest of the last frame is not made larger than it is.
    [Test]
    public void TheNearest_CountsAsLargeAsItIs_AndOthersAsSmaller([Values(0.3f, 0.5f, 0.9f)] float nearest)
    {
        var budget = new DetailBudget();
        for (int frame = 0; frame < 200; frame++)
        {
            budget.Counted(0.3f);
            budget.Spend(5f);
            budget.EndFrame(1f);
        }

        Assert.That(budget.IsTight);
        Assert.That(budget.Counted(nearest), Is.EqualTo(nearest));
        Assert.That(budget.Counted(0.1f), Is.LessThan(0.09f));
        float last = 0f;
        for (float height = 0.01f; height < 1f; height += 0.01f)
        {
            Assert.That(budget.Counted(height), Is.GreaterThan(last).And.LessThanOrEqualTo(height), "larger ones count as larger");
            last = budget.Counted(height);
        }
    }

    [TestCase(-1f)]
    [TestCase(float.NaN)]
    [TestCase(float.PositiveInfinity)]
    public void ABudgetThatIsNone_IsRefused_AndTheLastCounts(float budget)
    {
        WingSystem.Budget = 2f;
        ArgumentOutOfRangeException refused = Assert.Throws<ArgumentOutOfRangeException>(() => WingSystem.Budget = budget);
        Assert.That(refused.Message, Does.Contain("0 or more and finite, milliseconds"));
        Assert.That(WingSystem.Budget, Is.EqualTo(2f));
        WingSystem.Budget = 0f;
    }

    /// <summary>Insects at distances of which each is as likely, that stand still.</summary>
    private sealed class Crowd
    {
        private static readonly ScreenHeights s_Levels = InsectQuality.Default.screenHeights;

        private readonly System.Random m_Random;
        private readonly float[] m_Heights;
        private readonly DetailBudget m_Budget = new();

        public Crowd(int seed)
        {
            m_Random = new System.Random(seed);
            m_Heights = [.. Enumerable.Range(0, k_Insects).Select(_ => 1f / (1.5f + 20f * m_Random.NextSingle()))];
            Details = new WingDetail[k_Insects];
            Nearest = Array.IndexOf(m_Heights, m_Heights.Max());
        }

        public WingDetail[] Details { get; }

        public int Nearest { get; }

        /// <summary>Switches of levels while the time was watched.</summary>
        public int Switches { get; private set; }

        /// <summary>Runs until the time has settled; returns it, milliseconds a frame.</summary>
        public double Settle(float budget)
        {
            double sum = 0.0;
            for (int frame = 0; frame < k_Settle + k_Watch; frame++)
            {
                if (frame == k_Settle)
                    (sum, Switches) = (0.0, 0);
                sum += Frame(budget);
            }

            return sum / k_Watch;
        }

        private float Frame(float budget)
        {
            float cost = 0f;
            for (int k = 0; k < k_Insects; k++)
            {
                WingDetail before = Details[k];
                Details[k] = LiveInsect.Choose(s_Levels, m_Heights[k], before, m_Budget);
                Switches += Details[k] == before ? 0 : 1;
                cost += s_Costs[(int)Details[k]];
            }

            // Frames with one fixed step, with two and with none.
            float spent = cost * 1.2f * m_Random.Next(6) / 3f;
            m_Budget.Spend(0.3f * spent);
            m_Budget.Spend(0.7f * spent);
            m_Budget.EndFrame(budget);
            return cost;
        }
    }
}
