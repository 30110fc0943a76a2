using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>Laws of the shares of a fan: even over what is open, one chain in a tail, along rays where a margin shows them.</summary>
    public sealed class FanShareLaws
    {
        private static readonly (double, double)[] s_Plain = { (1, 0.25), (1, -0.25) };

        // On the outer side, a little below its middle.
        private static readonly (double, double)[] s_Tail = { (1, 0.25), (1, 0.0), (1.3, 0.0), (1.3, -0.06), (1, -0.06), (1, -0.25) };
        private static readonly (double, double)[] s_Cleft = { (1, 0.25), (1, 0.0), (0.75, 0.0), (0.75, -0.06), (1, -0.06), (1, -0.25) };

        [Test]
        public void WithoutTails_TheSharesAreEven([Values(3, 5, 16)] int chains)
        {
            FanShares shares = Shares(s_Plain, chains, out _, out _);

            for (int k = 0; k < chains; k++)
            {
                Assert.That(shares[k], Is.EqualTo(k / (chains - 1.0)).Within(1e-9));
                Assert.That(shares.TailOf(k).HasValue, Is.False);
            }
        }

        [Test]
        public void OneChain_GoesIntoATail_AndTheOthersAreEvenOverTheRest([Values(3, 4, 6, 9)] int chains)
        {
            FanShares shares = Shares(s_Tail, chains, out WingLandmarks marks, out WingMargin margin);
            Assert.That((marks.Trimmed.Tails.Count, marks.Trimmed.Clefts.Count), Is.EqualTo((1, 0)));
            OutlineStretch tail = marks.Trimmed.Tails[0];
            double from = margin.ShareAt(tail.from), to = margin.ShareAt(tail.to);
            int inside = Enumerable.Range(0, chains).Single(k => shares.TailOf(k).HasValue);

            Assert.That(shares[inside], Is.EqualTo(margin.ShareAt(0.5 * (tail.from + tail.to))).Within(1e-9));
            Assert.That(inside, Is.EqualTo(Math.Round(0.5 * (from + to) * (chains - 1))).Within(1.0), "the chain closest to it");
            double Open(double share) => share - Math.Min(Math.Max(share - from, 0.0), to - from);
            AssertEven(k => Open(shares[k]), 0, inside);
            AssertEven(k => Open(shares[k]), inside, chains - 1);
            Assert.That((shares[0], shares[chains - 1]), Is.EqualTo((0.0, 1.0)));
            for (int k = 0; k < chains; k++)
                Assert.That(k != inside && shares[k] > from + 1e-9 && shares[k] < to - 1e-9, Is.False, $"chain {k}");
        }

        // Of three chains the last one is given: what is nearer to it than to the middle one goes to the middle one all the same.
        [Test]
        public void ATailBesideTheLastChain_HasTheOneBefore()
        {
            (double, double)[] low = { (1, 0.25), (1, -0.25), (0.65, -0.25), (0.65, -0.55), (0.59, -0.55), (0.59, -0.25) };
            FanShares shares = Shares(low, 3, out WingLandmarks marks, out WingMargin margin);
            OutlineStretch tail = marks.Trimmed.Tails.Single();
            double at = margin.ShareAt(0.5 * (tail.from + tail.to));

            Assert.That(at, Is.InRange(0.76, 0.95));
            Assert.That(new[] { 0, 1, 2 }.Where(k => shares.TailOf(k).HasValue), Is.EqualTo(new[] { 1 }));
            Assert.That(shares[1], Is.EqualTo(at).Within(1e-9));
        }

        [Test]
        public void NoChain_EndsInACleft([Values(3, 5, 8, 16)] int chains)
        {
            FanShares shares = Shares(s_Cleft, chains, out WingLandmarks marks, out WingMargin margin);
            Assert.That((marks.Trimmed.Tails.Count, marks.Trimmed.Clefts.Count), Is.EqualTo((0, 1)));
            OutlineStretch cleft = marks.Trimmed.Clefts[0];
            double from = margin.ShareAt(cleft.from), to = margin.ShareAt(cleft.to);

            AssertEven(k => shares[k] - Math.Min(Math.Max(shares[k] - from, 0.0), to - from), 0, chains - 1);
            for (int k = 0; k < chains; k++)
            {
                Assert.That(shares[k] > from + 1e-9 && shares[k] < to - 1e-9, Is.False, $"chain {k}");
                Assert.That(shares.TailOf(k).HasValue, Is.False);
            }
        }

        [Test]
        public void WhereRaysShow_ChainsRunAlongThem_OrEvenlyBetweenThemWhereTheyAreFew([Values(3, 5, 11, 16)] int chains)
        {
            var fin = new RayFin();
            var corners = fin.Outline().Select(corner => ((double)corner.x, (double)corner.z)).ToList();
            corners.Insert(0, (0, 0));
            FanShares shares = Shares(Curve(corners), chains, out WingLandmarks marks, out WingMargin margin);
            Assert.That(marks.Rays, Has.Count.EqualTo(11));
            Assert.That((marks.Tip, marks.Last), Is.EqualTo((marks.Rays[0], marks.Rays[10])));
            for (int k = 0; k < chains; k++)
            {
                double at = 10.0 * k / (chains - 1);
                if (chains <= 11)
                {
                    int ray = Enumerable.Range(0, 11).OrderBy(other => Math.Abs(margin.ShareAt(marks.Rays[other]) - shares[k])).First();
                    Assert.That(shares[k], Is.EqualTo(margin.ShareAt(marks.Rays[ray])).Within(1e-9), $"chain {k}");
                    Assert.That(Math.Abs(ray - at), Is.LessThanOrEqualTo(0.5), $"chain {k}: the nearest ray");
                    continue;
                }

                int before = Math.Min((int)at, 9);
                double place = marks.Rays[before] * (before + 1 - at) + marks.Rays[before + 1] * (at - before);
                Assert.That(shares[k], Is.EqualTo(margin.ShareAt(place)).Within(1e-9), $"chain {k}");
            }
        }

        [Test]
        public void ARayToATailsEnd_CountsByItsAngle_ButKeepsToTheTail()
        {
            Shares(s_Tail, 5, out WingLandmarks marks, out WingMargin margin);
            OutlineStretch tail = marks.Trimmed.Tails[0];
            PlanPoint middle = marks.Trimmed.At(0.5 * (tail.from + tail.to)), arm = middle - marks.Base;
            double whole = Clockwise(margin.Points[0] - marks.Base, margin.Points[margin.Points.Count - 1] - marks.Base);
            double at = margin.ShareAt(0.5 * (tail.from + tail.to));

            // A tenth of a share is by the angle; clockwise is on.
            const double turn = 0.02;
            var on = new PlanPoint(arm.x + turn * arm.z, arm.z - turn * arm.x);
            double expected = at + 0.1 * Math.Atan(turn) / whole;
            Assert.That(margin.ShareTowards(marks.Base + on, tail), Is.EqualTo(expected).Within(2e-4));
            Assert.That(margin.ShareTowards(marks.Base + on * 3.0, tail), Is.EqualTo(expected).Within(2e-4), "however far");
            Assert.That(
                margin.ShareTowards(marks.Base + new PlanPoint(0.0, 1.0), tail), Is.EqualTo(margin.ShareAt(tail.from)).Within(1e-9));
            Assert.That(
                margin.ShareTowards(marks.Base + new PlanPoint(0.0, -1.0), tail), Is.EqualTo(margin.ShareAt(tail.to)).Within(1e-9));
        }

        // Between the first and the last chain runs a harmonic function, 0 and 1 there and the shares along the margin; a chain lies 0.55
        // of the way from its level line to the straight line between its ends, its joints even.
        [Test]
        public void InnerChains_LieBetweenTheirLevelLinesAndStraightOnes([Values(0.5, 0.8)] double aspect)
        {
            var wing = new PolarWing { aspect = aspect, sweep = -0.35 };
            ClosedCurve outline = Curve(wing.Outline(600).Reverse().Select(place => ((double)place.x, (double)place.z)).ToList());
            var notes = new FitNotes();
            var marks = new WingLandmarks(outline, notes);
            var margin = new WingMargin(marks);
            Assert.That(marks.Trimmed.Tails, Is.Empty);
            List<PlanPoint[][]> layouts = new FanChains(outline, marks, notes).Lay(5, 6);
            PlanPoint[] first = layouts[0][0], last = layouts[0][4];
            var rim = first.Concat(margin.Points.Skip(1)).Concat(last.Reverse()).ToList();
            var values = first.Select(_ => 0.0).Concat(margin.Shares.Skip(1)).Concat(last.Select(_ => 1.0)).ToList();
            var field = new FanField(rim, values, margin.Points[0] - marks.Base);
            double bent = 0.0;
            for (int chain = 1; chain < 4; chain++)
            {
                double share = chain / 4.0;
                PlanPoint root = first[0] + (last[0] - first[0]) * share, tip = margin.At(share);
                PlanPoint[] path = Polyline.Even(LevelLine.Trace(field, share, root, tip), 401);
                for (int k = 0; k < path.Length; k++)
                {
                    PlanPoint straight = root + (tip - root) * (k / 400.0);
                    bent = Math.Max(bent, Math.Sqrt((path[k] - straight).LengthSquared));
                    path[k] = path[k] * 0.45 + straight * 0.55;
                }

                PlanPoint[] wanted = Polyline.Even(path, 6);
                for (int joint = 0; joint < 6; joint++)
                {
                    Assert.That(
                        Math.Sqrt((layouts[0][chain][joint] - wanted[joint]).LengthSquared), Is.LessThan(4e-4), $"chain {chain}, {joint}");
                }
            }

            Assert.That(layouts, Has.Count.EqualTo(1));
            Assert.That(bent, Is.GreaterThan(0.02));
        }

        [TestCase(0.0095, false)]
        [TestCase(0.0106, true)]
        public void AChainThatLeavesTheWingByAHundredth_IsNamed(double by, bool isNamed)
        {
            var corners = new List<(double, double)> { (0, 0), (0, 0.25), (1, 0.25), (1, -0.25), (0, -0.25) };
            ClosedCurve outline = Curve(corners);
            var notes = new FitNotes();
            var fan = new FanChains(outline, new WingLandmarks(outline, notes), notes);
            PlanPoint[] inside = { default, new PlanPoint(0.5, 0.1), new PlanPoint(0.9, 0.1) },
                outside = { default, new PlanPoint(0.3, -0.25 - by), new PlanPoint(0.8, -0.25 - by) };
            fan.Warn(new[] { inside, outside });

            Assert.That(notes.Warned(SkeletonFitWarningKind.ChainLeavesWing), Is.EqualTo(isNamed));
            Assert.That(notes.Confidence, Is.EqualTo(isNamed ? 0.9 : 1.0).Within(1e-9));
            if (isNamed)
                Assert.That(notes.Warnings[0].ToString(), Does.StartWith("Chain 1 strays 1.1 % of the wing's length"));
        }

        private static void AssertEven(Func<int, double> value, int first, int last)
        {
            for (int k = first; k <= last; k++)
            {
                double even = value(first) + (value(last) - value(first)) * (k - first) / Math.Max(1, last - first);
                Assert.That(value(k), Is.EqualTo(even).Within(1e-9), $"chain {k} from {first} to {last}");
            }
        }

        private static FanShares Shares((double, double)[] side, int chains, out WingLandmarks marks, out WingMargin margin)
        {
            var corners = new List<(double, double)> { (0, 0), (0, 0.25) };
            corners.AddRange(side);
            corners.Add((0, -0.25));
            return Shares(Curve(corners), chains, out marks, out margin);
        }

        private static FanShares Shares(ClosedCurve outline, int chains, out WingLandmarks marks, out WingMargin margin)
        {
            marks = new WingLandmarks(outline, new FitNotes());
            margin = new WingMargin(marks);
            return new FanShares(marks, margin, chains);
        }

        private static ClosedCurve Curve(List<(double X, double Z)> corners) =>
            new ClosedCurve(corners.ConvertAll(corner => new PlanPoint(corner.X, corner.Z)), 1600);

        private static double Clockwise(PlanPoint from, PlanPoint to) =>
            Math.Atan2(PlanPoint.Cross(to, from), PlanPoint.Dot(from, to));
    }
}
