using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Delays of chains over random fans, strokes and delays: broad and narrow, with tips that nearly meet.</summary>
    public sealed unsafe class ChainDelayLaws
    {
        private const double k_LargestSlope = 0.65;

        [Test]
        public void Delays_RiseFromTheLeadingToTheTrailingEdge_AndStripsBearThem()
        {
            int limited = 0, kept = 0;
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                WingParameters p = Monarch.Parameters;
                p.amplitude.x = random.NextFloat(0.05f, 1.5f);
                p.chordDelay = random.NextFloat(0f, 1f) * random.NextFloat(0f, 1f);
                using var fixture = new PackFixture(Rig(ref random), p);
                int strips = fixture.rig.ChainCount - 1;
                float4* delays = fixture.Pack.chainDelays;
                double whole = Math.PI * p.chordDelay, room = 0.0, fan = 0.0;
                for (int i = 0; i < strips; i++)
                    fan += fixture.rig.View.fanWidths[i];
                double spread = Math.Pow(Math.Min(fan / 0.4, 1.0), 2.0);
                for (int i = 0; i < strips; i++)
                    room += Strip(fixture, p, i, spread).Most;
                double beyond = 1.0 + 0.5 * Math.Log(Math.Max(whole / room, 1.0));
                bool isNarrow = false;
                for (int i = 0; i < strips; i++)
                {
                    (double wanted, double most) = Strip(fixture, p, i, spread);
                    double step = delays[i + 1].x - delays[i].x;
                    isNarrow |= most < wanted;
                    if (step < -1e-6)
                        Assert.Fail($"seed {seed}: chain {i + 1} is before chain {i} by {-step}");
                    if (step > most * beyond + 1e-5)
                        Assert.Fail($"seed {seed}: strip {i} bears {most}, not {step}");
                    if (step < Math.Min(wanted, most) - 1e-5)
                        Assert.Fail($"seed {seed}: strip {i} bears {most}, is wanted to have {wanted}, has {step}");
                }

                limited += isNarrow ? 1 : 0;
                kept += isNarrow && room > whole ? 1 : 0;
                double expected = Math.Min(whole, room) * beyond;
                Assert.That(delays[strips].x, Is.EqualTo(expected).Within(1e-4 * (1.0 + whole)), $"delay in all, seed {seed}");
            }
            Assert.That(limited, Is.GreaterThan(10), "wings with a strip that is too narrow");
            Assert.That(kept, Is.GreaterThan(3), "of these, wings with room elsewhere");
        }

        [Test]
        public void WidthOfAStrip_IsItsNarrowestByTheDistanceFromTheRoot()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                using var fixture = new PackFixture(Rig(ref random), Monarch.Parameters);
                for (int i = 0; i + 1 < fixture.rig.ChainCount; i++)
                {
                    float stored = fixture.rig.View.fanWidths[i];
                    double narrowest = Math.Min(Narrowest(fixture.rig, i, i + 1), Narrowest(fixture.rig, i + 1, i));
                    if (Math.Abs(stored - narrowest) > 1e-3 * narrowest && !(double.IsInfinity(narrowest) && float.IsInfinity(stored)))
                        Assert.Fail($"seed {seed}, strip {i}: {stored}, not {narrowest}");
                }
            }
        }

        // Over the joints of a straight chain that stand square to the other one.
        private static double Narrowest(WingRig rig, int chain, int other)
        {
            int m = rig.JointsPerChain;
            float3 root = rig.RestJoints[chain * m], from = rig.RestJoints[other * m], to = rig.RestJoints[other * m + m - 1];
            double narrowest = double.PositiveInfinity, length = math.distance(from, to);
            for (int j = 1; j < m; j++)
            {
                float3 joint = rig.RestJoints[chain * m + j];
                double along = math.dot(joint - from, to - from) / length;
                if (along <= 0.0 || along > length * (1.0 + 0.1 / (m - 1)))
                    continue;
                float3 foot = math.lerp(from, to, (float)Math.Min(along / length, 1.0));
                narrowest = Math.Min(narrowest, Math.Max(math.distance(joint, foot), 2e-3) / math.distance(joint, root));
            }

            return narrowest;
        }

        // The delay that a strip is wanted to have by Eq. 2, and the most that it bears; as much as is wanted where no joint has a foot on
        // the other chain.
        private static (double Wanted, double Most) Strip(PackFixture fixture, in WingParameters p, int strip, double spread)
        {
            float* ratio = fixture.rig.View.chainRatio;
            float width = fixture.rig.View.fanWidths[strip];
            double wanted = Math.PI * p.chordDelay * (ratio[strip + 1] - ratio[strip]);
            return (wanted, float.IsInfinity(width) ? wanted : k_LargestSlope * spread * width / p.amplitude.x);
        }

        private static WingRig Rig(ref Random random)
        {
            int chains = random.NextInt(3, 9), joints = random.NextInt(3, 9);
            float chord = random.NextFloat(0.2f, 1f), last = random.NextFloat(0.3f, 1.4f), rootShare = random.NextFloat(0.1f, 0.6f);
            var made = new JointChain[chains];
            float share = 0f, sum = 0f;
            float[] gaps = new float[chains];
            for (int i = 1; i < chains; i++)
                sum += gaps[i] = random.NextFloat(0.1f, 1f);
            for (int i = 0; i < chains; i++)
            {
                share += gaps[i] / sum;
                var root = new Vector3(0f, 0f, -rootShare * chord * i / (chains - 1f));
                var tip = new Vector3(math.cos(last * share), 0f, -chord * math.sin(last * share) - 0.02f * i);
                made[i] = TestWings.Chain(root, tip, joints);
            }

            return TestWings.Bake(TestWings.Skeleton(made), TestWings.Ellipse(12, 6, 1f, chord * math.max(math.sin(last), rootShare)), 64);
        }
    }
}
