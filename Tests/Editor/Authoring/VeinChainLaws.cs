using System;
using System.Linq;
using Alate.Authoring;
using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of chains along veins, on a half disc of radius 100 whose hinge is its middle.</summary>
    public sealed class VeinChainLaws
    {
        private const double k_Length = 100.0;

        private static readonly double[] s_Degrees = { 80.0, 40.0, 0.0, -40.0, -80.0 };

        [Test]
        public void AChainOnAVein_EndsAtTheRim_FourThousandthsOfTheLengthInside_AndLiesOnTheVein()
        {
            RadialVein[] veins = { Vein(80.0), null, Vein(0.0), null, Vein(-80.0) };
            VeinChains laid = Lay(veins);

            Assert.That(laid.Chains[2].Select(joint => joint.z), Is.All.EqualTo(0.0).Within(1e-6));
            Assert.That(Radius(laid.Chains[2][4]), Is.EqualTo(k_Length - 0.004 * k_Length).Within(0.02));
            for (int j = 1; j < 5; j++)
                Assert.That(laid.Chains[2][j].x - laid.Chains[2][j - 1].x, Is.EqualTo(99.6 / 4.0).Within(0.1), "evenly");
        }

        [Test]
        public void AChainBetweenTwoVeins_LiesHalfway_AndIsStretchedToTheRim_ButNoFartherThanThirtyFivePerCent()
        {
            VeinChains laid = Lay(new[] { Vein(80.0), null, Vein(0.0), null, Vein(-80.0) });
            foreach ((int chain, double degrees) in new[] { (1, 40.0), (3, -40.0) })
            {
                PlanPoint tip = laid.Chains[chain][4];
                Assert.That(Math.Atan2(tip.z, tip.x) * 180.0 / Math.PI, Is.EqualTo(degrees).Within(0.5));
                Assert.That(Radius(tip), Is.EqualTo(0.996 * k_Length).Within(0.3), "cos 40° of the way before");
                for (int j = 0; j < 5; j++)
                    Assert.That(Radius(laid.Chains[chain][j]), Is.EqualTo(j / 4.0 * Radius(tip)).Within(0.3));
            }

            // Between veins that lie 160° apart, half the way is cos 80° of the radius.
            VeinChains wide = Lay(new[] { Vein(80.0), null, null, null, Vein(-80.0) });
            Assert.That(Radius(wide.Chains[1][4]), Is.LessThan(0.996 * k_Length));
            PlanPoint first = Middle(Vein(80.0), Vein(-80.0), 0.25);
            Assert.That(Radius(wide.Chains[1][4]) / Radius(first), Is.EqualTo(1.35).Within(0.02));
        }

        [Test]
        public void ChainsWithoutVeinsBehind_AreTheFittedOnes()
        {
            VeinChains laid = Lay(new[] { null, Vein(40.0), null, null, null });
            foreach (int chain in new[] { 0, 2, 3, 4 })
            {
                Assert.That(laid.Chains[chain], Is.EqualTo(Fitted()[chain]));
                Assert.That(laid.Shares[chain], Is.Zero);
            }
        }

        [Test]
        public void VeinsThatShareAStretch_AreFollowedFromWhereTheyPart_ByAStraightBone()
        {
            // Both run along the middle for half the radius, and fork there.
            RadialVein up = Forked(0.5, 1.0), down = Forked(0.5, -1.0);
            VeinChains laid = Lay(new[] { null, up, null, down, null });
            double bridged = 1.0 - laid.Shares[1], whole = Polyline.LengthOf(up.Path);

            Assert.That(laid.Shares[3], Is.EqualTo(laid.Shares[1]).Within(0.01), "mirrored");
            Assert.That(bridged * whole, Is.InRange(50.0, 55.0), "the shared stretch, and until they are apart");
            Assert.That(laid.Chains[1][4].z, Is.GreaterThan(30.0));
            Assert.That(laid.Chains[3][4].z, Is.LessThan(-30.0));
        }

        // A vein that comes from beside the hinge is begun where it meets the base, a little within the rim; else at the fitted root.
        [Test]
        public void AChainBeginsWhereItsVeinDoes_WhereThatIsWanted_AndOnTheBase([Values] bool ownRoots, [Values(2.0, 30.0)] double beside)
        {
            var vein = new RadialVein(
                Enumerable.Range(0, 91).Select(k => new PlanPoint(k_Length * (0.05 + k / 100.0), beside)).ToArray(), 0.0, 1.0);
            PlanPoint[][] fitted = Fitted();
            PlanPoint root = VeinChains.Lay(fitted, new[] { null, null, vein, null, null }, Rim(), k_Length, ownRoots).Chains[2][0];

            if (ownRoots && beside < 3.0)
            {
                Assert.That(root.z, Is.EqualTo(beside).Within(1e-6));
                Assert.That(root.x, Is.InRange(-0.5, 1.0), "at the base");
            }
            else
            {
                Assert.That(root, Is.EqualTo(fitted[2][0]));
            }
        }

        // Against all ways to give veins to chains in their order: coverage times 1.4² less the square of the way of the tip in mean
        // distances of tips, 0.45 of which veins are apart; for the first chain 1.4² where the vein runs along it.
        [Test]
        public void VeinsAreChosen_ThatGainMost([NUnit.Framework.Range(1, 12)] int seed)
        {
            var random = new Random(seed);
            PlanPoint[][] chains = Fitted();
            chains[0] = Polyline.Even(Vein(80.0).Path, 5);
            Polyline rim = Rim();
            (double degrees, RadialVein vein)[] all = Enumerable.Range(0, 5).Select(k =>
            {
                double degrees = k == 0 && seed % 2 == 0 ? 80.0 : 70.0 - 165.0 * random.NextDouble();
                double place = rim.Nearest(Along(degrees, k_Length)), coverage = 0.5 + 0.5 * random.NextDouble();
                return (degrees, new RadialVein(Vein(degrees).Path, place, coverage));
            }).OrderBy(one => random.Next()).ToArray();
            RadialVein[] chosen = VeinChoice.Choose(chains, all.Select(one => one.vein).ToList(), new RimOrder(rim, chains), k_Length);

            (double degrees, RadialVein vein)[] sorted = all.OrderByDescending(one => one.degrees).ToArray();
            double Gain(int chain, int vein)
            {
                double offset = (s_Degrees[chain] - sorted[vein].degrees) / 40.0, gain = 1.96 - offset * offset;
                return sorted[vein].vein.Coverage * (chain > 0 ? gain : sorted[vein].degrees == 80.0 ? 1.96 : 0.0);
            }

            double Best(int chain, int from, double last)
            {
                if (chain == 5)
                    return 0.0;
                double best = Best(chain + 1, from, last);
                for (int vein = from; vein < sorted.Length; vein++)
                {
                    if (Gain(chain, vein) > 0.0 && last - sorted[vein].degrees > 0.45 * 40.0)
                        best = Math.Max(best, Gain(chain, vein) + Best(chain + 1, vein + 1, sorted[vein].degrees));
                }

                return best;
            }

            double gained = 0.0;
            for (int chain = 0; chain < 5; chain++)
                gained += chosen[chain] == null ? 0.0 : Gain(chain, Array.FindIndex(sorted, one => one.vein == chosen[chain]));
            Assert.That(gained, Is.EqualTo(Best(0, 0, 1000.0)).Within(0.01).And.Positive);
        }

        [Test]
        public void AVeinThatIsFollowedFromTheHinge_LeavesItAfterSixHundredths()
        {
            VeinChains laid = Lay(new[] { null, null, Vein(0.0), null, null });

            Assert.That(laid.Shares[2], Is.EqualTo(1.0 - 0.06).Within(0.012));
        }

        private static VeinChains Lay(RadialVein[] veins) => VeinChains.Lay(Fitted(), veins, Rim(), k_Length, false);

        private static PlanPoint[][] Fitted() => Array.ConvertAll(
            s_Degrees, degrees => Enumerable.Range(0, 5).Select(j => Along(degrees, 0.95 * k_Length * j / 4.0)).ToArray());

        private static RadialVein Vein(double degrees) =>
            new RadialVein(Enumerable.Range(0, 101).Select(k => Along(degrees, k_Length * k / 100.0)).ToArray(), 0.0, 1.0);

        private static RadialVein Forked(double at, double side)
        {
            PlanPoint[] shared = Enumerable.Range(0, 51).Select(k => new PlanPoint(at * k_Length * k / 50.0, 0.0)).ToArray();
            PlanPoint fork = shared[50], way = Along(side * 60.0, 1.0);
            return new RadialVein(shared.Concat(Enumerable.Range(1, 60).Select(k => fork + way * k)).ToArray(), 0.0, 1.0);
        }

        private static PlanPoint Middle(RadialVein a, RadialVein b, double share)
        {
            PlanPoint from = a.Path[100] * 0.996, to = b.Path[100] * 0.996;
            return from + (to - from) * share;
        }

        private static PlanPoint Along(double degrees, double radius) =>
            new PlanPoint(radius * Math.Cos(degrees * Math.PI / 180.0), radius * Math.Sin(degrees * Math.PI / 180.0));

        private static double Radius(PlanPoint point) => Math.Sqrt(point.LengthSquared);

        private static Polyline Rim() => new Polyline(
            Enumerable.Range(0, 181).Select(k => Along(k - 90.0, k_Length)).Append(new PlanPoint(-0.5, 0.0)).ToArray(), true);
    }
}
