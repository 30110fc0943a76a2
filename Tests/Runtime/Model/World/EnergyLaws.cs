using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Laws of energy over random wings.</summary>
    public sealed unsafe class EnergyLaws
    {
        private const int k_FewSubsteps = 4;

        private WingRig m_Rig;

        [OneTimeSetUp]
        public void BakeRig() => m_Rig = Monarch.Rig();

        [OneTimeTearDown]
        public void ReleaseRig() => m_Rig.Release();

        [Test]
        public void ASpring_PullsItsTwoJointsEquallyAndOppositely()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                var spring = new List<Spring> { new Spring { a = 1, b = 2, length = random.NextFloat(0.01f, 1f) } };
                using (var springs = new SpringFixture(1, 3, spring, random.NextFloat(1f, 1e6f)))
                {
                    springs.scratch.positions[1] = new SoaFloat3(random.NextFloat3(-1f, 1f));
                    springs.scratch.positions[2] = new SoaFloat3(random.NextFloat3(-1f, 1f));
                    SpringEnergy.Linearise(springs.pack, springs.scratch, springs.scratch.positions, false);
                    float3 a = springs.scratch.gradient[1][0], b = springs.scratch.gradient[2][0];
                    float3 along = springs.scratch.positions[1][0] - springs.scratch.positions[2][0];
                    bool isStretched = math.length(along) > spring[0].length;
                    Assert.That(math.all(a == -b), Is.True, $"seed {seed}: {a} and {b}");
                    Assert.That(math.dot(a, along) > 0f, Is.EqualTo(isStretched), $"seed {seed}: {a} along {along}");
                }
            }
        }

        // Every substep of backward Euler dissipates. The second-order step measures energy over two substeps: it may rise in one, but not
        // over a few.
        [TestCase(TimeScheme.BackwardEuler, MembraneCoupling.OneWay, 1f)]
        [TestCase(TimeScheme.SecondOrder, MembraneCoupling.OneWay, 1.25f, Explicit = true, Category = "Long")]
        [TestCase(TimeScheme.SecondOrder, MembraneCoupling.TwoWay, 1.25f)]
        public void WithDriveAndAirOff_TheBendingEnergyNeverRises(TimeScheme scheme, MembraneCoupling coupling, float most)
        {
            foreach (uint seed in Seeds.Usual)
            {
                var flight = new RandomFlight(seed);
                using (PackFixture fixture = Still(flight.Parameters, scheme, coupling))
                {
                    for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
                    {
                        fixture.Pack.bendAngles[bone] = new SoaFloat3(flight.Random.NextFloat3(-0.4f, 0.4f));
                        fixture.Pack.bendRates[bone] = new SoaFloat3(flight.Random.NextFloat3(-30f, 30f));
                    }

                    float first = BendingEnergy(fixture), last = first;
                    for (int k = 0; k < 50; k++)
                    {
                        PackStep.Run(ref fixture.Pack, fixture.scratch, fixture.Substep);
                        float now = BendingEnergy(fixture);
                        if (now > most * last * 1.00001f + 1e-7f || now > first * 1.00001f)
                            Assert.Fail($"seed {seed}, substep {k}: {last} to {now}, {first} at first");
                        last = now;
                    }
                }
            }
        }

        [TestCase(TimeScheme.BackwardEuler, MembraneCoupling.OneWay, 1)]
        [TestCase(TimeScheme.SecondOrder, MembraneCoupling.OneWay, k_FewSubsteps, Explicit = true, Category = "Long")]
        [TestCase(TimeScheme.SecondOrder, MembraneCoupling.TwoWay, k_FewSubsteps)]
        public void WithDriveAndAirOff_TheElasticEnergyNeverRises(TimeScheme scheme, MembraneCoupling coupling, int over)
        {
            foreach (uint seed in Seeds.Usual)
            {
                var flight = new RandomFlight(seed);
                using (PackFixture fixture = Still(flight.Parameters, scheme, coupling))
                {
                    for (int joint = 0; joint < fixture.rig.JointCount; joint++)
                    {
                        if (joint % fixture.rig.JointsPerChain == 0)
                            continue;
                        fixture.Pack.offsets[joint] = new SoaFloat3(flight.Random.NextFloat3(-2e-3f, 2e-3f));
                        fixture.Pack.offsetRates[joint] = new SoaFloat3(flight.Random.NextFloat3(-0.3f, 0.3f));
                        fixture.Pack.pose[joint].position += fixture.Pack.offsets[joint];
                    }

                    var energies = new List<float> { ElasticEnergy(fixture) };
                    for (int k = 0; k < 50; k++)
                    {
                        PackStep.Run(ref fixture.Pack, fixture.scratch, fixture.Substep);
                        float now = ElasticEnergy(fixture), before = energies[math.max(energies.Count - over, 0)];
                        if (now > before + 1e-4f * energies[0])
                            Assert.Fail($"seed {seed}, substep {k}: {before} to {now} over {over} of {energies[0]}");
                        energies.Add(now);
                    }

                    Assert.That(energies[50], Is.LessThan(0.5f * energies[0]), $"seed {seed}");
                }
            }
        }

        private PackFixture Still(WingParameters parameters, TimeScheme scheme, MembraneCoupling coupling)
        {
            parameters.amplitude = float3.zero;
            parameters.airDensity = 0f;
            parameters.options.timeScheme = scheme;
            parameters.options.coupling = coupling;
            m_Rig.Retain();
            return new PackFixture(m_Rig, parameters);
        }

        private static float BendingEnergy(PackFixture fixture)
        {
            ref readonly LaneParameters p = ref *fixture.Pack.parameters;
            float energy = 0f;
            for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
            {
                float3 angle = fixture.Pack.bendAngles[bone][0], rate = fixture.Pack.bendRates[bone][0];
                float k = fixture.Pack.bendStiffness[bone].x;
                float dorsal = angle.x > 0f ? p.numbers.dorsalAsymmetry.x : 1f;
                energy += 0.5f * fixture.rig.View.jointInertias[bone] * math.lengthsq(rate);
                energy += 0.5f * k * (dorsal * angle.x * angle.x + p.numbers.inPlaneFactor.x * angle.y * angle.y
                    + p.numbers.torsionFactor.x * angle.z * angle.z);
            }

            return energy;
        }

        private static float ElasticEnergy(PackFixture fixture)
        {
            float anchor = fixture.Pack.parameters->anchorRate.x, energy = SpringEnergy.Elastic(fixture.Pack, fixture.Pack.pose, out _).x;
            for (int joint = 0; joint < fixture.rig.JointCount; joint++)
            {
                float mass = fixture.rig.JointMasses[joint];
                energy += 0.5f * mass * (anchor * anchor * math.lengthsq(fixture.Pack.offsets[joint][0])
                    + math.lengthsq(fixture.Pack.offsetRates[joint][0]));
            }

            return energy;
        }
    }
}
