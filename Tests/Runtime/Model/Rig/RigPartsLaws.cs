using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Parts of a rig on skeletons of parallel chains, of which they have closed forms.</summary>
    public sealed class RigPartsLaws
    {
        private static readonly WingFrame s_Frame = new WingFrame(0f, float3x3.identity, 1f, false);

        [TestCase(0.1f)]
        [TestCase(0.17f)]
        [TestCase(0.3f)]
        public void StripsBetweenParallelChains_AreAsWideAsTheirDistance(float width)
        {
            var strips = new StripNetwork(Rest(Chain(0f, 1f), Chain(-width, 1f), Chain(-3f * width, 1f)));

            Assert.That(strips.Strips, Has.Length.EqualTo(4 * 4), "each joint but the roots has a foot on each neighbour");
            foreach (Strip strip in strips.Strips)
            {
                int inner = math.min(strip.bone, strip.other) / 4;
                float apart = (1 + inner) * width, reach = strip.bones * 0.25f;
                for (int k = 0; k < strip.bones; k++)
                    Assert.That(strips.Levers[strip.lever + k], Is.EqualTo((reach - 0.25f * k) / apart).Within(1e-4f));
                for (int k = 0; k < strip.others; k++)
                    Assert.That(strips.Levers[strip.lever + strip.bones + k], Is.EqualTo(-(reach - 0.25f * k) / apart).Within(1e-4f));
            }

            Assert.That(strips.FanWidths, Is.EqualTo(new[] { width, 2f * width }).Within(1e-5f), "at the tip, over the length of 1");
            float share = Math.Min(3f * width / 0.4f, 1f);
            Assert.That(strips.Spread, Is.EqualTo(share * share).Within(1e-4f));
        }

        [TestCase(0.0019f)]
        [TestCase(0.0021f)]
        public void AStrip_IsTakenForNoNarrowerThanTwoThousandths(float width)
        {
            var strips = new StripNetwork(Rest(Chain(0f, 1f), Chain(-width, 1f), Chain(-0.3f, 1f)));

            Assert.That(strips.FanWidths[0], Is.EqualTo(Math.Max(width, 0.002f)).Within(1e-6f));
        }

        [TestCase(0.02f, true)]
        [TestCase(0.03f, false)]
        public void AFoot_MayLieATenthOfABoneBeyondAChain(float beyond, bool hasFoot)
        {
            // Bones of a quarter: a tip may reach 0.025 farther than the chain beside it.
            RestSkeleton rest = Rest(Chain(0f, 1f + beyond), Chain(-0.2f, 1f), Chain(-0.4f, 1f));
            var strips = new StripNetwork(rest);
            IEnumerable<Strip> tips = strips.Strips.Where(strip => strip.bone == 0 && strip.bones == 4);

            Assert.That(tips.Any(), Is.EqualTo(hasFoot));
        }

        // A bone beside the leading chain turns as that one does, on the mean over the same distance from the root.
        [TestCase(1f)]
        [TestCase(0.55f)]
        [TestCase(1.3f)]
        public void OnARibbon_EachBoneTurnsAsTheLeadingChainBesideIt(float length)
        {
            RestSkeleton rest = Rest(Chain(0f, 1f), Chain(-0.1f, length), Chain(-0.2f, 0.8f));
            float[] ribbon = FlapShares.Cumulative(rest, 0f), fan = FlapShares.Cumulative(rest, 1f),
                half = FlapShares.Cumulative(rest, 0.5f);
            const int steps = 4000;
            for (int bone = 4; bone < 8; bone++)
            {
                double sum = 0.0;
                for (int k = 0; k < steps; k++)
                {
                    double distance = length * 0.25 * (bone - 4 + (k + 0.5) / steps);
                    sum += Math.Min(Math.Floor(distance / 0.25), 3.0) / 3.0 / steps;
                }

                Assert.That(ribbon[bone], Is.EqualTo(sum).Within(1e-3), $"bone {bone}");
                Assert.That(fan[bone], Is.EqualTo((bone - 4) / 3f).Within(1e-6f), "evenly");
                Assert.That(half[bone], Is.EqualTo(0.5f * (ribbon[bone] + fan[bone])).Within(1e-6f));
            }
        }

        [Test]
        public void Veins_CountByTheCubeOfTheirWidth_FromATenthToTen()
        {
            WingSkeleton skeleton = Skeleton(Chain(0f, 1f), Chain(-0.2f, 1f), Chain(-0.4f, 1f), Chain(-0.6f, 1f));
            float[] Factors(params float[] widths)
            {
                for (int k = 0; k < 4; k++)
                    skeleton.Chains[k].veinWidths = float.IsNaN(widths[k]) ? null : new[] { widths[k] };
                float[] factors = VeinFactors.Of(skeleton, new RestSkeleton(skeleton, s_Frame), out bool areKnown);
                Assert.That(areKnown, Is.EqualTo(widths.Any(width => width > 0f)));
                return factors.Where((_, bone) => bone % 4 == 2).ToArray();
            }

            Assert.That(Factors(1f, 2f, 3f, 2f), Is.EqualTo(new[] { 0.125f, 1f, 3.375f, 1f }).Within(1e-5f), "of the mean of 2");
            Assert.That(Factors(1f, 3f, 0f, float.NaN), Is.EqualTo(new[] { 0.125f, 3.375f, 0.1f, 0.1f }).Within(1e-5f),
                "membrane has the least, and does not count in the mean");
            Assert.That(Factors(1f, 1f, 1f, 9f), Is.EqualTo(new[] { 0.1f, 0.1f, 0.1f, 10f }).Within(1e-5f));
            Assert.That(Factors(float.NaN, 0f, 0f, 0f), Is.EqualTo(new[] { 1f, 1f, 1f, 1f }));

            skeleton.Chains[0].veinWidths = new[] { 4f, 0f };
            float[] falling = VeinFactors.Of(skeleton, new RestSkeleton(skeleton, s_Frame), out _);
            Assert.That(falling[1] / falling[0], Is.EqualTo(27f / 64f).Within(1e-4f), "a quarter of the way from 4 to 0");
        }

        [Test]
        public void APatchAtThePointOfACell_CountsAsATwentiethOfItsMiddle()
        {
            // All chains leave one root: the cell at the root is a triangle.
            RestSkeleton rest = Rest(
                TestWings.Chain(Vector3.zero, new Vector3(1f, 0f, 0f), 5), TestWings.Chain(Vector3.zero, new Vector3(0.9f, 0f, -0.3f), 5),
                TestWings.Chain(Vector3.zero, new Vector3(0.7f, 0f, -0.6f), 5));
            SurfaceMesh surface = TestWings.Ellipse();
            float3[] points = Array.ConvertAll(surface.positions, position => (float3)position);
            var map = new CellMap(rest);
            var triangles = new SurfaceTriangles(points, surface.triangles);
            CellPoint[] located = map.Locate(triangles.centres.ToArray());
            var layout = new PatchLayout(rest, map, triangles, located, new SpanChords(points, triangles), 0);
            Assert.That(layout.cells[0].patchCount, Is.EqualTo(3));
            float[] shares = { 0f, 0.02f, 0.7f };
            for (int k = 0; k < 3; k++)
                (layout.u[k], layout.v[k]) = (0.3f, shares[k]);
            float[] measures = layout.Measures(rest);

            // |p_u × p_v| of a triangle grows evenly from its point: v times twice its area.
            double doubled = 0.0625 * 0.3;
            for (int k = 0; k < 3; k++)
                Assert.That(1f / measures[k], Is.EqualTo(doubled * Math.Max(shares[k], 0.025)).Within(0.01).Percent, $"at {shares[k]}");
        }

        [TestCase(0.95e-12f, 1)]
        [TestCase(1.05e-12f, 2)]
        public void ATriangle_CountsFromAMillionthOfAMillionth(float doubledArea, int count)
        {
            float3[] points = { 0f, new float3(1f, 0f, 0f), new float3(0f, 0f, 1f), new float3(0f, 0f, -doubledArea) };

            Assert.That(new SurfaceTriangles(points, new[] { 0, 1, 2, 0, 1, 3 }).Count, Is.EqualTo(count));
        }

        [Test]
        public void NormalsThatAreUnit_StayAsTheyAre_AndOthersBecomeSo()
        {
            SurfaceMesh surface = TestWings.Rectangle(1, 1);
            surface.normals = new[] { new Vector3(0f, 1.0000045f, 0f), new Vector3(0f, 1.0000053f, 0f), new Vector3(0.6e-6f, 0.9e-6f, 0f),
                new Vector3(0f, 0f, 0.9e-6f) };
            float3[] normals = SurfaceNormals.Make(surface, s_Frame);

            Assert.That(normals[0], Is.EqualTo((float3)surface.normals[0]));
            Assert.That(normals[1].y, Is.EqualTo(1f).Within(2e-7f));
            Assert.That(math.length(normals[2]), Is.EqualTo(1f).Within(1e-6f), "small, but with a direction");
            Assert.That(normals[3], Is.EqualTo(new float3(0f, 1f, 0f)), "too small: of the triangles");
        }

        [Test]
        public void TheLargerSize_HasRoomForBoth()
        {
            RigSize one = new RigSize { joints = 1, bones = 9, patches = 3, strips = 5, bandBlocks = 2 },
                other = new RigSize { joints = 4, bones = 2, patches = 8, strips = 6, bandBlocks = 1 };
            foreach (RigSize both in new[] { RigSize.Max(one, other), RigSize.Max(other, one) })
            {
                Assert.That((both.joints, both.bones, both.patches, both.strips, both.bandBlocks),
                    Is.EqualTo((4, 9, 8, 6, 2)));
            }
        }

        [Test]
        public void AFrame_TakesPlacesAndDirectionsThereAndBack([Values] bool mirrored)
        {
            float3 x = math.normalize(new float3(1f, 2f, -1f)), y = math.normalize(math.cross(new float3(0f, 0.3f, 1f), x)),
                z = math.cross(x, y);
            var frame = new WingFrame(new float3(3f, -4f, 5f), new float3x3(x, y, mirrored ? -z : z), 2.5f, mirrored);
            float3 p = new float3(0.7f, -0.2f, 0.4f), mesh = frame.ToMesh(p);

            Assert.That(math.distance(mesh, frame.origin + 2.5f * (p.x * x + p.y * y + (mirrored ? -p.z : p.z) * z)), Is.LessThan(1e-5f));
            Assert.That(math.distance(frame.ToWing(mesh), p), Is.LessThan(1e-5f));
            Assert.That(math.distance(frame.DirectionToMesh(p) * 2.5f + frame.origin, mesh), Is.LessThan(1e-5f));
            Assert.That(math.distance(frame.DirectionToWing(frame.DirectionToMesh(p)), p), Is.LessThan(1e-5f));
        }

        private static JointChain Chain(float z, float length) =>
            TestWings.Chain(new Vector3(0f, 0f, z), new Vector3(length, 0f, z), 5);

        private static RestSkeleton Rest(params JointChain[] chains) => new RestSkeleton(Skeleton(chains), s_Frame);

        private static WingSkeleton Skeleton(params JointChain[] chains) => TestWings.Skeleton(chains);
    }
}
