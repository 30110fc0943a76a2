using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Wind as a wing feels it, by multiples of the strongest that bends it.</summary>
    public sealed unsafe class StrongestWindTests
    {
        private static readonly float3[] s_Directions =
        {
            new float3(0f, 0f, -1f), new float3(1f, 0f, 0f), math.normalize(new float3(-1f, 2f, -3f)),
            math.normalize(new float3(5f, -1f, 0.2f)),
        };

        private PackFixture m_Fixture;

        [SetUp]
        public void SetUp() => m_Fixture = new PackFixture(Monarch.Rig(16), Monarch.Parameters);

        [TearDown]
        public void TearDown() => m_Fixture.Dispose();

        [Test]
        public void TheStrongestWind_IsMeasuredByTheTip_OfAWingThatFliesAtItsTopSpeed()
        {
            WingParameters p = Monarch.Parameters;
            double tip = 2.0 * Math.PI * p.referenceFrequency * p.amplitude.x;

            Assert.That(Strongest, Is.EqualTo(0.65 * tip).Within(1e-4 * tip));
            Assert.That(Strongest * Monarch.Length, Is.EqualTo(3.15).Within(0.05), "metres a second, for a monarch");
        }

        [Test]
        public void BelowThreeQuarters_EveryWindIsFeltAsItIs()
        {
            foreach (float3 direction in s_Directions)
            {
                for (float share = 0.01f; share < 0.78f; share += 0.076f)
                {
                    float3 wind = direction * (share * Strongest);
                    Assert.That(
                        math.distance(Felt(wind), wind), Is.LessThan(1e-3f * math.length(wind)), $"{share} of the strongest, {direction}");
                }
            }
        }

        [Test]
        public void EveryWind_KeepsItsDirection()
        {
            foreach (float3 direction in s_Directions)
            {
                for (float share = 0.5f; share < 1e4f; share *= 1.7f)
                {
                    float3 felt = Felt(direction * (share * Strongest));
                    Assert.That(math.dot(felt, direction), Is.EqualTo(math.length(felt)).Within(1e-5f * math.length(felt)),
                        $"{share} of the strongest");
                }
            }
        }

        [Test]
        public void WithoutCoupling_EveryWindIsFeltAsItIs()
        {
            m_Fixture.Pack.options.coupling = MembraneCoupling.OneWay;
            float3 gale = s_Directions[2] * (10f * Strongest);
            Assert.That(Felt(gale), Is.EqualTo(gale));
        }

        [Test]
        public void MoreWind_IsAlwaysFeltAsMore_ButNeverAsMoreThanItIs()
        {
            float last = 0f;
            for (float share = 0.1f; share < 1e6f; share *= 1.05f)
            {
                float felt = Speed(share);
                Assert.That(felt, Is.GreaterThan(last), $"{share} of the strongest");
                Assert.That(felt, Is.LessThanOrEqualTo(share * Strongest * 1.00001f));
                last = felt;
            }
        }

        [Test]
        public void FarBeyond_WindIsFeltAsItsFourthRoot()
        {
            for (double share = 10.0; share < 99.0; share *= 1.5)
            {
                double slope = Math.Log(Speed((float)(1.1 * share)) / (double)Speed((float)share)) / Math.Log(1.1);
                Assert.That(slope, Is.EqualTo(0.25).Within(0.01), $"{share} of the strongest");
            }

            Assert.That(Speed(16f), Is.EqualTo(2f * Strongest).Within(0.01f * Strongest));
        }

        [TestCase(1e10f)]
        [TestCase(1e18f)]
        [TestCase(1e30f)]
        public void AStorm_IsFinite(float speed)
        {
            float3 felt = Felt(new float3(0f, 0f, -speed));

            Assert.That(math.all(math.isfinite(felt)), $"{felt}");
            Assert.That(-felt.z, Is.GreaterThan(Strongest));
        }

        [Test]
        public void StillAir_IsStill()
        {
            Assert.That(Felt(float3.zero), Is.EqualTo(float3.zero));
        }

        [Test]
        public void TheSubsteps_FollowTheWindThatIsFelt()
        {
            foreach (float share in new[] { 0.3f, 3f, 30f })
            {
                float3 felt = Felt(new float3(0f, share * Strongest, 0f));
                Assert.That(StrongestWind.Speed(m_Fixture.Pack).x, Is.EqualTo(math.length(felt)).Within(1e-5f * math.length(felt)));
            }
        }

        private float Strongest => m_Fixture.Pack.parameters->strongestWind.x;

        private float Speed(float share) => math.length(Felt(new float3(0f, 0f, -share * Strongest)));

        private float3 Felt(float3 wind)
        {
            m_Fixture.Pack.surroundings->wind = new SoaFloat3(wind);
            StrongestWind.Derive(m_Fixture.Pack);
            return m_Fixture.Pack.surroundings->boundWind[0];
        }
    }
}
