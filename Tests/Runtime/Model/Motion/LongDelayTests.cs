using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Waves with the largest delays there are, which reach back into the third cycle before.</summary>
    public sealed unsafe class LongDelayTests
    {
        private const float k_Substeps = 500f;

        [TestCase(1e-3f)]
        [TestCase(0.5f)]
        [TestCase(0f)]
        [TestCase(-1e-3f)]
        public void AfterFiveCycles_AnglesAreThoseOfTheDelayedCosine(float phaseLead)
        {
            WingParameters p = Parameters(phaseLead, MembraneCoupling.OneWay);
            using (var fixture = new PackFixture(Monarch.Rig(16), p))
            {
                float dt = 1f / (k_Substeps * fixture.Pack.beat->frequency.x);
                for (int k = 0; k < 5 * k_Substeps + 10; k++)
                    Advance(fixture, dt);
                for (int k = 0; k < k_Substeps; k += 7)
                {
                    for (int more = 0; more < 7; more++)
                        Advance(fixture, dt);
                    for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
                    {
                        Assert.That(math.distance(fixture.scratch.angle[bone][0], Settled(fixture, p, bone)), Is.LessThan(2e-4f),
                            $"bone {bone}, substep {k}");
                    }
                }
            }
        }

        [TestCase(1e-3f, MembraneCoupling.OneWay)]
        [TestCase(1e-3f, MembraneCoupling.TwoWay)]
        [TestCase(3f, MembraneCoupling.OneWay)]
        public void Angles_NeverJump_AlsoWhileTheStrokeChanges(float phaseLead, MembraneCoupling coupling)
        {
            WingParameters p = Parameters(phaseLead, coupling);
            p.amplitudeFloor = 0.2f;
            using (var fixture = new PackFixture(Monarch.Rig(16), p))
            {
                // From cycle to cycle the body flies, hovers and flies again, so that the amplitude goes up and down.
                float3 most = 2f * math.PI / k_Substeps * 1.6f * p.amplitude;
                var last = new float3[fixture.rig.BoneCount];
                float dt = 1f / (k_Substeps * p.maxFrequency);
                for (int k = 0; k < 9 * k_Substeps; k++)
                {
                    fixture.Pack.surroundings->speed = (int)(k / k_Substeps) % 2 == 0 ? 2f : 0f;
                    Advance(fixture, dt);
                    for (int bone = 0; bone < last.Length; bone++)
                    {
                        float3 angle = fixture.scratch.angle[bone][0];
                        if (k > 0)
                        {
                            Assert.That(
                                math.all(math.abs(angle - last[bone]) <= most), $"substep {k}, bone {bone}: {last[bone]} to {angle}");
                        }
                        last[bone] = angle;
                    }
                }
            }
        }

        private static WingParameters Parameters(float phaseLead, MembraneCoupling coupling)
        {
            WingParameters p = Monarch.Parameters;
            p.chordDelay = p.spanDelay = 2f;
            p.phaseLead = phaseLead;
            p.options.coupling = coupling;
            return p;
        }

        // Σ w_l A cos(Φ + lead − λπρ − μπσ_l + φ) on the way from the root, with the mean flap.
        private static float3 Settled(PackFixture fixture, in WingParameters p, int bone)
        {
            int bonesPerChain = fixture.rig.JointsPerChain - 1, chain = bone / bonesPerChain;
            float4 clock = fixture.Pack.beat->phase;
            float3 amplitude = fixture.Pack.beat->amplitude[0];
            double root = fixture.rig.View.chainRatio[chain];
            var angle = new float3(p.meanFlap, 0f, 0f);
            for (int l = 0; l <= bone % bonesPerChain; l++)
            {
                double share = l == 0 ? p.rootShare : (1.0 - p.rootShare) / (bonesPerChain - 1);
                double phase = clock.x + p.phaseLead - Math.PI * (p.chordDelay * root + p.spanDelay * l / bonesPerChain);
                for (int axis = 0; axis < 3; axis++)
                    angle[axis] += (float)(share * amplitude[axis] * Math.Cos(phase + p.phase[axis]));
            }

            return angle;
        }

        private static void Advance(PackFixture fixture, float dt)
        {
            BeatClock.Advance(ref *fixture.Pack.beat, *fixture.Pack.parameters, *fixture.Pack.surroundings, CycleChange.Smooth, dt);
            DelayedWaves.Evaluate(fixture.Pack, fixture.scratch);
        }
    }
}
