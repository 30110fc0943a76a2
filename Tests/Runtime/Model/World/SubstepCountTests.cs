using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Number of substeps of a step: enough for the beat, and for the air that the wing meets.</summary>
    public sealed unsafe class SubstepCountTests
    {
        private const float k_Frame = 0.02f;

        [Test]
        public void InStillAir_TheBeatDecides()
        {
            using (var fixture = new PackFixture(Monarch.Rig(16), Monarch.Parameters))
            {
                Assert.That(Count(fixture),
                    Is.EqualTo((int)math.ceil(k_Frame * fixture.Pack.beat->frequency.x * Monarch.Parameters.substepsPerBeat)));
            }
        }

        [Test]
        public void InAGale_TheAirDecides_ButNotForWavesAlone()
        {
            using (PackFixture calm = new PackFixture(Monarch.Rig(16), Monarch.Parameters),
                windy = new PackFixture(Monarch.Rig(16), Monarch.Parameters, Gale))
            {
                Assert.That(Count(windy), Is.GreaterThan(Count(calm)));
                windy.Pack.detail = WingDetail.WavesOnly;
                calm.Pack.detail = WingDetail.WavesOnly;
                Assert.That(Count(windy), Is.LessThanOrEqualTo(Count(calm) + 1));
            }
        }

        [Test]
        public void ABodyThatSpins_CountsAsWind()
        {
            var spinning = new WingSurroundings { angularVelocity = new float3(0f, 0f, 100f), hinge = new float3(0.5f, 0f, 0f) };
            using (var fixture = new PackFixture(Monarch.Rig(16), Monarch.Parameters, spinning))
                Assert.That(Count(fixture), Is.EqualTo(5), "tips that move 1.5 L at 100 rad/s pass 3 L in 0.02 s, 0.6 L a substep");
        }

        [Test]
        public void AWingThatHardlyBeats_TakesAsManyInAGale()
        {
            WingParameters resting = Monarch.Parameters;
            resting.frequencyFloor = 0f;
            WingSurroundings gale = Gale;
            gale.speed = 0f;
            using (PackFixture slow = new PackFixture(Monarch.Rig(16), resting, gale),
                fast = new PackFixture(Monarch.Rig(16), Monarch.Parameters, gale))
            {
                Assert.That(Count(slow), Is.EqualTo(Count(fast)).Within(1));
            }
        }

        private static WingSurroundings Gale => new WingSurroundings { wind = new float3(0f, 0f, -5000f), speed = 1f };

        private static int Count(PackFixture fixture)
        {
            float4 dt = k_Frame;
            return (int)PackStep.SubstepCounts(fixture.Pack, ref dt).x;
        }
    }
}
