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

        // The count of a commanded wing goes by the highest beat that a controller may ask for, 1.3 times that of the preset.
        [Test]
        public void ACommandedWing_TakesAsMany_WhateverItIsCommanded([Values(5f, 9f)] float frequency)
        {
            WingParameters parameters = Monarch.Parameters;
            using (var fixture = new PackFixture(Monarch.Rig(16), parameters))
            {
                fixture.Pack.beat->frequency = fixture.Pack.beat->previousFrequency = frequency;
                for (int lane = 0; lane < WingPack.Lanes; lane++)
                    fixture.Pack.parameters->drive.Set(lane, new WingDrive { frequency = frequency, amplitude = 1f }, true);
                float count = k_Frame * 1.3f * parameters.maxFrequency * parameters.substepsPerBeat;
                Assert.That(Count(fixture), Is.EqualTo((int)math.ceil(count)));
            }
        }

        [TestCase(WingDetail.Full, 30, 30)]
        [TestCase(WingDetail.FewerSubsteps, 30, 15)]
        [TestCase(WingDetail.CoarsePatches, 40, 20)]
        [TestCase(WingDetail.WavesOnly, 20, 12)]
        public void LessDetail_TakesHalfAsMany_ButTwelveABeatAtLeast(WingDetail detail, int perBeat, int count)
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.substepsPerBeat = perBeat;
            using (var fixture = new PackFixture(Monarch.Rig(16), parameters))
            {
                fixture.Pack.detail = detail;
                fixture.Pack.beat->frequency = 10f;
                fixture.Pack.beat->previousFrequency = 9f;
                float4 beat = 0.1f, more = 0.1f * (1f + 0.0009f / count), most = 0.1f * (1f + 0.0012f / count);
                Assert.That((int)PackStep.SubstepCounts(fixture.Pack, ref beat).y, Is.EqualTo(count));
                Assert.That((int)PackStep.SubstepCounts(fixture.Pack, ref more).y, Is.EqualTo(count), "a thousandth is rounding");
                Assert.That((int)PackStep.SubstepCounts(fixture.Pack, ref most).y, Is.EqualTo(count + 1));
            }
        }

        // With fewer than those that its trims were found with an insect that brakes tumbles.
        [TestCase(WingDetail.FewerSubsteps, 40)]
        [TestCase(WingDetail.CoarsePatches, 40)]
        [TestCase(WingDetail.WavesOnly, 20)]
        public void ACommandedWing_TakesAllOfThem_UntilItMeetsNoAir(WingDetail detail, int perBeat)
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.substepsPerBeat = 40;
            using (var fixture = new PackFixture(Monarch.Rig(16), parameters))
            {
                fixture.Pack.detail = detail;
                float4 beat = 1f / (1.3f * parameters.maxFrequency);
                fixture.Pack.parameters->drive.Set(1, new WingDrive { frequency = 5f, amplitude = 1f }, true);
                fixture.Pack.beat->frequency = fixture.Pack.beat->previousFrequency = 0.65f * parameters.maxFrequency;
                float4 counts = PackStep.SubstepCounts(fixture.Pack, ref beat);
                Assert.That((int)counts.y, Is.EqualTo(perBeat), "commanded");
                Assert.That((int)counts.x, Is.EqualTo(10), "beside it");
            }
        }

        // Subnormal numbers cost a hundred times as much; an exponential fading ends in them after twenty beats.
        [Test]
        public void AWingOfWavesAlone_IsUnbentInTheEnd_AndHasNoSubnormalNumbers()
        {
            using (var fixture = new PackFixture(Monarch.Rig(16), Monarch.Parameters))
            {
                ref WingPack pack = ref fixture.Pack;
                float frequency = pack.beat->frequency.x;
                pack.bendAngles[3] = Lanes.All(0.2f, -0.1f, 0.05f);
                pack.offsets[6] = Lanes.All(0.01f, 0.02f, -0.02f);
                for (int step = 0; step < 30 * 12; step++)
                {
                    PackStep.WavesSubstep(pack, fixture.scratch, 1f / (12f * frequency));
                    for (int k = 0; k < 4 * pack.stateCount; k++)
                        Assert.That(((float*)pack.state)[k] == 0f || math.abs(((float*)pack.state)[k]) >= 1.17549435e-38f, $"step {step}");
                }

                Assert.That(math.length(pack.bendAngles[3][1]) + math.length(pack.offsets[6][1]), Is.Zero);
            }
        }

        // Far away the bend of a wing that is only waved fades by exp(−4) a beat.
        [Test]
        public void AWingOfWavesAlone_LosesItsBendInABeat()
        {
            using (var fixture = new PackFixture(Monarch.Rig(16), Monarch.Parameters))
            {
                ref WingPack pack = ref fixture.Pack;
                float frequency = pack.beat->frequency.x;
                pack.bendAngles[3] = Lanes.All(0.2f, -0.1f, 0.05f);
                pack.offsets[6] = Lanes.All(0.01f, 0.02f, -0.02f);
                float offset = math.length(pack.offsets[6][2]);
                for (int step = 0; step < 5; step++)
                    PackStep.WavesSubstep(pack, fixture.scratch, 0.2f / frequency);
                float left = math.exp(-4f);
                Assert.That(math.distance(pack.bendAngles[3][1], left * new float3(0.2f, -0.1f, 0.05f)), Is.LessThan(1e-5f));
                Assert.That(math.length(pack.offsets[6][2]), Is.EqualTo(left * offset).Within(1e-6f), "turned with the wing, and as short");
                Assert.That(math.length(pack.bendRates[3][1]) + math.length(pack.offsetRates[6][1]), Is.Zero);
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
