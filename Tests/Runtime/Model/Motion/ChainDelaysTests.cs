using Alate.Catalogue;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Delay of the drive's wave at each chain: by Eq. 2 where the strips between chains are wide enough for it.</summary>
    public sealed unsafe class ChainDelaysTests
    {
        private const float k_LargestSlope = 0.65f;

        [TestCase(0.1f)]
        [TestCase(1f)]
        [TestCase(2f)]
        public void WithoutCoupling_DelaysAreThoseOfEquation2(float chordDelay)
        {
            foreach (InsectDefinition species in InsectCatalogue.All)
            {
                WingParameters parameters = species.Wings[0].CreatePreset().ToParameters();
                parameters.chordDelay = chordDelay;
                parameters.options.coupling = MembraneCoupling.OneWay;
                using (PackFixture fixture = Fixture(species.Wings[0], parameters))
                    AssertEquation2(fixture, chordDelay, species.Name);
            }
        }

        [Test]
        public void OfASmallStroke_DelaysAreThoseOfEquation2()
        {
            foreach (InsectDefinition species in InsectCatalogue.All)
            {
                WingParameters parameters = species.Wings[0].CreatePreset().ToParameters();
                parameters.amplitude.x = 0.05f;
                using (PackFixture fixture = Fixture(species.Wings[0], parameters))
                    AssertEquation2(fixture, parameters.chordDelay, species.Name);
            }
        }

        [Test]
        public void Steering_ChangesNoDelay()
        {
            WingParameters parameters = Monarch.Parameters, steered = parameters;
            parameters.chordDelay = 0.5f;
            steered.chordDelay = 0.5f;
            steered.amplitudeScale = 0.1f;
            using (PackFixture fixture = new PackFixture(Monarch.Rig(64), parameters), other = new PackFixture(Monarch.Rig(64), steered))
            {
                for (int chain = 0; chain < fixture.rig.ChainCount; chain++)
                    Assert.That(other.Pack.chainDelays[chain], Is.EqualTo(fixture.Pack.chainDelays[chain]), $"chain {chain}");
            }
        }

        [Test]
        public void ParallelChains_HaveNoMoreDelayThanTheirStripsBear()
        {
            // Four strips an eighth of a wing length wide: chains apart by δ of a flap A are apart by A δ at their tips.
            WingParameters parameters = Monarch.Parameters;
            float most = k_LargestSlope * 0.125f / parameters.amplitude.x;
            foreach (float share in new[] { 0.5f, 0.99f, 2f, 10f })
            {
                parameters.chordDelay = 4f * most * share / math.PI;
                using (var fixture = new PackFixture(TestWings.Bake(TestWings.Lattice(), TestWings.Rectangle(), 64), parameters))
                {
                    for (int chain = 1; chain < 5; chain++)
                    {
                        Assert.That(fixture.Pack.chainDelays[chain].x, Is.EqualTo(chain * most * Borne(share)).Within(1e-4f * Borne(share)),
                            $"{share}, chain {chain}");
                    }
                }
            }
        }

        // Of what no strip has room for, half of the logarithm counts: a longer delay always twists the wing more.
        private static float Borne(float share) => math.min(share, 1f) * (1f + 0.5f * math.log(math.max(share, 1f)));

        [Test]
        public void WhatANarrowStripCannotBear_GoesToTheWideOnes()
        {
            // Tips of the first two chains nearly meet; their roots are as far apart as those of the others.
            WingSkeleton skeleton = TestWings.Lattice(5, 5, 1f, 0.8f);
            skeleton.Chains[1] = TestWings.Chain(skeleton.GetJoint(1, 0), skeleton.GetJoint(0, 4) + 0.02f * UnityEngine.Vector3.back, 5);
            WingParameters parameters = Monarch.Parameters;
            parameters.chordDelay = 0.1f;
            using (var fixture = new PackFixture(TestWings.Bake(skeleton, TestWings.Rectangle(12, 6, 1f, 0.8f), 64), parameters))
            {
                float4* delays = fixture.Pack.chainDelays;
                float even = 0.1f * math.PI / 4f, narrow = k_LargestSlope * 0.02f / parameters.amplitude.x;
                Assert.That(narrow, Is.LessThan(0.5f * even));
                Assert.That(delays[1].x, Is.EqualTo(narrow).Within(0.02f * narrow));
                Assert.That(delays[4].x, Is.EqualTo(0.1f * math.PI).Within(1e-5f), "the whole delay");
                for (int chain = 1; chain < 4; chain++)
                    Assert.That(delays[chain + 1].x - delays[chain].x, Is.GreaterThan(even), $"strip {chain}");
            }
        }

        [Test]
        public void WithoutDelay_NoChainWaits()
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.chordDelay = 0f;
            using (var fixture = new PackFixture(Monarch.Rig(64), parameters))
            {
                for (int chain = 0; chain < fixture.rig.ChainCount; chain++)
                    Assert.That(fixture.Pack.chainDelays[chain], Is.EqualTo(float4.zero));
            }
        }

        private static PackFixture Fixture(WingDefinition wing, in WingParameters parameters)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            return new PackFixture(TestWings.Bake(wing.CreateSkeleton(WingSide.Right), surface, 64), parameters);
        }

        private static void AssertEquation2(PackFixture fixture, float chordDelay, string species)
        {
            float3 first = fixture.rig.RestJoints[0];
            int joints = fixture.rig.JointsPerChain, last = (fixture.rig.ChainCount - 1) * joints;
            float whole = math.distance(fixture.rig.RestJoints[last], first);
            for (int chain = 0; chain < fixture.rig.ChainCount; chain++)
            {
                float ratio = math.distance(fixture.rig.RestJoints[chain * joints], first) / whole;
                Assert.That(
                    fixture.Pack.chainDelays[chain].x, Is.EqualTo(chordDelay * math.PI * ratio).Within(2e-5f), $"{species}, chain {chain}");
            }
        }
    }
}
