using System;
using System.Collections.Generic;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class VeinTracingTests
    {
        private static readonly DrawnWing[] s_Wings = { DrawnWing.Monarch(), DrawnWing.Scalloped(), DrawnWing.Fan() };

        // Two wings, each in a look of its own.
        private static IEnumerable<TestCaseData> Some => Cases(isQuick: true);

        private static IEnumerable<TestCaseData> Others => Cases(isQuick: false);

        private static IEnumerable<TestCaseData> Cases(bool isQuick)
        {
            for (int k = 0; k < s_Wings.Length; k++)
            {
                foreach (VeinLook look in Enum.GetValues(typeof(VeinLook)))
                {
                    if (((int)look == k && k < 2) == isQuick)
                        yield return new TestCaseData(s_Wings[k], look, 400).SetName($"{{m}}({s_Wings[k].Name}, {look}, 400)");
                }

                if (!isQuick)
                    yield return new TestCaseData(s_Wings[k], VeinLook.Photo, 640).SetName($"{{m}}({s_Wings[k].Name}, Photo, 640)");
            }
        }

        [TestCaseSource(nameof(Some))]
        public void ChainsFollowTheVeins_AndTheHingeLiesWhereTheyMeet(object wing, VeinLook look, int side) =>
            AssertFollowed((DrawnWing)wing, look, side);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void ChainsFollowTheVeinsOfAnyOtherWing_AndTheHingeLiesWhereTheyMeet(object wing, VeinLook look, int side) =>
            AssertFollowed((DrawnWing)wing, look, side);

        private static void AssertFollowed(DrawnWing wing, VeinLook look, int side)
        {
            var drawn = new DrawnVeinPicture(wing, side, 6, look);

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

            Assert.That(followed, Is.GreaterThanOrEqualTo(look == VeinLook.Broken ? 3 : 4),
                "chains on veins; the first one may keep to the leading edge");
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

        [TestCase(VeinLook.Photo, 1.35f, Explicit = true, Category = "Long")]
        [TestCase(VeinLook.Drawing, 1.1f)]
        public void WidthsOfVeins_AreMeasured(VeinLook look, float scatter)
        {
            const float k_Rear = 2.5f;
            var drawn = new DrawnVeinPicture(DrawnWing.Scalloped(), 400, 6, look, k_Rear);
            WingTracingSettings settings = WingTracingSettings.Default;
            settings.veinWidths = true;
            WingTrace trace = WingTracer.Trace(drawn.Picture.ToPicture(), settings);

            var ratios = new List<float>();
            for (int i = 0; i < 5; i++)
            {
                float[] widths = trace.Skeleton.Chains[i].veinWidths;
                if (!trace.FollowsVein[i])
                    continue;
                float drawnWidth = Mathf.Lerp(1f, k_Rear, Nearest(trace, i, drawn) / 5f);
                ratios.Add(widths[2] / drawnWidth);
            }

            ratios.Sort();
            Assert.That(ratios, Has.Count.GreaterThanOrEqualTo(3));
            Assert.That(ratios[ratios.Count - 1] / ratios[0], Is.LessThan(scatter), "widths are as drawn, up to a common factor");
            Assert.That(trace.Skeleton.Validate(), Is.Empty);
        }

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void FewVeins_LeaveTheOtherChainsToTheOutline()
        {
            var drawn = new DrawnVeinPicture(DrawnWing.Monarch(), 400, 2, VeinLook.Photo);

            WingTrace trace = WingTracer.Trace(drawn.Picture.ToPicture(), WingTracingSettings.Default);

            int followed = 0;
            for (int i = 0; i < 5; i++)
                followed += trace.FollowsVein[i] ? 1 : 0;
            Assert.That(followed, Is.InRange(1, 2));
            Assert.That(trace.Skeleton.Chains, Has.All.Matches<JointChain>(chain => chain.veinWidths == null), "not asked for");
            Assert.That(trace.Skeleton.Validate(), Is.Empty);
        }

        [TestCase("monarch", DrawnKind.Silhouette, 320)]
        [TestCase("scalloped", DrawnKind.Noisy, 500, Explicit = true, Category = "Long")]
        [TestCase("monarch", DrawnKind.Hard, 500, Explicit = true, Category = "Long")]
        [TestCase("monarch", DrawnKind.Transparent, 320, Explicit = true, Category = "Long,Faults")]
        [TestCase("scalloped", DrawnKind.Drawing, 500, Explicit = true, Category = "Long")]
        [TestCase("scalloped", DrawnKind.Silhouette, 500, Explicit = true, Category = "Long")]
        [TestCase("monarch", DrawnKind.Noisy, 500, Explicit = true, Category = "Long")]
        [TestCase("scalloped", DrawnKind.Hard, 500, Explicit = true, Category = "Long")]
        [TestCase("scalloped", DrawnKind.Transparent, 500, Explicit = true, Category = "Long")]
        [TestCase("monarch", DrawnKind.Drawing, 500, Explicit = true, Category = "Long")]
        public void WingWithoutVeins_GetsFittedChains(string name, DrawnKind kind, int side)
        {
            DrawnWing wing = Array.Find(s_Wings, one => one.Name == name);

            WingTrace trace = WingTracer.Trace(wing.In(side, 10f).Draw(kind).ToPicture(), WingTracingSettings.Default);

            Assert.That(trace.Veins, Is.Empty);
            Assert.That(trace.FollowsVein, Is.All.False);
            Assert.That(trace.Skeleton.Validate(), Is.Empty);
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

        private static Vector2 Joint(WingTrace trace, int chain, int joint) =>
            trace.Placement.ToPicture(trace.Skeleton.GetJoint(chain, joint));
    }
}
