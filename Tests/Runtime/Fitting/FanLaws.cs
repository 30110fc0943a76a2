using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Tests
{
    /// <summary>
    /// Laws of the fan of chains: the field between them, its level lines, joints on paths, and chains that would meet or leave the wing.
    /// </summary>
    public sealed class FanLaws
    {
        // A square with a corner missing: the notch's inner corner is at (1, 1).
        private static readonly PlanPoint[] s_Bent =
        {
            new PlanPoint(0, 0), new PlanPoint(0, 2), new PlanPoint(1, 2), new PlanPoint(1, 1), new PlanPoint(2, 1), new PlanPoint(2, 0),
        };

        [Test]
        public void TheField_IsTheHarmonicFunctionOfItsRim_WhicheverWayTheDomainLies([Values(0.0, 0.7, -2.0)] double angle)
        {
            // On the rectangle from (0, 0) to (2, 1) the function x z / 2 is harmonic, and straight along each side.
            double cosine = Math.Cos(angle), sine = Math.Sin(angle);
            PlanPoint Turned(double x, double z) => new PlanPoint(3.0 + cosine * x - sine * z, -1.0 + sine * x + cosine * z);
            PlanPoint[] rim = { Turned(0, 0), Turned(2, 0), Turned(2, 1), Turned(0, 1) };
            var field = new FanField(rim, new[] { 0.0, 0.0, 1.0, 0.0 }, new PlanPoint(cosine, sine));
            int inside = 0;
            for (int node = 0; node < field.Values.Length; node++)
            {
                PlanPoint at = field.At(node % FanField.Columns, node / FanField.Columns) - new PlanPoint(3.0, -1.0);
                double x = cosine * at.x + sine * at.z, z = cosine * at.z - sine * at.x;
                if (x < 0.0 || x > 2.0 || z < 0.0 || z > 1.0)
                    continue;
                inside++;
                Assert.That(field.Values[node], Is.EqualTo(0.5 * x * z).Within(0.01), $"at {x}, {z}");
            }

            Assert.That(inside, Is.EqualTo(160 * 96).Within(600), "the grid spans the domain");
            Assert.That(field.CellSize, Is.EqualTo(2.0 / 160.0).Within(1e-9));
        }

        [Test]
        public void ALevelLine_RunsFromItsRootToItsTip_WhereTheFieldHasItsValue([Values(0.2, 0.5)] double value, [Values] bool back)
        {
            PlanPoint[] rim = { new PlanPoint(0, 0), new PlanPoint(2, 0), new PlanPoint(2, 1), new PlanPoint(0, 1) };
            var field = new FanField(rim, new[] { 0.0, 0.0, 1.0, 0.0 }, new PlanPoint(1, 0));
            PlanPoint upper = new PlanPoint(2.0 * value, 1.0), right = new PlanPoint(2.0, value), root = back ? right : upper,
                tip = back ? upper : right;
            List<PlanPoint> line = LevelLine.Trace(field, value, root, tip);

            Assert.That((line[0].x, line[0].z, line[line.Count - 1].x, line[line.Count - 1].z), Is.EqualTo((root.x, root.z, tip.x, tip.z)));
            Assert.That(line, Has.Count.GreaterThan(60));
            for (int k = 1; k < line.Count; k++)
            {
                Assert.That(line[k].x * line[k].z, Is.EqualTo(2.0 * value).Within(0.02), "a hyperbola");
                Assert.That((line[k].x - line[k - 1].x) * (back ? -1.0 : 1.0), Is.GreaterThan(-0.01), "on and on");
            }
        }

        [Test]
        public void ALevelLine_IsCutWhereItIsClosestToItsRootAndItsTip()
        {
            PlanPoint[] rim = { new PlanPoint(0, 0), new PlanPoint(2, 0), new PlanPoint(2, 1), new PlanPoint(0, 1) };
            var field = new FanField(rim, new[] { 0.0, 0.0, 1.0, 0.0 }, new PlanPoint(1, 0));
            List<PlanPoint> whole = LevelLine.Trace(field, 0.3, new PlanPoint(0.6, 1.0), new PlanPoint(2.0, 0.3));
            for (int k = 0; k < 12; k++)
            {
                PlanPoint root = new PlanPoint(0.45 + 0.02 * k, 0.6), tip = new PlanPoint(1.5 + 0.015 * k, 0.1);
                List<PlanPoint> cut = LevelLine.Trace(field, 0.3, root, tip);
                Assert.That(Distance(cut[1], root), Is.LessThanOrEqualTo(whole.Min(point => Distance(point, root)) + 1e-9), $"root {k}");
                Assert.That(
                    Distance(cut[cut.Count - 2], tip), Is.EqualTo(whole.Min(point => Distance(point, tip))).Within(0.003), $"tip {k}");
            }
        }

        [Test]
        public void JointsOnAStraightPath_AreEven()
        {
            PlanPoint[] joints = BalancedJoints.Place(new[] { new PlanPoint(0, 0), new PlanPoint(0.2, 0), new PlanPoint(1, 0) }, 6);

            Assert.That(joints.Select(joint => joint.x), Is.EqualTo(new[] { 0.0, 0.2, 0.4, 0.6, 0.8, 1.0 }).Within(0.01));
        }

        [TestCase(0.3, 1.0)]
        [TestCase(0.7, 1.0)]
        [TestCase(0.55, -1.0)]
        public void AJointOfABentPath_LiesInItsBend(double bend, double side)
        {
            PlanPoint corner = new PlanPoint(bend, 0.0), end = new PlanPoint(bend + 0.1, side * (1.0 - bend));
            PlanPoint[] joints = BalancedJoints.Place(new[] { new PlanPoint(0, 0), corner, end }, 3);

            Assert.That(Distance(joints[1], corner), Is.LessThan(0.03));
            Assert.That((Distance(joints[0], default), Distance(joints[2], end)), Is.EqualTo((0.0, 0.0)));
        }

        // Of all places on a bent path: a bone costs the cube of a twentieth of its length and of its largest distance from the path,
        // squared, over 0.01; 4 times the distance in hollows, 0.4 of it at the root, all of it beyond the inner third.
        [TestCase(0.25, 0.1)]
        [TestCase(0.25, -0.1)]
        [TestCase(0.6, 0.15)]
        [TestCase(0.75, -0.08)]
        public void TheJointOfABow_LiesWhereItsTwoBonesCostLeast(double middle, double height)
        {
            const int count = 1921;
            PlanPoint[] bow = Enumerable.Range(0, 201).Select(k => k / 200.0)
                .Select(x => new PlanPoint(x, height * Math.Exp(-Math.Pow((x - middle) / 0.2, 2.0)))).ToArray();
            PlanPoint[] places = Polyline.Even(bow, count);
            double Cost(int from, int to)
            {
                double most = 0.0;
                PlanPoint along = places[to] - places[from];
                for (int k = from + 1; k < to; k++)
                {
                    double off = PlanPoint.Cross(along, places[k] - places[from]) / Math.Sqrt(along.LengthSquared);
                    double weight = off < 0.0 ? 4.0 : Math.Min(1.0, 0.4 + 0.6 * 3.0 * k / count);
                    most = Math.Max(most, Math.Abs(weight * off));
                }

                return Math.Pow(0.05 * Math.Sqrt(along.LengthSquared) + most * most / 0.01, 3.0);
            }

            int best = Enumerable.Range(1, count - 2).OrderBy(k => Cost(0, k) + Cost(k, count - 1)).First();
            Assert.That(Distance(BalancedJoints.Place(bow, 3)[1], places[best]), Is.LessThan(0.0015));
        }

        [Test]
        public void BonesKeepOutOfHollows_RatherThanBulges()
        {
            // Round a wing clockwise a hollow turns to the left: of two equal bends the one bone that is left over goes across the bulge.
            PlanPoint[] path = { new PlanPoint(0.0, 0.0), new PlanPoint(0.4, 0.0), new PlanPoint(0.55, 0.06), new PlanPoint(0.7, 0.0),
                new PlanPoint(0.85, -0.06), new PlanPoint(1.0, 0.0) };
            PlanPoint[] joints = BalancedJoints.Place(path, 4);
            double bulge = joints.Min(joint => Distance(joint, path[2])), hollow = joints.Min(joint => Distance(joint, path[4]));

            Assert.That(hollow, Is.LessThan(bulge));
        }

        [Test]
        public void AnInnerPath_IsStraightWhereItCan_AndElseGoesRoundTheNotch()
        {
            var outline = new ClosedCurve(s_Bent, 1600);
            double Arc(double x, double z) => outline.Nearest(new PlanPoint(x, z));
            List<PlanPoint> straight = InnerPath.Find(outline, Arc(0.5, 0.0), Arc(0.0, 1.5)),
                round = InnerPath.Find(outline, Arc(1.9, 1.0), Arc(0.9, 2.0));

            Assert.That(straight, Has.Count.EqualTo(2));
            Assert.That(Polyline.LengthOf(straight), Is.EqualTo(Math.Sqrt(2.5)).Within(1e-3));

            // The shortest way touches the inner corner, from which places keep a hundredth.
            double shortest = 0.9 + Math.Sqrt(1.0 + 0.01);
            Assert.That(Polyline.LengthOf(round), Is.InRange(shortest, shortest + 0.06));
            Assert.That(round.Min(point => Distance(point, new PlanPoint(1, 1))), Is.LessThan(0.03));
            foreach (PlanPoint point in round)
                Assert.That(outline.Contains(point) || Distance(outline.At(outline.Nearest(point)), point) < 0.004, Is.True);
        }

        // A slit less wide than the hundredth within which the ends of a way are not looked at, just before its end or its beginning.
        [Test]
        public void ANarrowSlitAtAnEnd_DoesNotBendTheWay([Values] bool isAtTheEnd)
        {
            PlanPoint[] corners = { new PlanPoint(0, 0), new PlanPoint(0, 1), new PlanPoint(0.7, 1), new PlanPoint(0.7, 0.2),
                new PlanPoint(0.709, 0.2), new PlanPoint(0.709, 1), new PlanPoint(1, 1), new PlanPoint(1, 0) };
            var outline = new ClosedCurve(corners, 4000);
            double from = outline.Nearest(isAtTheEnd ? new PlanPoint(1, 0.5) : new PlanPoint(0.709, 0.5)),
                to = outline.Nearest(isAtTheEnd ? new PlanPoint(0.7, 0.5) : new PlanPoint(0, 0.5));

            Assert.That(InnerPath.Find(outline, from, to), Has.Count.EqualTo(2));
            Assert.That(InnerPath.Find(outline, outline.Nearest(new PlanPoint(1, 0.5)), outline.Nearest(new PlanPoint(0, 0.5))),
                Has.Count.GreaterThan(2), "in the middle of a way it is a slit");
        }

        [Test]
        public void ABoneOutsideTheWing_IsAsFarOffAsItsFarthestPlace()
        {
            var outline = new ClosedCurve(s_Bent, 1600);
            PlanPoint[] across = { new PlanPoint(0.8, 1.8), new PlanPoint(1.8, 0.8) },
                inside = { new PlanPoint(0.2, 1.8), new PlanPoint(0.2, 0.2), new PlanPoint(1.8, 0.2) };

            Assert.That(ChainInset.Outside(across, outline), Is.EqualTo(0.3).Within(0.01),
                "the middle of the bone, 0.3 right of and above the inner corner's sides");
            Assert.That(ChainInset.Outside(inside, outline), Is.Zero);
        }

        [Test]
        public void ChainsAcrossANotch_AreDrawnIn_WithoutTheirEnds([Values(3, 5, 9)] int joints)
        {
            var outline = new ClosedCurve(s_Bent, 1600);
            PlanPoint root = new PlanPoint(0.9, 1.9), tip = new PlanPoint(1.9, 0.9);
            PlanPoint[] chain = Polyline.Even(new[] { root, tip }, joints);
            ChainInset.Apply(chain, outline);

            Assert.That(ChainInset.Outside(chain, outline), Is.LessThanOrEqualTo(0.004));
            Assert.That((Distance(chain[0], root), Distance(chain[joints - 1], tip)), Is.EqualTo((0.0, 0.0)));
            PlanPoint[] fine = { new PlanPoint(0.1, 1.9), new PlanPoint(0.2, 1.0), new PlanPoint(0.1, 0.1) };
            var before = (PlanPoint[])fine.Clone();
            ChainInset.Apply(fine, outline);
            Assert.That(fine.Zip(before, Distance), Is.All.Zero, "a chain inside stays");
        }

        [Test]
        public void ChainsMeet_WhereTheyCrossOrTouch_ButNotAtACommonRoot()
        {
            PlanPoint[] level = { new PlanPoint(0, 0), new PlanPoint(1, 0), new PlanPoint(2, 0) },
                above = { new PlanPoint(0, 0.5), new PlanPoint(1, 0.5), new PlanPoint(2, 0.5) };
            PlanPoint[] across = { new PlanPoint(0, 0.5), new PlanPoint(1, 0.5), new PlanPoint(2, -0.5) },
                fork = { new PlanPoint(0, 0), new PlanPoint(1, 0.5), new PlanPoint(2, 0.5) };
            PlanPoint[] Near(double z) => new[] { new PlanPoint(0, 0.5), new PlanPoint(1, 0.5), new PlanPoint(2, z) };

            Assert.That(ChainOrder.Cross(new[] { level, above }), Is.False);
            Assert.That(ChainOrder.Cross(new[] { level, across }), Is.True);
            Assert.That(ChainOrder.Cross(new[] { across, above, level }), Is.True, "any two of them");
            Assert.That(ChainOrder.Cross(new[] { level, fork }), Is.False);
            Assert.That(ChainOrder.Cross(new[] { level, Near(2e-4) }), Is.True);
            Assert.That(ChainOrder.Cross(new[] { level, Near(4e-4) }), Is.False);
            Assert.That(ChainOrder.Cross(new[] { Near(2e-4), level }), Is.True, "whichever comes first");
            Assert.That(ChainOrder.Cross(new[] { Near(4e-4), level }), Is.False);
        }

        [Test]
        public void ChainsThatMeet_ArePartedEvenly_AndTheOthersStay()
        {
            PlanPoint[] Line(double z, double end) => new[] { new PlanPoint(0, z), new PlanPoint(1, z), new PlanPoint(2, end) };
            PlanPoint[][] chains = { Line(0.0, 0.0), Line(-0.2, -0.5), Line(-0.4, -0.3), Line(-0.6, -0.8), Line(-0.8, -1.2) };
            chains[1][1] = new PlanPoint(1, -0.45);
            Assert.That(ChainOrder.Cross(chains), Is.True);
            Assert.That(ChainOrder.Untangle(chains), Is.True);
            Assert.That(ChainOrder.Cross(chains), Is.False);
            Assert.That(chains[0].Zip(Line(0.0, 0.0), Distance), Is.All.Zero, "the first and the last chain stay");
            Assert.That(chains[4].Zip(Line(-0.8, -1.2), Distance), Is.All.Zero);
            Assert.That(chains.Select(chain => chain[0].z), Is.EqualTo(new[] { 0.0, -0.2, -0.4, -0.6, -0.8 }), "roots stay");

            PlanPoint[][] parted = { Line(0.0, 0.0), Line(-0.2, -0.2), Line(-0.4, -0.4) };
            Assert.That(ChainOrder.Untangle(parted), Is.True);
            Assert.That(parted[1].Zip(Line(-0.2, -0.2), Distance), Is.All.Zero, "nothing to do");
        }

        [TestCase(7, 0.06, 7)]
        [TestCase(6, 0.06, 0)]
        [TestCase(11, 0.0225, 11)]
        [TestCase(11, 0.0195, 0)]
        public void Rays_AreSevenOrMore_WithHollowsDeepEnough(int rays, double depth, int found)
        {
            // A hollow lies deeper than the chord between its rays' ends by its depth less the height of the arc: 0.0055 of eleven rays.
            var fin = new RayFin { rays = rays, depth = depth };
            var outline = new ClosedCurve(Array.ConvertAll(fin.Outline(), corner => new PlanPoint(corner.x, corner.z)), 1600);
            double Arc(int ray) => outline.Nearest(new PlanPoint(fin.End(ray).x, fin.End(ray).z));
            List<double> ends = MarginRays.Find(outline, 0.02, outline.Length - 0.3, Arc(0));

            Assert.That(ends, Has.Count.EqualTo(found));
            for (int ray = 0; ray < ends.Count; ray++)
                Assert.That(ends[ray], Is.EqualTo(Arc(ray)).Within(0.01), $"ray {ray}");
        }

        private static double Distance(PlanPoint a, PlanPoint b) => Math.Sqrt((a - b).LengthSquared);
    }
}
