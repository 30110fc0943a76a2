using System;
using System.Collections.Generic;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class VeinTracingTests
    {
        private static IEnumerable<TestCaseData> Cases()
        {
            foreach (DrawnWing wing in new[] { DrawnWing.Monarch(), DrawnWing.Scalloped(), DrawnWing.Fan() })
            {
                foreach (VeinLook look in Enum.GetValues(typeof(VeinLook)))
                    yield return new TestCaseData(wing, look, 400).SetName($"{{m}}({wing.Name}, {look}, 400)");
                yield return new TestCaseData(wing, VeinLook.Photo, 640).SetName($"{{m}}({wing.Name}, Photo, 640)");
            }
        }

        [TestCaseSource(nameof(Cases))]
        public void ChainsFollowTheVeins_AndTheHingeLiesWhereTheyMeet(object wing, VeinLook look, int side)
        {
            var drawn = new DrawnVeinPicture((DrawnWing)wing, side, 6, look);

            WingTrace trace = WingTracer.Trace(drawn.Picture.ToPicture(), WingTracingSettings.Default);

            int followed = 0;
            for (int i = 0; i < trace.Skeleton.ChainCount; i++)
            {
                if (!trace.FollowsVein[i])
                    continue;
                followed++;
                for (int j = 1; j < trace.Skeleton.JointsPerChain; j++)
                {
                    // A vein that is lost before the margin is drawn on to it.
                    double bound = j == 4 ? 0.05 : look == VeinLook.Broken ? 0.025 : 0.015;
                    Assert.That(Stray(trace, i, j, drawn), Is.LessThan(bound), $"chain {i}, joint {j}, wing lengths from the vein");
                }
            }

            Assert.That(followed, Is.GreaterThanOrEqualTo(look == VeinLook.Broken ? 3 : 4), "chains on veins; the first one may keep to the leading edge");
            Assert.That(trace.Skeleton.Validate(), Is.Empty);
            Vector2 hinge = trace.Placement.ToPicture(trace.Skeleton.Hinge);
            Assert.That((hinge - drawn.Root).magnitude / drawn.Place.Length, Is.LessThan(0.08), "hinge");
        }

        [Test]
        public void EachChainOnAVein_HasAVeinOfItsOwn()
        {
            var drawn = new DrawnVeinPicture(DrawnWing.Scalloped(), 480, 7, VeinLook.Photo);
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.chains = 6;

            WingTrace trace = WingTracer.Trace(drawn.Picture.ToPicture(), settings);

            var taken = new HashSet<int>();
            for (int i = 0; i < 6; i++)
            {
                if (trace.FollowsVein[i])
                    Assert.That(taken.Add(Nearest(trace, i, drawn)), Is.True, $"chain {i}");
            }

            Assert.That(taken.Count, Is.GreaterThanOrEqualTo(4));
        }

        [Test]
        public void FewVeins_LeaveTheOtherChainsToTheOutline()
        {
            var drawn = new DrawnVeinPicture(DrawnWing.Monarch(), 400, 2, VeinLook.Photo);

            WingTrace trace = WingTracer.Trace(drawn.Picture.ToPicture(), WingTracingSettings.Default);

            int followed = 0;
            for (int i = 0; i < 5; i++)
                followed += trace.FollowsVein[i] ? 1 : 0;
            Assert.That(followed, Is.InRange(1, 2));
            Assert.That(trace.Skeleton.Validate(), Is.Empty);
        }

        [TestCase(DrawnKind.Silhouette)]
        [TestCase(DrawnKind.Noisy)]
        [TestCase(DrawnKind.Hard)]
        [TestCase(DrawnKind.Transparent)]
        [TestCase(DrawnKind.Drawing)]
        public void WingWithoutVeins_GetsFittedChains(DrawnKind kind)
        {
            foreach (DrawnWing wing in new[] { DrawnWing.Monarch(), DrawnWing.Scalloped() })
            {
                WingTrace trace = WingTracer.Trace(wing.In(500, 10f).Draw(kind).ToPicture(), WingTracingSettings.Default);

                Assert.That(trace.Veins, Is.Empty, wing.Name);
                Assert.That(trace.FollowsVein, Is.All.False, wing.Name);
                Assert.That(trace.Skeleton.Validate(), Is.Empty, wing.Name);
            }
        }

        private static double Stray(WingTrace trace, int chain, int joint, DrawnVeinPicture drawn) =>
            PlanPaths.Distance(Joint(trace, chain, joint), new[] { drawn.Radial[Nearest(trace, chain, drawn)] }) / drawn.Place.Length;

        private static int Nearest(WingTrace trace, int chain, DrawnVeinPicture drawn)
        {
            int nearest = 0;
            for (int k = 1; k < drawn.Radial.Count; k++)
                nearest = Sum(trace, chain, drawn.Radial[k]) < Sum(trace, chain, drawn.Radial[nearest]) ? k : nearest;
            return nearest;
        }

        private static double Sum(WingTrace trace, int chain, Vector2[] vein)
        {
            double sum = 0.0;
            for (int j = 1; j < trace.Skeleton.JointsPerChain; j++)
                sum += PlanPaths.Distance(Joint(trace, chain, j), new[] { vein });
            return sum;
        }

        private static Vector2 Joint(WingTrace trace, int chain, int joint) => trace.Placement.ToPicture(trace.Skeleton.GetJoint(chain, joint));
    }
}
